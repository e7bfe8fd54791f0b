// SPDX-License-Identifier: MIT
// The channels that a painted map stores for each place, and the resolution and codes of each. May include Eigen, never Godot.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace grass {

// Files store these numbers, so new channels must be appended.
enum MapChannel {
	MAP_DENSITY, // share of the field's blades that grow here, 0..1
	MAP_HEIGHT, // share of the blades' own length, 0..1
	MAP_SPECIES, // number of the species
	MAP_TINT, // colour (red, green, blue, 0..1) and its strength (0..1)
	MAP_LEAN, // direction in which the grass is combed, along x and z, -1..1
	MAP_GROUND, // height of the ground, metres above the field
	MAP_NORMAL, // x and z of the ground's unit normal
	MAP_WEAR, // 0 untouched .. 1 trampled bare; permanent
	MAP_CUT, // height at which cut blades end, metres above the ground; MAP_UNCUT: they are not cut
	MAP_PAINT, // density painted by hand, and how much of the rules' filling it covers, 0..1 each (core/paint/hand_paint.h)
	MAP_WEAR_REST, // the fractional part of wear: 1/256 of a code (core/paint/fine_wear.h)
	MAP_HOLE, // 1: a terrain has no ground here, so nothing grows, whatever is painted
	MAP_LEDGE, // which of the four heights around count here, one bit each [Eq M7]; 0: none, so nothing grows (core/paint/ledges.h)
	MAP_CHANNELS,
};

// Side of a square chunk in metres. Chunk (0, 0) begins at the map's origin and extends to its +x, +z side.
inline constexpr double MAP_CHUNK_SIZE = 64.0;

// A value is stored as a whole number, its code: value = (code - zero) * unit.
struct MapChannelInfo {
	const char *name;
	int side; // texels along a chunk
	int components;
	int bytes; // of a code: 1 (unsigned) or 4 (signed, little-endian)
	int32_t lowest, highest; // codes
	int32_t zero;
	double unit;
	std::array<int32_t, 4> initial; // codes where nothing was painted
	bool blends; // between texels; otherwise the nearest one counts

	constexpr double texel_size() const { return MAP_CHUNK_SIZE / side; } // metres
	constexpr size_t chunk_bytes() const { return size_t(side) * size_t(side) * size_t(components) * size_t(bytes); }
	constexpr double value(int32_t p_code) const { return (double(p_code) - zero) * unit; }
	// Returns the nearest code; NaN gives `zero`.
	int32_t code(double p_value) const {
		const double code = std::isnan(p_value) ? double(zero) : std::round(p_value / unit) + zero;
		return int32_t(code < lowest ? double(lowest) : (code > highest ? double(highest) : code));
	}
};

inline constexpr int32_t MAP_UNCUT_CODE = 255;
inline constexpr int32_t MAP_GROUND_LIMIT = 1 << 24; // 16,384 m up and down

inline constexpr std::array<MapChannelInfo, MAP_CHANNELS> MAP_CHANNEL_INFO = { {
		{ "density", 128, 1, 1, 0, 255, 0, 1.0 / 255.0, { 0 }, true },
		{ "height", 64, 1, 1, 0, 255, 0, 1.0 / 255.0, { 255 }, true },
		{ "species", 64, 1, 1, 0, 255, 0, 1.0, { 0 }, false },
		{ "tint", 64, 4, 1, 0, 255, 0, 1.0 / 255.0, { 255, 255, 255, 0 }, true },
		{ "lean", 64, 2, 1, 1, 255, 128, 1.0 / 127.0, { 128, 128 }, true },
		{ "ground", 64, 1, 4, -MAP_GROUND_LIMIT, MAP_GROUND_LIMIT, 0, 1.0 / 1024.0, { 0 }, true },
		{ "normal", 64, 2, 1, 1, 255, 128, 1.0 / 127.0, { 128, 128 }, true },
		{ "wear", 128, 1, 1, 0, 255, 0, 1.0 / 255.0, { 0 }, true },
		{ "cut", 128, 1, 1, 0, MAP_UNCUT_CODE, 0, 0.01, { MAP_UNCUT_CODE }, true },
		{ "paint", 128, 2, 1, 0, 255, 0, 1.0 / 255.0, { 0, 0 }, true },
		{ "wear rest", 128, 1, 1, 0, 255, 0, 1.0 / (255.0 * 256.0), { 0 }, true },
		{ "hole", 64, 1, 1, 0, 1, 0, 1.0, { 0 }, false },
		{ "ledge", 512, 1, 1, 0, 15, 0, 1.0, { 15 }, false },
} };

inline constexpr double MAP_UNCUT = MAP_CHANNEL_INFO[MAP_CUT].value(MAP_UNCUT_CODE); // metres

constexpr const MapChannelInfo &info_of(MapChannel p_channel) {
	return MAP_CHANNEL_INFO[size_t(p_channel)];
}

} // namespace grass
