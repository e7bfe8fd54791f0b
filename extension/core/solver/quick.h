// SPDX-License-Identifier: MIT
// METHOD_DIRECT: the quick solve, of a blade that nothing is near and that is nowhere bent sharply. Twin of shaders/solver/quick.inc.
// docs/solver.md derives it.
#pragma once

#include "core/solver/chain.h"

namespace grass {

// Whether a first guess is one that a quick solve can take: no knot near the ground, all segments alike, none bent sharply against the
// next.
template <class T> GRASS_INLINE auto is_simple(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain) {
	const T mean = p_chain.mean_length;
	auto is_simple = mean > T(0.0f);
	Vec3<T> before{};
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> e = segment(p_blade, k - 1);
		const T length = p_blade.lengths[k - 1];
		is_simple = is_simple & (absolute(length - mean) < mean * T(MOST_UNEVEN)) &
				(p_blade.knots[k].y > (p_terms.ground_gap + T(SKIN)) * length);
		if (k > GRASS_CLAMPED_KNOTS) {
			is_simple = is_simple & (dot(e, before) > mean * mean * T(LEAST_COSINE));
		}
		before = e;
	}
	return is_simple;
}

// [Eq 42] How far the blade goes by turns in the plane that it is bent in.
template <class T> GRASS_INLINE Stride<T> find_stride(const Blade<T> &p_blade, const ChainTerms<T> &p_chain) {
	StrideSum<T> sum{};
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		add_to_stride(sum, s, segment(p_blade, s));
	}
	return end_stride(sum, segment(p_blade, GRASS_SEGMENTS - 1), p_chain.mean_length);
}

// [Eq 39] to [Eq 41] Tip to root.
template <class T>
GRASS_INLINE void sweep_quick(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Stage<T> &p_stage,
		const JointGain<T> (&p_measured)[GRASS_SEGMENTS], QuickGain<T> (&r_gains)[GRASS_SEGMENTS]) {
	constexpr int LAST = GRASS_SEGMENTS - 1;
	const T inverse_length = T(1.0f) / p_chain.mean_length;
	QuickSweep<T> sweep = begin_quick_sweep(segment(p_blade, LAST) * inverse_length);
	for (int s = LAST; s >= 1; s--) {
		const Vec3<T> way = p_stage.target[s + 1] - p_blade.knots[s + 1];
		const Vec3<T> force = way * (s == LAST ? T(0.5f) * inverse_length : inverse_length);
		r_gains[s] = sweep_quick_joint(sweep, p_terms.quick[s], p_measured[s].turn, force, segment(p_blade, s - 1) * inverse_length);
	}
}

// [Eq 39] One quick solve. p_active: which lanes' blades move.
template <class T, class Mask>
GRASS_INLINE void solve_quick(
		Blade<T> &r_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Stage<T> &p_stage, const Mask &p_active) {
	JointGain<T> measured[GRASS_SEGMENTS];
	measure_joints(r_blade, measured);
	QuickGain<T> gains[GRASS_SEGMENTS];
	sweep_quick(r_blade, p_terms, p_chain, p_stage, measured, gains);
	const Stride<T> stride = find_stride(r_blade, p_chain);
	QuickBack<T> back = begin_quick_back<T>();
	Vec3<T> parent = r_blade.knots[1];
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		const Vec3<T> knot = r_blade.knots[s + 1];
		T twist = r_blade.twist[s];
		turn_quick_joint(back, p_terms.quick[s], gains[s], stride, knot - parent, p_chain.mean_length, twist);
		parent = knot;
		r_blade.knots[s + 1] = select(p_active, knot + back.shift, knot);
		r_blade.twist[s] = select(p_active, twist, r_blade.twist[s]);
	}
}

} // namespace grass
