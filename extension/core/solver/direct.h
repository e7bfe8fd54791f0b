// SPDX-License-Identifier: MIT
// METHOD_DIRECT over time: one implicit step of a chain, of the second order where nothing is near. Twin of shaders/solver/direct.inc.
#pragma once

#include "core/solver/free.h"

#include <algorithm>

namespace grass {

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

// Which blades take the i-th solve of a step: those that something is near `iterations`, others one.
template <class T, class Mask> GRASS_INLINE Mask wants_solve(const StepTerms<T> &p_terms, int p_i, const Mask &p_is_near) {
	const Mask is_first = T(float(p_i)) < T(1.0f);
	return p_i < p_terms.iterations ? p_is_near | is_first : (!p_is_near) & is_first;
}

// [Eq 30] The solves of a step. Blades that the first one shows to be hit go on from the blow, with one solve at least.
template <class T, class Mask>
GRASS_INLINE void solve_stage(Blade<T> &r_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Start<T> &p_start,
		Stage<T> &r_stage, const Mask &p_is_near, Hold<Mask> &r_hold) {
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
		const Mask by_count = wants_solve(p_terms, i, p_is_near);
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

// [Eq 22] p_is_near: whether something may touch the blade. Then it takes an implicit Euler step; else one of the second order. Returns
// which blades are held, [Eq 36].
template <class T, class Mask> GRASS_INLINE Mask step_direct(Blade<T> &r_blade, const StepTerms<T> &p_terms, const Mask &p_is_near) {
	T fastest;
	const Start<T> start = make_start(r_blade, p_terms, fastest);
	const T seconds = p_terms.seconds;
	const ChainTerms<T> chain = make_chain_terms(r_blade, p_terms.bending);
	const FreeStep<T> free = make_free_step(r_blade, p_terms, start);
	const T euler_weight = T(1.0f) + p_terms.drag * seconds;

	Stage<T> stage;
	stage.span = select(p_is_near, seconds, p_terms.free_span);
	stage.weight = select(p_is_near, euler_weight, free.weight / free.ahead);
	stage.caution = select(p_is_near, T(CAUTION), T(0.0f));
	const Mask none = p_is_near & !p_is_near;
	Hold<Mask> hold{ none, none, none, none };
	hold.may_stick = p_is_near & (fastest < r_blade.blade_length * (seconds * T(RUB_BELOW))) & (T(float(p_terms.iterations)) > T(1.0f));
	if (any(hold.may_stick)) {
		hold.may_be_held =
				hold.may_stick & (fastest < r_blade.blade_length * (seconds * T(HOLD_BELOW))) & all_stand_still(r_blade, p_terms);
	}
	const T kept = select(hold.may_stick, rubbed(seconds), T(1.0f));
	const T carries = select(p_is_near, kept / euler_weight, free.carries);
	const T loaded = stage.span * stage.span / select(p_is_near, euler_weight, free.weight);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		set_target(stage, k, start.place[k], start.moved[k] * carries + p_terms.load * loaded);
	}
	follow_targets(r_blade, stage, p_terms.load * select(p_is_near, T(0.0f), loaded));
	Middle<T> middle;
	const bool has_free = any(!p_is_near);
	if (has_free) {
		go_to_middle(r_blade, stage, start, free, !p_is_near, middle);
	}
	solve_stage(r_blade, p_terms, chain, start, stage, p_is_near, hold);
	if (has_free) {
		leave_middle(r_blade, free, !p_is_near, middle);
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		r_blade.before[k] = start.place[k];
	}
	return hold.is_held;
}

} // namespace grass
