// SPDX-License-Identifier: MIT
// How the step of a tile, over any lane type, reads and writes what its blades have side by side.
#pragma once

#include "core/base/vector.h"
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

// Returns a number of each lane's own species, or of all if there is one step. p_species: points to the first lane's blade.
template <class T>
GRASS_INLINE T own_number(std::span<const GrassStep> p_steps, const uint8_t *p_species, float vec4::*p_part, vec4 GrassStep::*p_of) {
	alignas(64) float own[LANE_COUNT<T>];
	for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
		own[lane] = p_steps[p_steps.size() > 1 ? p_species[lane] : 0].*p_of.*p_part;
	}
	return load<T>(own);
}

} // namespace grass
