// SPDX-License-Identifier: MIT
// Fills a map by a rule: writes density, chunk by chunk, below what was painted by hand (core/paint/hand_paint.h). The same rule, sources
// and ground give the same texels, whatever was filled before.
#pragma once

#include "core/base/parallel_for.h"
#include "core/fill/fill_mesh.h"
#include "core/fill/fill_obstacle.h"
#include "core/fill/fill_rule.h"
#include "core/map/map_layers.h"
#include "core/paint/brush.h"

namespace grass {

// What a rule finds in the scene.
struct FillSources {
	std::vector<std::shared_ptr<const FillObstacle>> obstacles;
	std::vector<std::shared_ptr<const FillObstacle>> gone; // FillRule::only_at_obstacles: those whose places are to be filled again
	bool has_mesh = false; // whether a mesh says where grass grows; while it is not loaded yet, none grows
	std::shared_ptr<const FillMesh> mesh;
	std::shared_ptr<const TerrainIds> terrain; // textures of the terrain; null: no terrain reports them

	double texture_share(const FillRule &p_rule, const Eigen::Vector2d &p_at) const {
		return terrain ? p_rule.texture_share(terrain->find(p_at)) : 1.0;
	}
	bool operator==(const FillSources &) const = default; // compares objects by identity
};

struct FillResult : BrushResult { // amount: square metres of full grass added or, if negative, removed
	int64_t cells = 0; // texels for which the rule was evaluated
};

// Returns the chunks that contain an area, ascending; none beyond the map's reach.
std::vector<MapKey> chunks_in(const MapRegion &p_area);

// What happens to the texels around the area that blend into it. The result does not count them.
enum class FillRim { STAYS, FILLED };

// Fills those texels of p_keys (ascending) whose centres are in p_area. Without a p_rule they return to the map's base density.
FillResult fill(PaintMap &r_map, std::span<const MapKey> p_keys, const MapRegion &p_area, const FillRule *p_rule,
		const FillSources &p_sources, const ParallelFor &p_parallel_for = serial_for, FillRim p_rim = FillRim::STAYS);

} // namespace grass
