// SPDX-License-Identifier: MIT
// Finds which colliders may touch a blade in a step, and into how many parts it divides the step. Twin of
// shaders/solver/near.inc.
#pragma once

#include "core/solver/edge.h"
#include "core/solver/shape.h"

#include <algorithm>

namespace grass {

#include "core/base/lane_words.h"

#include "solver/beside.inc"

#include "core/base/lane_words_end.h"

template <class T> using MaskOf = decltype(T() < T());

// The colliders near a blade.
template <class T> struct Near {
	MaskOf<T> is_reached; // a collider could be touched in any pose of the blade
	MaskOf<T> is_near; // one may be touched in this step
	T moved; // the farthest that such a collider moves in the step, metres
	T thin; // least thickness of such a collider, metres
};

// [Eq 37] Finds them by where the blade's speed would carry its segments in this step.
template <class T> GRASS_INLINE Near<T> find_near(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	const MaskOf<T> none = T(0.0f) > T(1.0f);
	Near<T> near{ none, none, T(0.0f), p_blade.blade_length };
	const T limit = p_terms.max_move * p_blade.blade_length;
	const Vec3<T> load = p_terms.load * (p_terms.seconds * p_terms.seconds);
	for (const TileCollider &collider : p_terms.colliders) {
		const auto is_reached = comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN));
		if (!any(is_reached)) {
			continue;
		}
		near.is_reached = near.is_reached | is_reached;
		const bool is_at_rest = stands_still(collider);
		auto is_near = none;
		Vec3<T> from = p_blade.rest[GRASS_CLAMPED_KNOTS - 1] + p_blade.root, to = from;
		for (int k = GRASS_CLAMPED_KNOTS - 1; k < GRASS_KNOTS; k++) { // the clamp alone first
			const Vec3<T> moved = p_blade.knots[k] - p_blade.before[k];
			const T keep = minimum(T(1.0f), limit / maximum(length(moved), T(1e-12f))) * p_terms.step_ratio;
			const Vec3<T> end_from = p_blade.knots[k] + p_blade.root;
			const Vec3<T> end_to = k < GRASS_CLAMPED_KNOTS ? end_from : end_from + moved * keep + load;
			const T segment = p_blade.lengths[std::max(k, GRASS_CLAMPED_KNOTS) - 1];
			auto comes_near = !passes_by(collider, extent_of(from, end_from), extent_of(to, end_to), segment * T(NEAR_MARGIN));
			if (is_at_rest && any(comes_near)) {
				comes_near = comes_near & !stays_beside(collider, from, end_from, to, end_to, segment * T(NEAR_AT_REST));
			}
			is_near = is_near | comes_near;
			from = end_from;
			to = end_to;
		}
		is_near = is_near & is_reached;
		near.is_near = near.is_near | is_near;
		near.moved = maximum(near.moved, select(is_near, T(collider.moved), T(0.0f)));
		near.thin = minimum(near.thin, select(is_near, T(collider.thin), near.thin));
	}
	return near;
}

// [Eq 36] Returns true if no shared collider that may touch the blade has a point faster than p_speed, blade lengths a second.
template <class T> GRASS_INLINE MaskOf<T> all_are_slower(const Blade<T> &p_blade, const StepTerms<T> &p_terms, float p_speed) {
	const T most = p_blade.blade_length * (p_terms.seconds * T(p_speed));
	MaskOf<T> is_fast = T(0.0f) > T(1.0f);
	for (const TileCollider &collider : p_terms.colliders.first(std::min(p_terms.colliders.size(), size_t(GRASS_SHARED_COLLIDERS)))) {
		is_fast =
				is_fast | ((motion_of<T>(collider) > most) & comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN)));
	}
	return !is_fast;
}

// [Eq 36] Returns true if no collider that may touch the blade moves in this step. Returns false if there are more than the shared
// colliders.
template <class T> GRASS_INLINE MaskOf<T> all_stand_still(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	MaskOf<T> is_moved = T(p_terms.colliders.size() > GRASS_SHARED_COLLIDERS ? 1.0f : 0.0f) > T(0.0f);
	for (const TileCollider &collider : p_terms.colliders) {
		if (!stands_still(collider)) {
			is_moved = is_moved | comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN));
		}
	}
	return !is_moved;
}

// [Eq 43] Returns contact_rate over its least for each blade: 1 beside bodies that creep.
template <class T> GRASS_INLINE T own_finer(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	return p_terms.finer > 1.0f ? select(all_are_slower(p_blade, p_terms, FINER_FROM), T(1.0f), T(p_terms.finer)) : T(1.0f);
}

// The colliders on a blade's root at the end of this step: the clamp, which cannot move out, is inside of them.
template <class T> struct Burial {
	MaskOf<T> is_buried; // [Eq 46] and the blade is down: its tip is below LYING of its length
	MaskOf<T> is_slow; // none of them has a point faster than BURY_BELOW or, if round, bury_round_below()
	MaskOf<T> is_laid; // [Eq 47] one of them rests: none of its points is faster than CARRY_FROM
};
template <class T> GRASS_INLINE Burial<T> find_burial(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const T &p_finer) {
	const MaskOf<T> none = T(0.0f) > T(1.0f);
	MaskOf<T> is_buried = none, is_fast = none, is_laid = none;
	const T of_step = p_blade.blade_length * p_terms.seconds;
	const T round_below = select(p_finer > T(1.0f), T(p_terms.bury_round_below), T(p_terms.least_bury_round_below));
	for (const TileCollider &collider : p_terms.colliders) {
		const Vec3<T> place = place_now(collider, p_blade.root, p_blade.rest[GRASS_CLAMPED_KNOTS - 1]);
		auto is_inside = dot(place, place) < T(collider.bound * collider.bound);
		if (any(is_inside)) {
			const T moved = motion_of<T>(collider);
			is_inside = is_inside & (find_face(collider, place).distance < T(0.0f));
			is_buried = is_buried | is_inside;
			is_fast = is_fast | (is_inside & (moved > of_step * (is_round(collider) ? round_below : T(BURY_BELOW))));
			is_laid = is_laid | (is_inside & !(moved > of_step * T(CARRY_FROM)));
		}
	}
	is_buried = is_buried & (p_blade.knots[GRASS_SEGMENTS].y < p_blade.blade_length * T(LYING));
	return { is_buried, !is_fast, is_laid };
}

// [Eq 48] Returns how many colliders could touch the blade in any pose, 0 if one of them moves or anything else drives the blade.
template <class T> GRASS_INLINE T count_resting(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	T count(0.0f);
	MaskOf<T> is_driven = sum_of(p_terms.load) > T(0.0f);
	for (const TileCollider &collider : p_terms.colliders) {
		const auto is_reached = comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN));
		count = count + select(is_reached, T(1.0f), T(0.0f));
		if (!stands_still(collider)) {
			is_driven = is_driven | is_reached;
		}
	}
	return select(is_driven, T(0.0f), count);
}

// [Eq 43] Returns the number of equal parts into which a blade divides the step: a power of 2. p_fastest: how far its fastest knot moves in
// the step, metres; p_finer: own_finer().
template <class T>
GRASS_INLINE T count_parts(
		const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Near<T> &p_near, const T &p_fastest, const T &p_finer) {
	const MaskOf<T> is_asked = p_near.is_near | (p_near.is_reached & (p_fastest > p_blade.blade_length * p_terms.wild_move / p_finer));
	const T moved = maximum(p_near.moved, p_fastest * T(PART_OF_KNOT));
	const T wanted =
			moved * (T(float(p_terms.iterations)) * p_finer * p_finer) / (p_blade.blade_length * T(2.0f * PART / float(GRASS_SEGMENTS)));
	const T most = select(p_finer > T(1.0f), T(float(p_terms.most_parts)), T(float(p_terms.least_most_parts)));
	T parts(1.0f);
	for (int i = 2; i <= p_terms.most_parts; i *= 2) {
		parts = select(is_asked & (wanted > parts) & !(T(float(i)) > most), T(float(i)), parts);
	}
	return parts;
}

} // namespace grass
