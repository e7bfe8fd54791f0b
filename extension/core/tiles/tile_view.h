// SPDX-License-Identifier: MIT
// Finds which tiles are seen: those within one of some frustums (field space), or near it.
#pragma once

#include "core/base/tile_grid.h"
#include "core/lod/lod.h"
#include "core/tiles/tile_params.h"

#include <Eigen/Core>

#include <array>
#include <span>
#include <vector>

namespace grass {

class TileView {
public:
	// p_margin widens every frustum, metres. Before the first call, and after see_all(), everything is seen.
	void see(std::span<const Frustum> p_frustums, float p_margin);
	void see_all() { _sees_all = true; }
	// Returns true if any tile of the field, or its grass, is seen.
	bool sees_field(const TileGrid &p_grid, const TileParams &p_params) const;
	// Call it before a step in which sees() is called.
	void prepare(const TileGrid &p_grid, const TileParams &p_params);
	bool sees(int p_x, int p_z) const;

private:
	// A frustum as tiles meet it: outside of a plane are those with x * first + z * second > third.
	using TileFrustum = std::array<Eigen::Vector3f, 6>;

	bool _sees_all = true;
	std::vector<Frustum> _frustums;
	float _margin = 0.0f; // metres
	std::vector<TileFrustum> _tile_frustums; // of _frustums, in this step
};

} // namespace grass
