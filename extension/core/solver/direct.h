// SPDX-License-Identifier: MIT
// METHOD_DIRECT over time: one implicit step of a chain, of second order if nothing is near. Twin of shaders/solver/direct.inc
// and shaders/solver/plan.inc.
#pragma once

#include "core/solver/free.h"
#include "core/solver/near.h"

namespace grass {

// [Eq 36] Returns the share of a speed that is left after rubbing.
template <class T> GRASS_INLINE T rubbed(const T &p_seconds) {
	return T(1.0f) / (T(1.0f) + T(RUB) * p_seconds);
}

// [Eq 32] Knocks a blade out of a collider if it is too deep inside for a linear model: the deepest correction bends the blade as that of
// METHOD_PBD does, and its inertia follows.
template <class T, class Mask>
GRASS_INLINE void take_blows(
		Blade<T> &r_blade, const StepTerms<T> &p_terms, const Start<T> &p_start, Stage<T> &r_stage, const Mask &p_is_hit) {
	// Measured below the skin, as the solve's depth is: no contact may count as a blow there and be missed here.
	const T deep = r_stage.most_depth - r_blade.blade_length * T(2.0f * SKIN / float(GRASS_SEGMENTS));
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		r_blade.before[k] = p_start.place[k];
	}
	for (int round = 0; round < BLOWS; round++) {
		DeepestCorrection<T> deepest = find_deepest_correction(r_blade, p_terms);
		const auto is_blow = p_is_hit & (deepest.correction.depth > deep);
		if (!any(is_blow)) {
			return;
		}
		deepest.correction.depth = select(is_blow, deepest.correction.depth, T(0.0f));
		bend(r_blade, deepest);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_stage.target[k] = select(is_blow, r_blade.knots[k], r_stage.target[k]);
		}
	}
}

// [Eq 36] The blades that may stick in a step, and those that do.
template <class Mask> struct Hold {
	Mask may_stick; // slow and near something
	Mask may_be_held; // slower ones, near nothing that moves
	Mask sticks; // it stays where it was at the start of the step
	Mask is_held; // it sticks, and nothing may push it either
};

// [Eq 36] Runs after the first solve of slow blades. Blades that touch nothing get back the speed that rubbing took. Blades that touch
// something and stick return to where they were. p_is_slow: those of r_hold.may_stick that nothing has hit.
template <class T, class Mask>
GRASS_INLINE void hold(Blade<T> &r_blade, const StepTerms<T> &p_terms, const Start<T> &p_start, Stage<T> &r_stage, const Mask &p_is_slow,
		const Mask &p_touches, const Touches<T> &p_found, Hold<Mask> &r_hold) {
	const Mask is_free = p_is_slow & !p_touches;
	const T lost = T(RUB) * r_stage.span; // share of the speed that is left
	const Vec3<T> load = p_terms.load * (r_stage.span * r_stage.span / r_stage.weight);
	T farthest(0.0f), forced(0.0f); // squared, square metres
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> moved = r_blade.knots[k] - p_start.place[k];
		const Vec3<T> carried = r_stage.target[k] - p_start.place[k] - load;
		const Vec3<T> changed = moved - carried;
		farthest = maximum(farthest, dot(moved, moved));
		forced = maximum(forced, dot(changed, changed));
		r_stage.target[k] = select(is_free, r_stage.target[k] + carried * lost, r_stage.target[k]);
	}
	const T limit = r_blade.blade_length * minimum(T(STICK), T(STICK_FORCE) * p_terms.wild_move * p_terms.wild_move);
	const T force = r_blade.blade_length * (T(HOLD_FORCE) * p_terms.wild_move * p_terms.wild_move);
	const T mass = r_stage.weight * mean_section(p_terms.thins); // of a mean knot
	const T grip = minimum(p_found.grip * (T(1.0f / float(GRASS_FREE_KNOTS)) / mass), force);
	const Mask is_held = r_hold.may_be_held & (forced < grip * grip) & (p_found.deepest < T(INSIDE));
	r_hold.sticks = p_is_slow & p_touches & ((farthest < limit * limit) | is_held);
	r_hold.is_held = r_hold.sticks & is_held;
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		r_blade.knots[k] = select(r_hold.sticks, p_start.place[k], r_blade.knots[k]);
		r_blade.twist[k - 1] = select(r_hold.sticks, p_start.twist[k - 1], r_blade.twist[k - 1]);
	}
}

// Returns the blades that take part in the i-th solve of a step: those near something take `iterations` solves, others one.
template <class T, class Mask> GRASS_INLINE Mask wants_solve(const StepTerms<T> &p_terms, int p_i, const Mask &p_is_near) {
	const Mask is_first = T(float(p_i)) < T(1.0f);
	return p_i < p_terms.iterations ? p_is_near | is_first : (!p_is_near) & is_first;
}

// [Eq 30] Performs the solves of a step, or of a part of it, for the blades in p_takes_part. Blades that are hit, according to the first
// solve, continue from the blow with at least one more solve.
template <class T, class Mask>
GRASS_INLINE void solve_stage(Blade<T> &r_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Start<T> &p_start,
		Stage<T> &r_stage, const Mask &p_takes_part, const Mask &p_is_near, Hold<Mask> &r_hold) {
	const Mask none = p_is_near & !p_is_near;
	Vec3<T> guess[GRASS_KNOTS];
	T twist[GRASS_SEGMENTS];
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		guess[k] = r_blade.knots[k];
		twist[k - 1] = r_blade.twist[k - 1];
	}
	Mask is_hit = none;
	r_hold.sticks = r_hold.is_held = none;
	for (int i = 0;; i++) {
		const Mask by_count = p_takes_part & wants_solve(p_terms, i, p_is_near);
		const Mask is_active = is_hit | (by_count & !r_hold.sticks);
		if (!any(is_active)) {
			return;
		}
		r_stage.is_guess = r_stage.is_part && i == 0;
		const Touches<T> found = solve_chain(r_blade, p_terms, p_chain, r_stage, is_active);
		const Mask touches = is_active & p_is_near & (found.depth > T(0.0f));
		const Mask is_blow = is_active & p_is_near & (found.blow > T(0.0f));
		is_hit = none;
		if (i > 0) {
			continue;
		}
		const Mask is_slow = r_hold.may_stick & !is_blow;
		if (any(is_slow)) {
			hold(r_blade, p_terms, p_start, r_stage, is_slow, touches, found, r_hold);
		}
		if (!any(is_blow)) {
			continue;
		}
		is_hit = is_blow;
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_blade.knots[k] = select(is_hit, guess[k], r_blade.knots[k]);
			r_blade.twist[k - 1] = select(is_hit, twist[k - 1], r_blade.twist[k - 1]);
		}
		take_blows(r_blade, p_terms, p_start, r_stage, is_hit);
	}
}

// [Eq 24] Sets the targets and the first guess of the part of the step that starts at the present knots. p_most_move: the farthest that
// their speed may carry them in a part, metres; p_share: of the step.
template <class T>
GRASS_INLINE void begin_part(Blade<T> &r_blade, const Start<T> &p_start, const Vec3<T> &p_load, const T &p_most_move, const T &p_share,
		bool p_is_first, Start<T> &r_part, Stage<T> &r_stage) {
	const T per_weight = T(1.0f) / r_stage.weight;
	const Vec3<T> load = p_load * (r_stage.span * r_stage.span);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> moved = r_blade.knots[k] - r_part.place[k];
		const T keep = minimum(T(1.0f), p_most_move / maximum(length(moved), T(1e-12f)));
		r_part.moved[k] = p_is_first ? p_start.moved[k] * p_share : moved * keep;
		r_part.place[k] = r_blade.knots[k];
		set_target(r_stage, k, r_part.place[k], (r_part.moved[k] + load) * per_weight);
	}
	follow_targets(r_blade, r_stage, Vec3<T>{});
}

// [Eq 43] Steps blades beside far-moving colliders in parts of one solve each, with the colliders where they are at that time. r_blade is
// at the start of the step, and blades that take no part stay there. p_parts, p_finer: for each blade; p_thin: see Near.
template <class T>
GRASS_INLINE void step_in_parts(Blade<T> &r_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Start<T> &p_start,
		const T &p_parts, const T &p_finer, const T &p_thin, const MaskOf<T> &p_is_buried) {
	using Mask = MaskOf<T>;
	StepTerms<T> terms = p_terms;
	terms.iterations = 1;
	std::vector<TileCollider> colliders(p_terms.colliders.size()); // the terms' in a part
	terms.colliders = colliders;
	const T most_move = p_terms.max_move * p_terms.step_ratio * r_blade.blade_length;
	Start<T> part;
	Stage<T> stage;
	stage.is_buried = p_is_buried;
	for (int parts = 2; parts <= p_terms.most_parts; parts *= 2) {
		const Mask takes_part = (p_parts > T(float(parts) - 0.5f)) & (p_parts < T(float(parts) + 0.5f));
		if (!any(takes_part)) {
			continue;
		}
		const float share = 1.0f / float(parts);
		const Blade<T> before = r_blade;
		stage.span = terms.seconds * T(share);
		stage.weight = T(1.0f) + terms.drag * stage.span;
		stage.caution = T(CAUTION);
		stage.is_part = true;
		stage.over_inertia = select(p_finer > T(1.0f), T(over_inertia_in_part(terms.finer)), T(over_inertia_in_part(1.0f)));
		stage.most_depth = most_depth_in_part(p_thin, p_chain.mean_length);
		for (int i = 0; i < parts; i++) {
			std::ranges::transform(p_terms.colliders, colliders.begin(),
					[&](const TileCollider &p_collider) { return between(p_collider, float(i) * share, float(i + 1) * share); });
			begin_part(r_blade, p_start, terms.load, most_move * T(share), T(share), i == 0, part, stage);
			const Mask none = takes_part & !takes_part;
			Hold<Mask> no_hold{ none, none, none, none };
			solve_stage(r_blade, terms, p_chain, part, stage, takes_part, takes_part, no_hold);
		}
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			const Vec3<T> knot = r_blade.knots[k];
			r_blade.knots[k] = select(takes_part, knot, before.knots[k]);
			r_blade.before[k] = select(takes_part, knot - (knot - part.place[k]) * T(float(parts)), before.before[k]);
			r_blade.twist[k - 1] = select(takes_part, r_blade.twist[k - 1], before.twist[k - 1]);
		}
	}
}

// How blades take their step.
template <class T> struct Plan {
	Near<T> near;
	T finer; // own_finer()
	T parts; // [Eq 43]
	MaskOf<T> is_buried, is_laid; // [Eq 46], [Eq 47]
	MaskOf<T> stays; // where it is: it takes no solve
};
// Plans the step. p_fastest: how far the fastest knot moves in the step, metres.
template <class T> GRASS_INLINE Plan<T> make_plan(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const T &p_fastest) {
	Plan<T> plan;
	plan.near = find_near(p_blade, p_terms);
	plan.finer = own_finer(p_blade, p_terms);
	const Burial<T> burial = find_burial(p_blade, p_terms, plan.finer);
	plan.is_buried = plan.near.is_near & burial.is_buried;
	plan.is_laid = plan.near.is_near & burial.is_laid;
	plan.stays = (plan.is_buried & burial.is_slow) | plan.is_laid;
	plan.parts = select(plan.stays, T(1.0f), count_parts(p_blade, p_terms, plan.near, p_fastest, plan.finer));
	return plan;
}

// [Eq 22] Takes the step: one implicit Euler step, or several [Eq 43], for a blade that something may touch; for any other a step of second
// order.
template <class T> GRASS_INLINE Spared<MaskOf<T>> step_direct(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	using Mask = MaskOf<T>;
	T fastest;
	const Start<T> start = make_start(r_blade, p_terms, fastest);
	const Plan<T> plan = make_plan(r_blade, p_terms, fastest);
	const T parts = plan.parts;
	const Mask stays = plan.stays, is_in_parts = parts > T(1.5f), is_near = plan.near.is_near & !stays,
			   is_free = !(is_near | is_in_parts | stays);
	const T seconds = p_terms.seconds;
	const ChainTerms<T> chain = make_chain_terms(r_blade, p_terms);
	Blade<T> parted;
	if (any(is_in_parts)) {
		parted = r_blade;
		step_in_parts(parted, p_terms, chain, start, parts, plan.finer, plan.near.thin, plan.is_buried);
	}
	const FreeStep<T> free = make_free_step(r_blade, p_terms, start);
	const T euler_weight = T(1.0f) + p_terms.drag * seconds;

	Stage<T> stage;
	stage.span = select(is_free, p_terms.free_span, seconds);
	stage.weight = select(is_free, free.weight / free.ahead, euler_weight);
	stage.caution = select(is_free, T(0.0f), T(CAUTION));
	stage.is_part = false;
	stage.over_inertia = T(CONTACT_OVER_INERTIA);
	stage.is_buried = plan.is_buried;
	stage.most_depth = chain.mean_length * T(MOST_DEPTH);
	const Mask none = is_near & !is_near;
	Hold<Mask> hold{ none, none, none, none };
	hold.may_stick = is_near & (!is_in_parts) & (fastest < r_blade.blade_length * (seconds * T(RUB_BELOW))) &
			(T(float(p_terms.iterations)) > T(1.0f));
	if (any(hold.may_stick)) {
		hold.may_stick = hold.may_stick & all_are_slower(r_blade, p_terms, CARRY_FROM);
		hold.may_be_held =
				hold.may_stick & (fastest < r_blade.blade_length * (seconds * T(HOLD_BELOW))) & all_stand_still(r_blade, p_terms);
	}
	const T kept = select(hold.may_stick, rubbed(seconds), T(1.0f));
	const T carries = select(is_free, free.carries, kept / euler_weight);
	const T loaded = stage.span * stage.span / select(is_free, free.weight, euler_weight);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		set_target(stage, k, start.place[k], start.moved[k] * carries + p_terms.load * loaded);
	}
	follow_targets(r_blade, stage, p_terms.load * select(is_free, loaded, T(0.0f)));
	Middle<T> middle;
	const bool has_free = any(is_free);
	if (has_free) {
		go_to_middle(r_blade, stage, start, free, is_free, middle);
	}
	solve_stage(r_blade, p_terms, chain, start, stage, !(is_in_parts | stays), is_near, hold);
	if (has_free) {
		leave_middle(r_blade, free, is_free, middle);
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		r_blade.before[k] = start.place[k];
		r_blade.knots[k] = select(stays, start.place[k], r_blade.knots[k]);
		r_blade.twist[k - 1] = select(stays, start.twist[k - 1], r_blade.twist[k - 1]);
	}
	if (any(is_in_parts)) {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_blade.knots[k] = select(is_in_parts, parted.knots[k], r_blade.knots[k]);
			r_blade.before[k] = select(is_in_parts, parted.before[k], r_blade.before[k]);
			r_blade.twist[k - 1] = select(is_in_parts, parted.twist[k - 1], r_blade.twist[k - 1]);
		}
	}
	return { hold.is_held, plan.is_laid };
}

} // namespace grass
