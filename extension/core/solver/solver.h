// SPDX-License-Identifier: MIT
// One step of one blade (or of eight, one in each lane): METHOD_PBD, the method of Han and Harada 2012 that Fan et al.
// 2015 (section 4.2) use, repaired. Twin of shaders/solver/solve.inc. docs/internals/solver.md derives it.
#pragma once

#include "core/solver/contact.h"
#include "core/solver/direct.h"

namespace grass {

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
	T sum = sum_of(p_terms.load);
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

// Restores idle blades, whatever rounding did to them while their neighbours moved.
template <class T, class Mask> GRASS_INLINE void keep_idle(Blade<T> &r_blade, const Mask &p_is_idle) {
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		r_blade.knots[k] = select(p_is_idle, r_blade.rest[k], r_blade.knots[k]);
		r_blade.before[k] = select(p_is_idle, r_blade.rest[k], r_blade.before[k]);
		r_blade.twist[k - 1] = select(p_is_idle, T(0.0f), r_blade.twist[k - 1]);
	}
}

// Takes a step of the method of Han and Harada 2012 that Fan et al. 2015 use (section 4.2), repaired.
template <class T> GRASS_INLINE Spared<MaskOf<T>> step_pbd(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	const MaskOf<T> is_laid = find_burial(r_blade, p_terms).is_laid;
	integrate(r_blade, p_terms);
	for (int i = 0; i < p_terms.iterations; i++) {
		straighten(r_blade, p_terms);
		keep_lengths(r_blade);
		if (!p_terms.colliders.empty()) {
			const DeepestCorrection<T> deepest = find_deepest_correction(r_blade, p_terms);
			if (any(deepest.correction.depth > T(0.0f))) {
				bend(r_blade, deepest);
			}
		}
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		r_blade.knots[k] = select(is_laid, r_blade.before[k], r_blade.knots[k]);
	}
	return { T(0.0f) > T(1.0f), is_laid };
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
	Spared<MaskOf<T>> spared = p_terms.is_direct ? step_direct(r_blade, p_terms) : step_pbd(r_blade, p_terms);
	if (any(p_terms.blend > T(0.0f))) {
		settle(r_blade, p_terms);
		spared.is_held = spared.is_held & !(p_terms.blend > T(0.0f));
		spared.is_laid = spared.is_laid & !(p_terms.blend > T(0.0f));
	}
	mend(r_blade);
	finish(r_blade, p_terms, spared);
	mend(r_blade); // repairs what a body of absurd size did in finish()
	if (any(idle)) {
		keep_idle(r_blade, idle);
	}
}

} // namespace grass
