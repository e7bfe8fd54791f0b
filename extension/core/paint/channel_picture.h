// SPDX-License-Identifier: MIT
// A channel of a map as the pixels of a picture, one a texel, and back. Bytes hold codes: black is 0, white the channel's highest code.
// Floats hold values, as PaintMap::sample() returns them; NaN leaves a texel as it is. A channel of two components uses red and green.
#pragma once

#include "core/paint/brush.h"

#include <optional>
#include <string>

namespace grass {

// Texels of a channel, from i, j on.
struct TexelRect {
	int i = 0, j = 0, width = 0, depth = 0;

	size_t count() const { return size_t(width) * size_t(depth); }
};

// How a picture's pixels are stored, row by row.
struct PixelFormat {
	int colors = 1; // 1: grey, or only red
	bool has_alpha = false;
	bool is_float = false; // otherwise bytes

	int numbers() const { return colors + (has_alpha ? 1 : 0); }
	size_t bytes() const { return size_t(numbers()) * (is_float ? 4 : 1); }
	bool operator==(const PixelFormat &) const = default;
};

using Pixels = std::vector<uint8_t>;

// Returns the format of a channel's picture.
PixelFormat picture_format(MapChannel p_channel, bool p_is_float);
// Returns all texels that a region meets. It must be within the map's reach.
TexelRect texels_in(MapChannel p_channel, const MapRegion &p_region);
// Returns the rectangle around the chunks that have the channel; none if no chunk has it.
std::optional<MapRegion> find_painted(const PaintMap &p_map, MapChannel p_channel);

// Returns the pixels, in the channel's picture_format().
Pixels read_pixels(const PaintMap &p_map, MapChannel p_channel, const TexelRect &p_rect, bool p_is_float);

struct LaidPicture : BrushResult { // amount: 0
	std::string reason; // why it was refused, and what to do, following the picture's name; "": it is in the map
	size_t clamped = 0; // texels with a value outside of the channel's limits
};

// Writes pixels, or leaves r_map as it was. Densities that change count as painted by hand: rules do not fill over them. Where heights
// change, normals and ledges follow.
LaidPicture lay_picture(
		PaintMap &r_map, MapChannel p_channel, const TexelRect &p_rect, std::span<const uint8_t> p_pixels, const PixelFormat &p_format);

} // namespace grass
