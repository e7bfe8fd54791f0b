// SPDX-License-Identifier: MIT
// Finds which tiles are seen: those within one of some frustums (field space), or near it; and from how far.
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
	// Bands of distance from an eye, four for each doubling from a metre on; and the band of what no camera sees.
	static constexpr int FARTHEST = 61, UNSEEN = 63;

	// Sets the frustums. p_margin widens each of them, metres. p_eyes: where each frustum is seen from; none: from everywhere. Before the
	// first call, and after see_all(), everything is seen.
	void see(std::span<const Frustum> p_frustums, float p_margin, std::span<const Eigen::Vector3f> p_eyes = {});
	void see_all() { _sees_all = true; }
	bool sees_all() const { return _sees_all; }
	// Returns true if any tile of the field, or its grass, is seen.
	bool sees_field(const TileGrid &p_grid, const TileParams &p_params) const;
	// Call it before a step in which sees() or get_band() is called.
	void prepare(const TileGrid &p_grid, const TileParams &p_params);
	bool sees(int p_x, int p_z) const;
	// Returns the band of the nearest eye that sees any of these tiles within p_margin metres around its picture, at most see()'s.
	int get_band(const TileRange &p_tiles, float p_margin) const;

private:
	// A frustum for tiles: outside a plane are the tiles with x * first + z * second > third.
	using TileFrustum = std::array<Eigen::Vector3f, 6>;

	int band_from(const Eigen::Vector3f &p_eye, float p_left, float p_right, float p_back, float p_front) const;

	bool _sees_all = true;
	std::vector<Frustum> _frustums;
	std::vector<Eigen::Vector3f> _eyes; // of _frustums, or none
	float _margin = 0.0f; // metres
	// In this step:
	std::vector<TileFrustum> _tile_frustums; // of _frustums
	std::vector<Eigen::Vector3f> _tile_eyes; // of _eyes: column and row; metres above the grass's middle
	float _tile_size = 1.0f; // metres
};

} // namespace grass
