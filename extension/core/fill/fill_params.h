// SPDX-License-Identifier: MIT
// Every number of a fill rule that a user may set, in the inspector's order. GrassFillRule stores them by this index.
#pragma once

#include "core/base/tunable.h"

#include <array>

namespace grass {

enum FillParamId {
	FILL_DENSITY,
	FILL_SLOPE_MIN,
	FILL_SLOPE_MAX,
	FILL_SLOPE_FADE,
	FILL_HEIGHT_MIN,
	FILL_HEIGHT_MAX,
	FILL_HEIGHT_FADE,
	FILL_NOISE_COVER,
	FILL_NOISE_SIZE,
	FILL_NOISE_FADE,
	FILL_DISTANCE,
	FILL_DISTANCE_FADE,
	FILL_EXCLUSION_HEIGHT,
	FILL_EXCLUSION_FADE,
	FILL_PARAM_COUNT,
};

inline constexpr std::array<Tunable, FILL_PARAM_COUNT> FILL_PARAMS = { {
		// The density where no other condition reduces it.
		{ "density", "", 0.0, 1.0, 0.01, 1.0 },
		// The slopes of the ground on which grass grows, and how far beyond these limits it fades out. Normals are stored to about half a
		// degree, so smaller fades become steps.
		{ "slope_min", "\u00b0", 0.0, 90.0, 0.1, 0.0 },
		{ "slope_max", "\u00b0", 0.0, 90.0, 0.1, 90.0 },
		{ "slope_fade", "\u00b0", 0.0, 90.0, 0.1, 5.0 },
		{ "height_min", "m", -16384.0, 16384.0, 0.1, -16384.0 },
		{ "height_max", "m", -16384.0, 16384.0, 0.1, 16384.0 },
		{ "height_fade", "m", 0.0, 1000.0, 0.1, 1.0 },
		// Share of the ground that the noise leaves covered by grass; 1: no noise.
		{ "noise_cover", "", 0.0, 1.0, 0.01, 1.0 },
		// Distance from one patch of noise to the next. Patches below 2 m are smaller than the map's texels.
		{ "noise_size", "m", 1.0, 1000.0, 0.1, 12.0 },
		// 0: patches have hard borders; 1: density rises and falls all the way.
		{ "noise_fade", "", 0.0, 1.0, 0.01, 0.3 },
		// The distance kept clear around the nodes of `distance_group`.
		{ "distance", "m", 0.0, 1000.0, 0.1, 1.0 },
		{ "distance_fade", "m", 0.0, 1000.0, 0.1, 1.0 },
		// Shapes that begin higher above the ground than this do not affect the grass.
		{ "exclusion_height", "m", 0.0, 1000.0, 0.1, 1.0 },
		{ "exclusion_fade", "m", 0.0, 100.0, 0.05, 0.25 },
} };

} // namespace grass
