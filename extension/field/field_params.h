// SPDX-License-Identifier: MIT
// Every number of a GrassField that a user may set, in the inspector's order. The node stores them by this index;
// its properties, clamps, hints and setters all come from this one table.
#pragma once

#include "core/base/tile_grid.h"
#include "core/blades/clump.h"
#include "core/blades/patch.h"
#include "core/blades/wind.h"
#include "core/bodies/motion.h"
#include "core/field/plant_search.h"
#include "core/field/quality.h"
#include "core/lod/lod.h"
#include "core/lod/simulation_budget.h"
#include "core/map/growth.h"
#include "core/paint/ground_band.h"
#include "core/paint/ledges.h"
#include "core/paint/recovery.h"
#include "core/solver/solver_params.h"
#include "core/tiles/tiles.h"
#include "draw/look_params.h"

#include <array>

namespace grass {

// Side of a field. Larger grounds: several fields.
inline constexpr Tunable FIELD_SIZE{ "size", "m", 0.1, 16384.0, 0.1, 32.0 };
// A tile holds 64 blades, so this decides its side: 256 gives 0.5 m. Meadow 150 to 400, lawn 400 to 1500.
inline constexpr Tunable DENSITY{ "density", "/m\u00b2", TileGrid::MIN_DENSITY, TileGrid::MAX_DENSITY, 1.0, 256.0 };
// Tiles this far outside of the view still cast shadows, whatever the light; tiles whose shadow a directional light casts into the view
// always do. 0: shadows by other lights pop at the picture's edge.
inline constexpr Tunable SHADOW_MARGIN{ "shadow_margin", "m", 0.0, 50.0, 0.1, 2.0 };
// Tiles farther from the camera cast no shadow. 0: none does. Beyond 150 shadow maps are coarser than tiles.
inline constexpr Tunable SHADOW_DISTANCE{ "shadow_distance", "m", 0.0, 1000.0, 1.0, 60.0 };

// What must follow when a number changes.
enum class Effect {
	REBUILD, // the field is made again, and all of its grass is at rest
	STEP, // read at the next tick
	UNIFORM, // handed to the shaders under the property's own name; the next frame reads it, too
	TINT, // handed to the shaders with the other numbers of the clumps
	WIND, // handed to the blade shader with the other numbers of the wind
	VIEW, // read at the next frame
};

enum FieldParamId {
	PARAM_DENSITY,
	PARAM_PLANT_NODES_MAX,
	PARAM_FOLLOW_SLOPE,
	PARAM_SPARSE_HEIGHT,
	PARAM_LEDGE_SLOPE,
	PARAM_GROUND_LOW,
	PARAM_GROUND_HIGH,
	PARAM_REGROWTH,
	PARAM_WHEEL_WEAR,
	PARAM_CLUMP_SIZE,
	PARAM_CLUMP_HEIGHT,
	PARAM_CLUMP_LEAN,
	PARAM_CLUMP_TINT,
	PARAM_FRICTION,
	PARAM_SWING_SPEED_MAX,
	PARAM_ITERATIONS,
	PARAM_CONTACT_RATE,
	PARAM_CONTACT_DISTANCE,
	PARAM_SIMULATION_BUDGET,
	PARAM_SLEEP_MOTION,
	PARAM_SLEEP_DELAY,
	PARAM_SETTLE_TIME,
	PARAM_TELEPORT_SPEED,
	PARAM_WIND_SPEED,
	PARAM_WIND_DIRECTION,
	PARAM_GUST_SIZE,
	PARAM_GUST_STRENGTH,
	PARAM_BORDER_FADE,
	PARAM_BORDER_WAVER,
	PARAM_SOIL_SCALE,
	PARAM_BARE_SOIL,
	PARAM_TERRAIN_BLEND,
	PARAM_ROOT_SHADE,
	PARAM_BACK_LIGHT,
	PARAM_SHEEN,
	PARAM_GLOSS,
	PARAM_WETNESS,
	PARAM_SNOW,
	PARAM_LOD_FAR,
	PARAM_LOD_ERROR,
	PARAM_PIXELS_MIN,
	PARAM_THIN_WIDENING,
	PARAM_SHADOW_DISTANCE,
	PARAM_SHADOW_COARSENESS,
	PARAM_SHADOW_MARGIN,
	PARAM_DRAWN_TILES_MAX,
	PARAM_COUNT,
};

struct FieldParam {
	FieldParamId id;
	Tunable tunable;
	Effect effect;
	const char *group; // of the inspector
	QualityFactorId factor = QUALITY_FACTORS; // by which the level of quality scales it; QUALITY_FACTORS: it does not
};

inline constexpr std::array FIELD_PARAMS = {
	FieldParam{ PARAM_DENSITY, DENSITY, Effect::REBUILD, "Field" },
	FieldParam{ PARAM_PLANT_NODES_MAX, PLANT_NODES_MAX, Effect::STEP, "Field" },
	FieldParam{ PARAM_FOLLOW_SLOPE, FOLLOW_SLOPE, Effect::REBUILD, "Map" },
	FieldParam{ PARAM_SPARSE_HEIGHT, SPARSE_HEIGHT, Effect::REBUILD, "Map" },
	FieldParam{ PARAM_LEDGE_SLOPE, LEDGE_SLOPE, Effect::STEP, "Map" }, // read when ground is
	FieldParam{ PARAM_GROUND_LOW, GROUND_LOW, Effect::STEP, "Map" }, // read when ground is
	FieldParam{ PARAM_GROUND_HIGH, GROUND_HIGH, Effect::STEP, "Map" },
	FieldParam{ PARAM_REGROWTH, REGROWTH, Effect::VIEW, "Map" },
	FieldParam{ PARAM_WHEEL_WEAR, WHEEL_WEAR, Effect::VIEW, "Map" },
	FieldParam{ PARAM_CLUMP_SIZE, CLUMP_SIZE, Effect::REBUILD, "Clumps" },
	FieldParam{ PARAM_CLUMP_HEIGHT, CLUMP_HEIGHT, Effect::REBUILD, "Clumps" },
	FieldParam{ PARAM_CLUMP_LEAN, CLUMP_LEAN, Effect::REBUILD, "Clumps" },
	FieldParam{ PARAM_CLUMP_TINT, CLUMP_TINT, Effect::TINT, "Clumps" },
	FieldParam{ PARAM_FRICTION, FRICTION, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_SWING_SPEED_MAX, SWING_SPEED_MAX, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_ITERATIONS, ITERATIONS, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_CONTACT_RATE, CONTACT_RATE, Effect::STEP, "Simulation", QUALITY_CONTACT_RATE },
	FieldParam{ PARAM_CONTACT_DISTANCE, CONTACT_DISTANCE, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_SIMULATION_BUDGET, SIMULATION_BUDGET, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_SLEEP_MOTION, SLEEP_MOTION, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_SLEEP_DELAY, SLEEP_DELAY, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_SETTLE_TIME, SETTLE_TIME, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_TELEPORT_SPEED, TELEPORT_SPEED, Effect::STEP, "Simulation" },
	FieldParam{ PARAM_WIND_SPEED, WIND_SPEED, Effect::WIND, "Wind" },
	FieldParam{ PARAM_WIND_DIRECTION, WIND_DIRECTION, Effect::WIND, "Wind" },
	FieldParam{ PARAM_GUST_SIZE, GUST_SIZE, Effect::WIND, "Wind" },
	FieldParam{ PARAM_GUST_STRENGTH, GUST_STRENGTH, Effect::WIND, "Wind" },
	FieldParam{ PARAM_BORDER_FADE, BORDER_FADE, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_BORDER_WAVER, BORDER_WAVER, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_SOIL_SCALE, SOIL_SCALE, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_BARE_SOIL, BARE_SOIL, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_TERRAIN_BLEND, TERRAIN_BLEND, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_ROOT_SHADE, ROOT_SHADE, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_BACK_LIGHT, BACK_LIGHT, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_SHEEN, SHEEN, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_GLOSS, GLOSS, Effect::UNIFORM, "Look" },
	FieldParam{ PARAM_WETNESS, WETNESS, Effect::UNIFORM, "Surface" },
	FieldParam{ PARAM_SNOW, SNOW, Effect::UNIFORM, "Surface" },
	FieldParam{ PARAM_LOD_FAR, LOD_FAR, Effect::VIEW, "Level of Detail", QUALITY_LOD_FAR },
	FieldParam{ PARAM_LOD_ERROR, LOD_ERROR, Effect::VIEW, "Level of Detail", QUALITY_LOD_ERROR },
	FieldParam{ PARAM_PIXELS_MIN, PIXELS_MIN, Effect::UNIFORM, "Level of Detail", QUALITY_PIXELS_MIN },
	FieldParam{ PARAM_THIN_WIDENING, THIN_WIDENING, Effect::UNIFORM, "Level of Detail" },
	FieldParam{ PARAM_SHADOW_DISTANCE, SHADOW_DISTANCE, Effect::UNIFORM, "Level of Detail", QUALITY_SHADOW_DISTANCE },
	FieldParam{ PARAM_SHADOW_COARSENESS, SHADOW_COARSENESS, Effect::UNIFORM, "Level of Detail", QUALITY_SHADOW_COARSENESS },
	FieldParam{ PARAM_SHADOW_MARGIN, SHADOW_MARGIN, Effect::VIEW, "Level of Detail" },
	FieldParam{ PARAM_DRAWN_TILES_MAX, DRAWN_TILES_MAX, Effect::REBUILD, "Level of Detail" },
};

static_assert(is_indexed_by_id(FIELD_PARAMS, PARAM_COUNT));

} // namespace grass
