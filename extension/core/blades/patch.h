// SPDX-License-Identifier: MIT
// The patch (paper 3.1): 16,384 blades made once; every tile of the field borrows 64 consecutive ones. May include Eigen, never Godot.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/tunable.h"
#include "core/blades/blade_types.h"

namespace grass {

inline constexpr Tunable PATCH_SEED{ "seed", "", 0.0, 4294967295.0, 1.0, 1.0 };
// Lengths of 0 make an empty patch. Blades longer than about three tiles reach beyond the bounds that wake tiles; below 0.05 m a meadow
// looks like moss.
inline constexpr Tunable LENGTH_MIN{ "length_min", "m", 0.0, 3.0, 0.01, 0.3 };
inline constexpr Tunable LENGTH_MAX{ "length_max", "m", 0.0, 3.0, 0.01, 0.7 };
// Full width at the root. Beyond 0.05 m blades look like reed or leaves.
inline constexpr Tunable WIDTH_MIN{ "width_min", "m", 0.0005, 0.2, 0.0005, 0.01 };
inline constexpr Tunable WIDTH_MAX{ "width_max", "m", 0.0005, 0.2, 0.0005, 0.02 };
// Shares of the blade types, relative to each other; all 0 make an empty patch.
inline constexpr std::array<Tunable, BLADE_TYPES.size()> TYPE_WEIGHTS{ {
		{ "weight_upright", "", 0.0, 1.0, 0.01, 0.25 },
		{ "weight_arched", "", 0.0, 1.0, 0.01, 0.35 },
		{ "weight_drooping", "", 0.0, 1.0, 0.01, 0.25 },
		{ "weight_wavy", "", 0.0, 1.0, 0.01, 0.15 },
} };

// Values outside the range of their Tunable are clamped, NaN becomes the default, and a maximum below its minimum becomes the minimum.
struct PatchParams {
	uint32_t seed = uint32_t(PATCH_SEED.initial);
	double length_min = LENGTH_MIN.initial; // metres
	double length_max = LENGTH_MAX.initial;
	double width_min = WIDTH_MIN.initial; // metres, full width at the root
	double width_max = WIDTH_MAX.initial;
	std::array<double, BLADE_TYPES.size()> weights; // shares, in the order of BLADE_TYPES

	PatchParams();
};

// Blades as the patch texture holds them, and values derived from them. Immutable once made.
struct Patch {
	static constexpr int WIDTH = GRASS_KNOTS * GRASS_PATCH_BLADES_PER_ROW; // texels
	static constexpr int HEIGHT = GRASS_PATCH_BLADES / GRASS_PATCH_BLADES_PER_ROW;

	std::vector<uint16_t> texels; // 16-bit floats, 4 a texel, WIDTH x HEIGHT row by row for each species; zeros if empty
	int species = 1; // number of species, whose blades are stored one below the other
	const char *empty_because = nullptr; // why there are no blades, for a warning; nullptr if there are
	float max_length = 0.0f; // metres, along the blade
	float max_spread = 0.0f; // metres, horizontally from the root
	float max_height = 0.0f; // metres, above the root
	float mean_height = 0.0f; // metres, of the blades' highest knots
	float mean_length = 0.0f, mean_width = 0.0f; // metres: along the blade, full width at the root

	bool is_empty() const { return empty_because != nullptr; }
	// Returns the index of the first of the four halves of knot p_knot of blade p_blade. The blades of species s begin at
	// GRASS_PATCH_BLADES s.
	static size_t texel_index(int p_blade, int p_knot) {
		const size_t row = size_t(p_blade / GRASS_PATCH_BLADES_PER_ROW), column = size_t(p_blade % GRASS_PATCH_BLADES_PER_ROW);
		return ((row * GRASS_KNOTS + size_t(p_knot)) * GRASS_PATCH_BLADES_PER_ROW + column) * 4;
	}
};

// Makes a patch: the same bits for the same parameters, on every machine. p_stop: once it is true, set by any thread, the blades not made
// yet are left out.
Patch generate_patch(const PatchParams &p_params, const std::atomic<bool> *p_stop = nullptr);

// Sets the lengths and heights of a patch of one species from its blades.
void measure_patch(Patch &r_patch);

// The share of a species' blades that grow in tussocks, and about how many there are in one.
inline constexpr Tunable TUSSOCK_SHARE{ "tussock_share", "", 0.0, 1.0, 0.01, 0.0 };
inline constexpr Tunable TUSSOCK_BLADES{ "tussock_blades", "", 4.0, 64.0, 1.0, 16.0, true };
struct Tussocks {
	double share = TUSSOCK_SHARE.initial;
	int blades = int(TUSSOCK_BLADES.initial);
	bool operator==(const Tussocks &) const = default;
};

// Joins the patches of several species into one. Blade b of each has the root of blade b of the first, so that a root is known before its
// species is. p_shares: weights of the species in the means. A species without blades gets some of zero width. p_stems: for each species a
// power of two, the number of its blades that share a root and spread from it; 1 each if empty. p_tussocks: for each species; none if
// empty, or if blades share a root.
Patch join_patches(std::span<const std::shared_ptr<const Patch>> p_patches, std::span<const double> p_shares,
		std::span<const int> p_stems = {}, std::span<const Tussocks> p_tussocks = {});

} // namespace grass
