// SPDX-License-Identifier: MIT
// One step of one blade (or of eight, one in each lane): METHOD_PBD, the method of Han and Harada 2012 that Fan et al.
// 2015 (section 4.2) use, repaired. Twin of shaders/solver/solve.inc and of the end of a step in
// shaders/solver/finish.inc. docs/internals/solver.md derives it.
#pragma once

#include "core/solver/blade_order.h"
#include "core/solver/contact.h"
#include "core/solver/direct.h"

namespace grass {

#include "core/base/lane_words.h"

#include "solver/calm.inc"

#include "core/base/lane_words_end.h"

// [Eq 18] Moves the blade a share of the way to rest, and stops its motion; a share of 1 arrives exactly.
template <class T> GRASS_INLINE void settle(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	const auto arrives = p_terms.blend >= T(1.0f);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> rest = r_blade.rest[k];
		r_blade.knots[k] = select(arrives, rest, r_blade.knots[k] + (rest - r_blade.knots[k]) * p_terms.blend);
		r_blade.before[k] = select(arrives, rest, r_blade.before[k] + (rest - r_blade.before[k]) * p_terms.blend);
		r_blade.twist[k - 1] = select(arrives, T(0.0f), r_blade.twist[k - 1] * (T(1.0f) - p_terms.blend));
	}
}

// Puts a blade to rest that has a number which is not finite or absurdly large. Such a number survives every stage.
template <class T> GRASS_INLINE void mend(Blade<T> &r_blade) {
	T sum(0.0f);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> knot = r_blade.knots[k];
		sum = sum + (sum_of(knot) + absolute(r_blade.twist[k - 1]) * r_blade.blade_length);
	}
	const auto is_broken = !(sum < r_blade.blade_length * T(MOST_AWAY));
	if (any(is_broken)) {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_blade.knots[k] = select(is_broken, r_blade.rest[k], r_blade.knots[k]);
			r_blade.before[k] = select(is_broken, r_blade.rest[k], r_blade.before[k]);
			r_blade.twist[k - 1] = select(is_broken, T(0.0f), r_blade.twist[k - 1]);
		}
	}
}

// [Eq 19] Returns half the speed squared plus the pull to rest at the start of a step, the mean over the free knots: J per kg of blade.
template <class T> GRASS_INLINE T measure_energy(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	T sum(0.0f);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> moved = p_blade.knots[k] - p_blade.before[k];
		const Vec3<T> away = p_blade.knots[k] - p_blade.rest[k];
		sum = sum + dot(moved, moved) * p_terms.energy_of_speed +
				dot(away, away) * (p_terms.energy_at_tip + p_terms.energy_at_root * T(root_share(k)));
	}
	return sum * T(0.5f / float(GRASS_FREE_KNOTS));
}

// Returns true if the blade is at rest without a load and nothing can touch it there: a step would not change a single bit of it.
template <class T> GRASS_INLINE auto is_idle(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	T sum = sum_of(p_terms.load) + p_blade.calm;
	T longest(0.0f);
	Extent<T> extent = extent_of(p_blade.rest[1], p_blade.rest[1]);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> away = p_blade.knots[k] - p_blade.rest[k];
		const Vec3<T> moved = p_blade.knots[k] - p_blade.before[k];
		sum = sum + (sum_of(away) + sum_of(moved) + absolute(p_blade.twist[k - 1]));
		extent = { minimum(extent.low, p_blade.rest[k]), maximum(extent.high, p_blade.rest[k]) };
		longest = maximum(longest, p_blade.lengths[k - 1]);
	}
	auto is_resting = sum <= T(0.0f);
	if (!any(is_resting)) {
		return is_resting;
	}
	extent = { extent.low + p_blade.root, extent.high + p_blade.root };
	for (const TileCollider &collider : p_terms.colliders) {
		is_resting = is_resting & passes_by(collider, extent, extent, longest * T(SKIN));
	}
	return is_resting;
}

// Returns the work that the step has with each blade, as core/solver/blade_order.h counts it.
template <class T> GRASS_INLINE T find_work(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	const auto idle = is_idle(p_blade, p_terms);
	const T work = select(idle, T(float(WORK_NONE)), T(float(WORK_FREE)));
	if (!p_terms.is_direct || p_terms.colliders.empty() || !any(!idle)) {
		return work;
	}
	T fastest;
	make_start(p_blade, p_terms, fastest);
	const Plan<T> plan = make_plan(p_blade, p_terms, fastest);
	const auto is_near = (!idle) & (!plan.stays) & (plan.near.is_near | (plan.parts > T(1.5f)));
	return work + select(is_near, plan.parts, T(0.0f));
}

// Restores idle blades, whatever rounding did to them while their neighbours moved.
template <class T, class Mask> GRASS_INLINE void keep_idle(Blade<T> &r_blade, const Mask &p_is_idle) {
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		r_blade.knots[k] = select(p_is_idle, r_blade.rest[k], r_blade.knots[k]);
		r_blade.before[k] = select(p_is_idle, r_blade.rest[k], r_blade.before[k]);
		r_blade.twist[k - 1] = select(p_is_idle, T(0.0f), r_blade.twist[k - 1]);
	}
}

// [Eq 48] For how long bodies at rest alone have touched a blade, seconds, how many could, and whether one has bent it in this step.
template <class T> struct Calm {
	T so_far, count;
	MaskOf<T> is_touched;
};

// Takes a step of the method of Han and Harada 2012 that Fan et al. 2015 use (section 4.2), repaired.
template <class T> GRASS_INLINE Spared<MaskOf<T>> step_pbd(Blade<T> &r_blade, const StepTerms<T> &p_terms, Calm<T> &r_calm) {
	using Mask = MaskOf<T>;
	const Mask is_laid = find_burial(r_blade, p_terms, T(1.0f)).is_laid;
	const T count = count_resting(r_blade, p_terms);
	const T calm = calm_so_far(r_blade.calm, count);
	const T share = calm_share(calm);
	const Mask is_held = (share <= T(HELD_SHARE)) & !is_laid;
	Mask touches = T(0.0f) > T(1.0f);
	integrate(r_blade, p_terms);
	for (int i = 0; i < p_terms.iterations; i++) {
		straighten(r_blade, p_terms);
		keep_length(r_blade);
		if (!p_terms.colliders.empty()) {
			const DeepestCorrection<T> deepest = find_deepest_correction(r_blade, p_terms);
			touches = touches | (deepest.correction.depth > T(0.0f));
			if (any(deepest.correction.depth > T(0.0f))) {
				bend(r_blade, deepest);
			}
		}
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> calmed = r_blade.before[k] + (r_blade.knots[k] - r_blade.before[k]) * share;
		r_blade.knots[k] = select(is_laid | is_held, r_blade.before[k], select(share < T(1.0f), calmed, r_blade.knots[k]));
	}
	r_calm = { calm, count, touches };
	return { is_held, is_laid };
}

// Takes the whole step. Afterwards lengths are right, and knots are finite and, where possible, outside the colliders.
template <class T> GRASS_INLINE void step_blade(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	if (p_terms.iterations == 0) {
		return;
	}
	measure_lengths(r_blade);
	const auto idle = is_idle(r_blade, p_terms);
	if (!any(!idle)) {
		return;
	}
	Calm<T> calm{};
	Spared<MaskOf<T>> spared = p_terms.is_direct ? step_direct(r_blade, p_terms) : step_pbd(r_blade, p_terms, calm);
	if (any(p_terms.blend > T(0.0f))) {
		settle(r_blade, p_terms);
		spared.is_held = spared.is_held & !(p_terms.blend > T(0.0f));
		spared.is_laid = spared.is_laid & !(p_terms.blend > T(0.0f));
	}
	mend(r_blade);
	const MaskOf<T> is_pushed = finish(r_blade, p_terms, spared);
	if (!p_terms.is_direct) {
		const MaskOf<T> is_touched = ((is_pushed | calm.is_touched) & !spared.is_laid) | spared.is_held;
		r_blade.calm = kept_calm(calm.so_far, calm.count, is_touched, p_terms.seconds);
	}
	mend(r_blade); // repairs what a body of absurd size did in finish()
	if (any(idle)) {
		keep_idle(r_blade, idle);
	}
}

} // namespace grass
