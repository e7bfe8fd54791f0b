// SPDX-License-Identifier: MIT
// METHOD_DIRECT: the step of a blade with nothing near it, of second order with one solve. Twin of shaders/solver/free.inc.
// docs/internals/solver.md derives it.
#pragma once

#include "core/solver/chain.h"
#include "core/solver/contact.h"

namespace grass {

// A blade's positions at the start of the step, and how far its speed carries it in the step.
template <class T> struct Start {
	Vec3<T> place[GRASS_KNOTS]; // metres
	Vec3<T> moved[GRASS_KNOTS]; // metres
	T twist[GRASS_SEGMENTS]; // radians
};

template <class T> GRASS_INLINE Start<T> make_start(const Blade<T> &p_blade, const StepTerms<T> &p_terms, T &r_fastest) {
	Start<T> start;
	const T limit = p_terms.max_move * p_blade.blade_length; // in the step before
	r_fastest = T(0.0f);
	for (int k = 0; k < GRASS_KNOTS; k++) {
		start.place[k] = p_blade.knots[k];
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> moved = p_blade.knots[k] - p_blade.before[k];
		const T size = length(moved);
		const T keep = select(size > limit, limit / maximum(size, T(1e-12f)), T(1.0f));
		start.twist[k - 1] = p_blade.twist[k - 1];
		start.moved[k] = moved * (keep * p_terms.step_ratio);
		r_fastest = maximum(r_fastest, size * keep * p_terms.step_ratio);
	}
	return start;
}

#include "core/base/lane_words.h"

#include "solver/free_step.inc"

#include "core/base/lane_words_end.h"

// [Eq 22] Makes the step according to how lively the blade was in the step before.
template <class T> GRASS_INLINE FreeStep<T> make_free_step(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Start<T> &p_start) {
	Liveliness<T> lively = begin_liveliness<T>();
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		add_to_liveliness(lively, p_start.place[s + 1] - p_start.place[s], p_start.moved[s + 1] - p_start.moved[s], p_blade.lengths[s]);
	}
	return free_step(lively, p_terms.wild_move * p_terms.wild_move, p_terms.drag * p_terms.seconds, p_terms.still_turns);
}

// The positions at which a free blade's forces are computed, and where its step would end without them.
template <class T> struct Middle {
	Vec3<T> guess[GRASS_KNOTS]; // where the step would end without forces, metres
	Vec3<T> place[GRASS_KNOTS]; // mean of the guess and of the places now and before, metres
};

// [Eq 22] Moves the blade from the guess that follow_targets() left in r_blade to the mean. Sets the targets so that a solve from there
// turns the mean.
template <class T, class Mask>
GRASS_INLINE void go_to_middle(Blade<T> &r_blade, Stage<T> &r_stage, const Start<T> &p_start, const FreeStep<T> &p_free,
		const Mask &p_is_free, Middle<T> &r_middle) {
	Vec3<T> carry{}, moved{}; // of the knot before
	for (int k = 0; k < GRASS_KNOTS; k++) {
		r_middle.guess[k] = r_middle.place[k] = r_blade.knots[k];
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> guess = r_middle.guess[k] - r_middle.guess[k - 1];
		const Vec3<T> start = p_start.place[k] - p_start.place[k - 1];
		carry = carry + middle_change(p_free, start, guess - start, p_start.moved[k] - moved, r_blade.lengths[k - 1]);
		moved = p_start.moved[k];
		const Vec3<T> place = p_start.place[k] + carry;
		const Vec3<T> target = place + (r_stage.target[k] - r_middle.guess[k]) * p_free.ahead;
		r_middle.place[k] = select(p_is_free, place, r_middle.guess[k]);
		r_stage.target[k] = select(p_is_free, target, r_stage.target[k]);
		r_blade.knots[k] = r_middle.place[k];
	}
}

// [Eq 22] Moves the blade from the mean, as the solve has turned it, to the end of the step.
template <class T, class Mask>
GRASS_INLINE void leave_middle(Blade<T> &r_blade, const FreeStep<T> &p_free, const Mask &p_is_free, const Middle<T> &p_middle) {
	Vec3<T> carry{}, shift{}; // of the knot before
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> guess = p_middle.guess[k] - p_middle.guess[k - 1];
		const Vec3<T> own_shift = r_blade.knots[k] - p_middle.place[k];
		carry = carry + end_change(p_free, guess, own_shift - shift, r_blade.lengths[k - 1]);
		shift = own_shift;
		r_blade.knots[k] = select(p_is_free, p_middle.guess[k] + carry, r_blade.knots[k]);
	}
}

} // namespace grass
