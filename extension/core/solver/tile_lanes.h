// SPDX-License-Identifier: MIT
// How the step of a tile, over any lane type, reads and writes what its blades have side by side.
#pragma once

#include "core/base/vector.h"
#include "core/solver/blade_order.h"
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

// The blades that are in lanes together.
template <class T> struct LaneBlades {
	const uint8_t *at; // by lane
	bool are_neighbors; // they follow each other in the tile

	GRASS_INLINE explicit LaneBlades(const uint8_t *p_at) : at(p_at), are_neighbors(true) {
		for (int lane = 1; lane < LANE_COUNT<T>; lane++) {
			are_neighbors = are_neighbors && at[lane] == at[0] + lane;
		}
	}
};

// Reads a number that all blades of a tile have.
template <class T> GRASS_INLINE T load_own(const float (&p_from)[GRASS_BLADES_PER_TILE], const LaneBlades<T> &p_blades) {
	if (p_blades.are_neighbors) {
		return load<T>(&p_from[p_blades.at[0]]);
	}
	alignas(64) float own[LANE_COUNT<T>];
	for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
		own[lane] = p_from[p_blades.at[lane]];
	}
	return load<T>(own);
}
template <class T> GRASS_INLINE void store_own(const T &p_value, float (&r_to)[GRASS_BLADES_PER_TILE], const LaneBlades<T> &p_blades) {
	if (p_blades.are_neighbors) {
		store(p_value, &r_to[p_blades.at[0]]);
		return;
	}
	alignas(64) float own[LANE_COUNT<T>];
	store(p_value, own);
	for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
		r_to[p_blades.at[lane]] = own[lane];
	}
}

template <class T, int N>
GRASS_INLINE Vec3<T> load_knot(const float (&p_from)[3][N][GRASS_BLADES_PER_TILE], int p_knot, const LaneBlades<T> &p_blades) {
	return { load_own(p_from[0][p_knot], p_blades), load_own(p_from[1][p_knot], p_blades), load_own(p_from[2][p_knot], p_blades) };
}
template <class T, int N>
GRASS_INLINE void store_knot(
		const Vec3<T> &p_value, float (&r_to)[3][N][GRASS_BLADES_PER_TILE], int p_knot, const LaneBlades<T> &p_blades) {
	store_own(p_value.x, r_to[0][p_knot], p_blades);
	store_own(p_value.y, r_to[1][p_knot], p_blades);
	store_own(p_value.z, r_to[2][p_knot], p_blades);
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

// Returns a number of each lane's own species, or of all if there is one step. p_species: by blade of the tile.
template <class T>
GRASS_INLINE T own_number(std::span<const GrassStep> p_steps, const uint8_t *p_species, const LaneBlades<T> &p_blades, float vec4::*p_part,
		vec4 GrassStep::*p_of) {
	alignas(64) float own[LANE_COUNT<T>];
	for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
		own[lane] = p_steps[p_steps.size() > 1 ? p_species[p_blades.at[lane]] : 0].*p_of.*p_part;
	}
	return load<T>(own);
}

// Returns the order in which a step takes the first p_count blades of a tile. p_find_work: that of the blades in lanes.
template <class T, class FindWork> GRASS_INLINE BladeOrder find_order(int p_count, const FindWork &p_find_work) {
	uint8_t work[GRASS_BLADES_PER_TILE];
	for (int first = 0; first < p_count; first += LANE_COUNT<T>) {
		uint8_t blades[LANE_COUNT<T>];
		for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
			blades[lane] = uint8_t(first + lane);
		}
		alignas(64) float found[LANE_COUNT<T>];
		store(p_find_work(LaneBlades<T>(blades)), found);
		for (int lane = 0; lane < LANE_COUNT<T>; lane++) {
			work[first + lane] = uint8_t(found[lane]);
		}
	}
	return order_blades(std::span(work, size_t(p_count)), LANE_COUNT<T>);
}

} // namespace grass
