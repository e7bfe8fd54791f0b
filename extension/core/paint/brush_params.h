// SPDX-License-Identifier: MIT
// Every number of a brush that a user may set, in the inspector's order. GrassBrush stores them by this index.
#pragma once

#include "core/base/tunable.h"
#include "core/map/map_channels.h"

namespace grass {

enum BrushParamId {
	BRUSH_RADIUS,
	BRUSH_STRENGTH,
	BRUSH_HARDNESS,
	BRUSH_STAMP_ROTATION,
	BRUSH_STAMP_RANDOM,
	BRUSH_TARGET,
	BRUSH_CUT_HEIGHT,
	BRUSH_SLOPE_MIN,
	BRUSH_SLOPE_MAX,
	BRUSH_HEIGHT_MIN,
	BRUSH_HEIGHT_MAX,
	BRUSH_PARAM_COUNT,
};

inline constexpr std::array<Tunable, BRUSH_PARAM_COUNT> BRUSH_PARAMS = { {
		// Below 0.1 m a brush may miss every texel; above 64 m one step changes a hundred thousand of them.
		{ "radius", "m", 0.1, 64.0, 0.1, 3.0 },
		// Share of the way to the target that one step moves.
		{ "strength", "", 0.0, 1.0, 0.01, 0.5 },
		// Share of the radius that gets the full effect.
		{ "hardness", "", 0.0, 1.0, 0.01, 0.5 },
		// The rotation of the stamp, and the largest random rotation added to each stamp.
		{ "stamp_rotation", "\u00b0", 0.0, 360.0, 1.0, 0.0 },
		{ "stamp_random", "\u00b0", 0.0, 360.0, 1.0, 0.0 },
		// The value that density, height, tint, lean or wear approaches.
		{ "target", "", 0.0, 1.0, 0.01, 1.0 },
		// The height that cutting leaves, and that regrowing adds.
		{ "cut_height", "m", 0.0, MAP_UNCUT, 0.01, 0.05 },
		// The ground that may change; heights above the field.
		{ "slope_min", "\u00b0", 0.0, 90.0, 0.1, 0.0 },
		{ "slope_max", "\u00b0", 0.0, 90.0, 0.1, 90.0 },
		{ "height_min", "m", -16384.0, 16384.0, 0.1, -16384.0 },
		{ "height_max", "m", -16384.0, 16384.0, 0.1, 16384.0 },
} };

} // namespace grass
