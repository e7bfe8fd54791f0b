// SPDX-License-Identifier: MIT
// Single blades of a field, and the positions of their knots.
#pragma once

#include "core/base/layout.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>

namespace grass {

// The number of a blade in a field: GRASS_BLADES_PER_TILE times its tile's index, plus its index in the tile.
using BladeNumber = int64_t;

constexpr BladeNumber number_of(int p_tile, int p_blade) {
	return BladeNumber(p_tile) * GRASS_BLADES_PER_TILE + p_blade;
}
constexpr int tile_of(BladeNumber p_blade) {
	return int(p_blade / GRASS_BLADES_PER_TILE);
}
constexpr int blade_in_tile(BladeNumber p_blade) {
	return int(p_blade % GRASS_BLADES_PER_TILE);
}

// The knots of a blade from root to tip, metres.
template <typename T> using KnotsOf = std::array<Eigen::Vector3<T>, GRASS_KNOTS>;
// The moving knots of an awake blade, in blade space; the clamped ones are never read. Empty: their positions are unknown.
using SimulatedKnots = std::optional<KnotsOf<float>>;

// The knots as a device reports them: only the free ones, in order.
inline constexpr int KNOT_NUMBERS = 3 * GRASS_FREE_KNOTS;
inline KnotsOf<float> unpack_knots(const float *p_numbers) {
	KnotsOf<float> knots;
	for (size_t knot = 0; knot < GRASS_KNOTS; knot++) {
		if (knot < GRASS_CLAMPED_KNOTS) {
			knots[knot].setZero();
		} else {
			knots[knot] = Eigen::Map<const Eigen::Vector3f>(p_numbers + 3 * (knot - GRASS_CLAMPED_KNOTS));
		}
	}
	return knots;
}

// A blade whose knots are queried.
struct WantedBlade {
	BladeNumber number = 0;
	int slot = GRASS_NO_SLOT; // of its tile; without one the blade is at rest
};

} // namespace grass
