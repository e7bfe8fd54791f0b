// SPDX-License-Identifier: MIT
// METHOD_DIRECT over time: one implicit step of a chain, or two of the second order. Twin of shaders/compute/direct.inc.
#pragma once

#include "core/chain.h"

namespace grass {

// [Eq 22] Both stages of the two-stage method take this share of the step: 1 - 1 / sqrt(2) is of second order and forgets
// fast swings.
inline constexpr float STAGE_SHARE = 0.29289322f;

// Resistance of the joints of a blade near something.
inline constexpr float CAUTION = 4.0f;

// A blade's places and speeds at the start of the step.
template <class T> struct Start {
	Vec3<T> place[GRASS_KNOTS]; // metres
	Vec3<T> speed[GRASS_KNOTS]; // m/s
};

template <class T> GRASS_INLINE Start<T> make_start(const Blade<T> &p_blade, const StepTerms<T> &p_terms, T &r_fastest) {
	Start<T> start;
	const T limit = p_terms.max_move * p_blade.reach; // in the step before
	const T per_second = p_terms.step_ratio / p_terms.seconds;
	r_fastest = T(0.0f);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> moved = p_blade.knots[k] - p_blade.before[k];
		const T size = length(moved);
		const T keep = select(size > limit, limit / maximum(size, T(1e-12f)), T(1.0f));
		start.place[k] = p_blade.knots[k];
		start.speed[k] = moved * (keep * per_second);
		r_fastest = maximum(r_fastest, size * keep * p_terms.step_ratio);
	}
	return start;
}

template <class T, class Mask>
GRASS_INLINE void solve_stage(
		Blade<T> &r_blade, const StepTerms<T> &p_terms, const Stage<T> &p_stage, const Mask &p_is_single, int p_single, int p_double) {
	const ChainTerms<T> chain = make_chain_terms(r_blade, p_terms);
	for (int i = 0; i < (p_single > p_double ? p_single : p_double); i++) {
		const auto is_active =
				(i < p_single ? p_is_single : p_is_single & !p_is_single) | (i < p_double ? !p_is_single : p_is_single & !p_is_single);
		if (any(is_active)) {
			solve_chain(r_blade, p_terms, chain, p_stage, is_active);
		}
	}
}

// [Eq 22] p_is_near: whether something may touch the blade. Then it takes one implicit Euler step with all `iterations`
// as rounds of contact; else two stages with half of them each (with one iteration: Euler as well).
template <class T, class Mask> GRASS_INLINE void step_direct(Blade<T> &r_blade, const StepTerms<T> &p_terms, const Mask &p_is_near) {
	T fastest;
	const Start<T> start = make_start(r_blade, p_terms, fastest);
	const auto is_single = p_is_near | (fastest > r_blade.reach * p_terms.wild_move) | (T(float(p_terms.iterations)) < T(2.0f));
	const T seconds = p_terms.seconds;
	const int halves = (p_terms.iterations + 1) / 2;

	Stage<T> stage;
	stage.span = select(is_single, seconds, seconds * T(STAGE_SHARE));
	stage.weight = T(1.0f) + p_terms.drag * stage.span;
	stage.caution = select(p_is_near, T(CAUTION), T(0.0f));
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		set_target(stage, k, start.place[k], start.speed[k], p_terms.load);
	}
	follow_targets(r_blade, stage);
	solve_stage(r_blade, p_terms, stage, is_single, p_terms.iterations, halves);

	if (any(!is_single)) {
		const T rest = seconds * T(1.0f - STAGE_SHARE);
		Vec3<T> first[GRASS_KNOTS];
		stage.span = seconds * T(STAGE_SHARE);
		stage.weight = T(1.0f) + p_terms.drag * stage.span;
		const T per_second = T(1.0f) / stage.span;
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			first[k] = r_blade.knots[k];
			const Vec3<T> speed = (r_blade.knots[k] - start.place[k]) * per_second;
			const Vec3<T> gain = (speed - start.speed[k]) * (T((1.0f - STAGE_SHARE) / STAGE_SHARE));
			set_target(stage, k, start.place[k] + speed * rest, start.speed[k] + gain, p_terms.load);
		}
		follow_targets(r_blade, stage);
		solve_stage(r_blade, p_terms, stage, is_single, 0, halves);
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
}

} // namespace grass
