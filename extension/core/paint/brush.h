// SPDX-License-Identifier: MIT
// Applies brushes to the map. Each tool changes one channel; a game's mower and boots use the same tools.
#pragma once

#include "core/map/map_layers.h"
#include "core/map/map_shape.h"
#include "core/map/paint_map.h"

namespace grass {

enum class MapTool {
	PAINT, // raises density to the target, never lowers it
	ERASE, // lowers density to 0
	SMOOTH, // evens out `channel`
	DENSITY, // moves density to the target, up or down
	HEIGHT, // moves height to the target
	SPECIES, // plants species `target`; mixes it in texel by texel at the soft border
	TINT, // moves the tint to `color`; the target is its strength
	COMB, // leans the grass along `direction`; the target is how far
	CUT, // cuts what is longer than the target, metres, wherever the shape has at least half of its effect
	FLATTEN, // tramples: raises wear to the target
	REGROW, // lets cut grass grow by the target, metres
	RECOVER, // lowers wear by the target
	COUNT,
};

// The ground that a tool may change.
struct MapLimits {
	double slope_min = 0.0, slope_max = 90.0; // degrees from level
	double height_min = -16384.0, height_max = 16384.0; // metres above the field

	bool is_everywhere() const { return slope_min <= 0.0 && slope_max >= 90.0 && height_min <= -16384.0 && height_max >= 16384.0; }
	bool allows(MapReader &r_ground, MapReader &r_normal, const Eigen::Vector2d &p_place) const;
};

struct Brush {
	MapTool tool = MapTool::PAINT;
	double strength = 1.0; // 0..1; values outside are clamped, NaN does nothing
	double target = 1.0; // in units of the tool's channel
	Eigen::Array3d color = Eigen::Array3d::Ones(); // TINT
	Eigen::Vector2d direction = Eigen::Vector2d::Zero(); // COMB: along x, z; its length is ignored
	MapChannel channel = MAP_DENSITY; // SMOOTH
	MapLimits limits;
	MapRegion area{ Eigen::Vector2d::Constant(-1e9), Eigen::Vector2d::Constant(1e9) }; // limits the change; default: everywhere
};

// What a tool did.
struct BrushResult {
	std::vector<MapKey> changed; // chunks, ascending
	Eigen::Vector2d min = Eigen::Vector2d::Zero(), max = Eigen::Vector2d::Zero(); // the rectangle that contains all changes, metres
	// Sum over the texels of the change of their first component times their area: for density, square metres of full grass; for height,
	// cut and wear, their own unit times m^2.
	double amount = 0.0;
	bool out_of_room = false; // part of it was out of reach, or the map is full
};

// Returns the channel that a tool changes.
MapChannel channel_of(const Brush &p_brush);

// Applies one step of a brush. An empty shape or a strength of 0 changes nothing.
BrushResult apply_brush(PaintMap &r_map, const MapShape &p_shape, const Brush &p_brush);

} // namespace grass
