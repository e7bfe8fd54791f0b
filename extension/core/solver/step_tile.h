// SPDX-License-Identifier: MIT
// The step of a tile's blades over any lane type; step_lanes.cpp, step_lanes_16.cpp and step_scalar.cpp instantiate it.
#pragma once

#include "core/solver/solver.h"
#include "core/solver/tile_state.h"

#include <algorithm>
#include <cstring>

namespace grass {

template <class T> inline constexpr int LANE_COUNT = 1;
template <class T>
requires(T::COUNT > 0) inline constexpr int LANE_COUNT<T> = T::COUNT;

template <class T> GRASS_INLINE T load(const float *p_from) {
	if constexpr (LANE_COUNT<T> == 1) {
		return T(*p_from);
	} else {
		T lanes;
		std::memcpy(&lanes.values, p_from, sizeof(lanes.values));
		return lanes;
	}
}

// Stores values and removes the sign of a zero, which depends on whether another lane took a branch that adds nothing here.
GRASS_INLINE void store(float p_value, float *r_to) {
	*r_to = p_value + 0.0f;
}
GRASS_INLINE void store(double p_value, float *r_to) {
	*r_to = float(p_value + 0.0);
}
template <class T> GRASS_INLINE void store(const T &p_value, float *r_to) {
	const T without_sign = p_value + T(0.0f);
	std::memcpy(r_to, &without_sign.values, sizeof(without_sign.values));
}

template <class T, int N> GRASS_INLINE Vec3<T> load_knot(const float (&p_from)[3][N][GRASS_BLADES_PER_TILE], int p_knot, int p_blade) {
	return { load<T>(&p_from[0][p_knot][p_blade]), load<T>(&p_from[1][p_knot][p_blade]), load<T>(&p_from[2][p_knot][p_blade]) };
}
template <class T, int N>
GRASS_INLINE void store_knot(const Vec3<T> &p_value, float (&r_to)[3][N][GRASS_BLADES_PER_TILE], int p_knot, int p_blade) {
	store(p_value.x, &r_to[0][p_knot][p_blade]);
	store(p_value.y, &r_to[1][p_knot][p_blade]);
	store(p_value.z, &r_to[2][p_knot][p_blade]);
}

// Loads the knots and twists of blades from p_first on: every knot, or of a halved chain every second one, [Eq 51].
template <class T> GRASS_INLINE void load_chain(const TileState &p_state, int p_first, Blade<T> &r_blade) {
	r_blade.is_halved = p_state.is_halved;
	r_blade.tip = (r_blade.is_halved ? GRASS_HALVED_KNOTS : GRASS_KNOTS) - 1;
	for (int k = 0; k <= r_blade.tip; k++) {
		const int knot = whole_knot(k, r_blade.is_halved), free = knot - GRASS_CLAMPED_KNOTS;
		r_blade.rest[k] = load_knot<T>(p_state.rest, knot, p_first);
		r_blade.knots[k] = free < 0 ? r_blade.rest[k] : load_knot<T>(p_state.knots, free, p_first);
		r_blade.before[k] = free < 0 ? r_blade.rest[k] : load_knot<T>(p_state.before, free, p_first);
		if (free < 0) {
			continue;
		}
		r_blade.twist[k - 1] = load<T>(&p_state.twist[free][p_first]);
		if (r_blade.is_halved) {
			r_blade.between[k] = load_knot<T>(p_state.rest, knot - 1, p_first);
			r_blade.twist[k - 1] = r_blade.twist[k - 1] + load<T>(&p_state.twist[free - 1][p_first]);
		}
	}
}

// [Eq 51] Puts the knot that a halved chain leaves out below knot p_k to its place. Its place before the step is where it was put then,
// unless p_k stands still.
template <class T> GRASS_INLINE void store_between(const Blade<T> &p_blade, int p_k, int p_first, TileState &r_state) {
	const int free = whole_knot(p_k, true) - 1 - GRASS_CLAMPED_KNOTS;
	const Vec3<T> place = p_blade.between[p_k] +
			offset_between(p_blade.knots[p_k - 1], p_blade.knots[p_k], p_blade.rest[p_k - 1], p_blade.rest[p_k], p_blade.between[p_k]);
	const auto stands = !(sum_of(p_blade.knots[p_k] - p_blade.before[p_k]) > T(0.0f));
	store_knot(select(stands, place, load_knot<T>(r_state.knots, free, p_first)), r_state.before, free, p_first);
	store_knot(place, r_state.knots, free, p_first);
}

// Stores them. The joints of a halved chain share their twist with those that it leaves out.
template <class T> GRASS_INLINE void store_chain(const Blade<T> &p_blade, int p_first, TileState &r_state) {
	for (int k = GRASS_CLAMPED_KNOTS; k <= p_blade.tip; k++) {
		const int free = whole_knot(k, p_blade.is_halved) - GRASS_CLAMPED_KNOTS;
		T twist = p_blade.twist[k - 1];
		if (p_blade.is_halved) {
			twist = twist * T(0.5f);
			store(twist, &r_state.twist[free - 1][p_first]);
			store_between(p_blade, k, p_first, r_state);
		}
		store_knot(p_blade.knots[k], r_state.knots, free, p_first);
		store_knot(p_blade.before[k], r_state.before, free, p_first);
		store(twist, &r_state.twist[free][p_first]);
	}
}

GRASS_INLINE float largest(float p_value) {
	return p_value;
}
GRASS_INLINE float largest(double p_value) {
	return float(p_value);
}
template <class T> GRASS_INLINE float largest(const T &p_value) {
	float most = 0.0f; // so that a lane with NaN does not hide the others
	for (int lane = 0; lane < T::COUNT; lane++) {
		most = std::max(most, p_value[lane]);
	}
	return most;
}

// Returns a number of each lane's own species. p_species: points to the first lane's blade.
template <class T>
GRASS_INLINE T own_number(std::span<const GrassStep> p_steps, const uint8_t *p_species, float vec4::*p_part, vec4 GrassStep::*p_of) {
	alignas(64) float own[LANE_COUNT<T>];
	for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
		own[lane] = p_steps[p_species[lane]].*p_of.*p_part;
	}
	return load<T>(own);
}

// Sets the terms that depend on the species.
template <class T> GRASS_INLINE void take_species(StepTerms<T> &r_terms, std::span<const GrassStep> p_steps, const uint8_t *p_species) {
	const auto own = [&](vec4 GrassStep::*p_of, float vec4::*p_part) { return own_number<T>(p_steps, p_species, p_part, p_of); };
	r_terms.keep = own(&GrassStep::pbd_motion, &vec4::x);
	r_terms.pull = own(&GrassStep::pbd_motion, &vec4::y);
	r_terms.pull_root = own(&GrassStep::pbd_motion, &vec4::z);
	r_terms.load = { own(&GrassStep::load, &vec4::x), own(&GrassStep::load, &vec4::y), own(&GrassStep::load, &vec4::z) };
	const T even = own(&GrassStep::chain, &vec4::z);
	r_terms.bending = even * own(&GrassStep::free_motion, &vec4::z);
	r_terms.drag = own(&GrassStep::chain, &vec4::w);
	r_terms.free_span = own(&GrassStep::free_motion, &vec4::x);
	r_terms.thins = own(&GrassStep::free_motion, &vec4::y);
	r_terms.first_joint = own(&GrassStep::free_motion, &vec4::w);
	r_terms.wild_move = T(WILD * p_steps[0].chain.x) * square_root(even);
	r_terms.energy_at_tip = own(&GrassStep::energy, &vec4::y);
	r_terms.energy_at_root = own(&GrassStep::energy, &vec4::z);
	r_terms.stiffer = own(&GrassStep::energy, &vec4::w);
}

// [Eq W6]
template <class T> GRASS_INLINE void add_air_load(StepTerms<T> &r_terms, const AirLoad &p_air, int p_first) {
	const Vec3<T> accelerated = { load<T>(&p_air.load[0][p_first]), load<T>(&p_air.load[1][p_first]), load<T>(&p_air.load[2][p_first]) };
	const T drag = load<T>(&p_air.drag[p_first]);
	r_terms.load = r_terms.load + accelerated * (r_terms.is_direct ? T(1.0f) : r_terms.free_span * r_terms.free_span);
	r_terms.drag = r_terms.drag + drag;
	r_terms.keep = r_terms.keep / (T(1.0f) + drag * r_terms.seconds);
}

template <class T>
GRASS_INLINE float step_tile(
		TileState &r_state, std::span<const GrassStep> p_steps, float p_blend, std::span<const TileCollider> p_colliders) {
	StepTerms<T> terms = make_terms<T>(p_steps[0], p_blend, p_colliders, r_state.is_far);
	float liveliest = 0.0f;
	for (int first = 0; first < GRASS_BLADES_PER_TILE - r_state.left_out; first += LANE_COUNT<T>) {
		if (p_steps.size() > 1) {
			take_species(terms, p_steps, &r_state.species[first]);
		}
		Blade<T> blade;
		load_chain(r_state, first, blade);
		blade.width = { load<T>(&r_state.width[0][first]), T(0.0f), load<T>(&r_state.width[1][first]) };
		blade.root = { load<T>(&r_state.root[0][first]), load<T>(&r_state.root[1][first]), load<T>(&r_state.root[2][first]) };
		blade.calm = load<T>(&r_state.calm[first]);
		liveliest = std::max(liveliest, largest(measure_energy(blade, terms)));
		StepTerms<T> own = terms;
		if (r_state.air != nullptr) {
			add_air_load(own, *r_state.air, first);
		}
		step_blade(blade, own);
		store(blade.calm, &r_state.calm[first]);
		store_chain(blade, first, r_state);
	}
	return liveliest;
}

} // namespace grass
