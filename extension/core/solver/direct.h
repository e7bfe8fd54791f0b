// SPDX-License-Identifier: MIT
// METHOD_DIRECT over time: one implicit step of a chain, or two of the second order. Twin of shaders/solver/direct.inc.
#pragma once

#include "core/solver/contact.h"
#include "core/solver/quick.h"

#include <algorithm>

namespace grass {

// A blade's places and speeds at the start of the step.
template <class T> struct Start {
	Vec3<T> place[GRASS_KNOTS]; // metres
	Vec3<T> speed[GRASS_KNOTS]; // m/s
	T twist[GRASS_SEGMENTS]; // radians
};

template <class T> GRASS_INLINE Start<T> make_start(const Blade<T> &p_blade, const StepTerms<T> &p_terms, T &r_fastest) {
	Start<T> start;
	const T limit = p_terms.max_move * p_blade.blade_length; // in the step before
	const T per_second = p_terms.step_ratio / p_terms.seconds;
	r_fastest = T(0.0f);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> moved = p_blade.knots[k] - p_blade.before[k];
		const T size = length(moved);
		const T keep = select(size > limit, limit / maximum(size, T(1e-12f)), T(1.0f));
		start.place[k] = p_blade.knots[k];
		start.twist[k - 1] = p_blade.twist[k - 1];
		start.speed[k] = moved * (keep * per_second);
		r_fastest = maximum(r_fastest, size * keep * p_terms.step_ratio);
	}
	return start;
}

// [Eq 36] What rubbing leaves of a speed.
template <class T> GRASS_INLINE T rubbed(const T &p_seconds) {
	return T(1.0f) / (T(1.0f) + T(RUB) * p_seconds);
}

// [Eq 32] What is too deep in a collider for a linear model is hit out of it: the deepest correction bends the blade as METHOD_PBD's
// does, and its inertia comes along.
template <class T, class Mask>
GRASS_INLINE void take_blows(
		Blade<T> &r_blade, const StepTerms<T> &p_terms, const Start<T> &p_start, Stage<T> &r_stage, const Mask &p_is_hit) {
	// Below the skin, which the solve's depth counts in: nothing may be a blow there and none here.
	const T deep = r_blade.blade_length * T((MOST_DEPTH - 2.0f * SKIN) / float(GRASS_SEGMENTS));
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

// [Eq 36] Whether no shared collider that may touch the blade is so fast that it carries it along.
template <class T> GRASS_INLINE auto all_are_slow(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	const T most = p_blade.blade_length * (p_terms.seconds * T(CARRY_FROM));
	auto is_fast = T(0.0f) > T(1.0f);
	for (const TileCollider &collider : p_terms.colliders.first(std::min(p_terms.colliders.size(), size_t(GRASS_SHARED_COLLIDERS)))) {
		is_fast =
				is_fast | ((motion_of<T>(collider) > most) & comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN)));
	}
	return !is_fast;
}

// [Eq 36] Whether no collider that may touch the blade moves in this step; not known where there are more than the shared ones.
template <class T> GRASS_INLINE auto all_stand_still(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	auto is_moved = T(p_terms.colliders.size() > GRASS_SHARED_COLLIDERS ? 1.0f : 0.0f) > T(0.0f);
	for (const TileCollider &collider : p_terms.colliders) {
		if (!stands_still(collider)) {
			is_moved = is_moved | comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN));
		}
	}
	return !is_moved;
}

// [Eq 36] Which blades may stick in a step, and which do.
template <class Mask> struct Hold {
	Mask may_stick; // slow and near something
	Mask may_be_held; // and slower, near nothing but what stands still
	Mask sticks; // where it was at the start of the step
	Mask is_held; // of those, the ones which nothing may push, either
};

// [Eq 36] After the first solve of slow blades: those that touch nothing get back the speed that rubbing took, those that touch something
// and stick go back to where they were. p_is_slow: of r_hold.may_stick, the ones that nothing has hit.
template <class T, class Mask>
GRASS_INLINE void hold(Blade<T> &r_blade, const StepTerms<T> &p_terms, const Start<T> &p_start, Stage<T> &r_stage, const Mask &p_is_slow,
		const Mask &p_touches, const Touches<T> &p_found, Hold<Mask> &r_hold) {
	const Mask is_free = p_is_slow & !p_touches;
	const T lost = T(RUB) * r_stage.span; // of what is left
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
	const T grip = minimum(p_found.grip * (T(1.0f / float(GRASS_FREE_KNOTS)) / r_stage.weight), force);
	const Mask is_held = r_hold.may_be_held & (forced < grip * grip) & (p_found.deepest < T(INSIDE));
	r_hold.sticks = p_is_slow & p_touches & ((farthest < limit * limit) | is_held);
	r_hold.is_held = r_hold.sticks & is_held;
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		r_blade.knots[k] = select(r_hold.sticks, p_start.place[k], r_blade.knots[k]);
		r_blade.twist[k - 1] = select(r_hold.sticks, p_start.twist[k - 1], r_blade.twist[k - 1]);
	}
}

// Which blades take the i-th solve of a stage: those that something is near `iterations`, others all of theirs where they take the step
// in one stage, else half of them in each of two.
template <class T, class Mask>
GRASS_INLINE Mask wants_solve(const StepTerms<T> &p_terms, int p_i, const Mask &p_is_single, const Mask &p_is_near) {
	const Mask by_solves =
			(p_is_single & (T(float(p_i)) < p_terms.free_solves)) | ((!p_is_single) & (T(float(2 * p_i)) < p_terms.free_solves));
	return p_i < p_terms.iterations ? p_is_near | by_solves : (!p_is_near) & by_solves;
}

// [Eq 30] The solves of a stage of p_takes_part. Blades that the first one shows to be hit go on from the blow, with one solve at least.
template <class T, class Mask>
GRASS_INLINE void solve_stage(Blade<T> &r_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Start<T> &p_start,
		Stage<T> &r_stage, const Mask &p_takes_part, const Mask &p_is_single, const Mask &p_is_near, Hold<Mask> &r_hold) {
	const Mask none = p_is_single & !p_is_single;
	Vec3<T> guess[GRASS_KNOTS];
	T twist[GRASS_SEGMENTS];
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		guess[k] = r_blade.knots[k];
		twist[k - 1] = r_blade.twist[k - 1];
	}
	Mask is_hit = none;
	r_hold.sticks = r_hold.is_held = none;
	for (int i = 0;; i++) {
		const Mask by_count = p_takes_part & wants_solve(p_terms, i, p_is_single, p_is_near);
		const Mask is_active = is_hit | (by_count & !r_hold.sticks);
		if (!any(is_active)) {
			return;
		}
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

// [Eq 22] p_is_near: whether something may touch the blade. Then it takes one implicit Euler step; else two stages with half of its solves
// each, or, where it has one only, that of [Eq 38]. Returns which blades are held, [Eq 36].
template <class T, class Mask> GRASS_INLINE Mask step_direct(Blade<T> &r_blade, const StepTerms<T> &p_terms, const Mask &p_is_near) {
	T fastest;
	const Start<T> start = make_start(r_blade, p_terms, fastest);
	const Mask is_one = (!p_is_near) & (p_terms.free_solves < T(2.0f));
	const Mask is_single = p_is_near | is_one | (fastest > r_blade.blade_length * p_terms.wild_move);
	const T seconds = p_terms.seconds;
	const ChainTerms<T> chain = make_chain_terms(r_blade, select(is_one, p_terms.free_bending, p_terms.bending));
	const T drag = select(is_one, p_terms.free_drag, p_terms.drag);
	const Vec3<T> load = p_terms.load * select(is_one, p_terms.free_bending / p_terms.bending, T(1.0f)); // bends the blade as much as ever

	Stage<T> stage;
	stage.span = select(is_single, seconds, seconds * T(STAGE_SHARE));
	stage.weight = T(1.0f) + drag * stage.span;
	stage.caution = select(p_is_near, T(CAUTION), T(0.0f));
	const Mask none = is_single & !is_single;
	Hold<Mask> hold{ none, none, none, none }, no_hold = hold;
	hold.may_stick = p_is_near & (fastest < r_blade.blade_length * (seconds * T(RUB_BELOW))) & (T(float(p_terms.iterations)) > T(1.0f));
	if (any(hold.may_stick)) {
		hold.may_stick = hold.may_stick & all_are_slow(r_blade, p_terms);
		hold.may_be_held =
				hold.may_stick & (fastest < r_blade.blade_length * (seconds * T(HOLD_BELOW))) & all_stand_still(r_blade, p_terms);
	}
	const T kept = select(hold.may_stick, rubbed(seconds), T(1.0f));
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		set_target(stage, k, start.place[k], start.speed[k] * kept, load);
	}
	const T lacks = select(is_one, stage.span * stage.span / stage.weight, T(0.0f)); // [Eq 38]
	follow_targets(r_blade, stage, load * lacks);
	// The GPU asks for a list of no colliders instead, good or bad, and takes whole solves as long as it compiles.
	Mask is_quick = is_one & (p_terms.free_quick > T(p_terms.colliders.empty() ? 0.0f : 1.0f));
	if (any(is_quick)) {
		is_quick = is_quick & is_simple(r_blade, p_terms, chain);
	}
	if (any(is_quick)) {
		solve_quick(r_blade, p_terms, chain, stage, is_quick);
	}
	solve_stage(r_blade, p_terms, chain, start, stage, !is_quick, is_single, p_is_near, hold);

	if (any(!is_single)) {
		const T rest = seconds * T(1.0f - STAGE_SHARE);
		Vec3<T> first[GRASS_KNOTS];
		stage.span = seconds * T(STAGE_SHARE);
		stage.weight = T(1.0f) + drag * stage.span;
		const T per_second = T(1.0f) / stage.span;
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			first[k] = r_blade.knots[k];
			const Vec3<T> speed = (r_blade.knots[k] - start.place[k]) * per_second;
			const Vec3<T> gain = (speed - start.speed[k]) * (T((1.0f - STAGE_SHARE) / STAGE_SHARE));
			set_target(stage, k, start.place[k] + speed * rest, start.speed[k] + gain, load);
		}
		follow_targets(r_blade, stage, Vec3<T>{});
		solve_stage(r_blade, p_terms, chain, start, stage, !is_single, is_single, none, no_hold);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			const Vec3<T> speed = (r_blade.knots[k] - stage.base[k]) * per_second;
			r_blade.knots[k] = select(is_single, first[k], r_blade.knots[k]);
			r_blade.before[k] = select(is_single, start.place[k], r_blade.knots[k] - speed * seconds);
		}
	} else {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_blade.before[k] = start.place[k];
		}
	}
	return hold.is_held;
}

} // namespace grass
