// SPDX-License-Identifier: MIT
// Chooses which tiles are drawn and cast shadows, and how finely (Fan et al. 2015, sections 3.1 and 5.1). Twin of shaders/lod/cull.glsl.
#pragma once

#include "core/base/tile_grid.h"
#include "core/lod/view.h"
#include "core/map/tile_cover.h"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace grass {

// Offsets of an instance's numbers after its transform: DrawnTile in shaders/draw/drawn_tile.gdshaderinc.
inline constexpr size_t INSTANCE_TILE = 12, INSTANCE_BLADES = 14, INSTANCE_MORPH = 15;

// What culling reads of a field.
struct CullField {
	TileGrid grid;
	float overhang = 0.0f; // how far blades lean out over their tile's square, metres
	float height = 0.0f; // of the tallest blade above its ground, metres
	BladeSize size; // of the mean blade
	uint32_t seed = 0;
	std::array<uint32_t, 2> room = {}; // capacity of the MultiMeshes of picture and shadows, tiles
};

// [Eq L7] [Eq L9] Returns the share of a tile's blades that a camera needs. p_away, p_above: of its eye from the middle of the tile's box,
// along the level and upwards, metres; p_pixel: metres of the tile in one pixel.
float lod_in_sight(const CullField &p_field, const ViewCamera &p_camera, const LodParams &p_lod, const TileCover::Tile &p_ground,
		float p_away, float p_above, float p_pixel);

// Returns whether a camera sees a box within the margin, or its shadow.
bool casts_into(const FieldView &p_view, const ViewCamera &p_camera, const Eigen::Vector3f &p_middle, const Eigen::Vector3f &p_half);

class TileCull {
public:
	using SlotOf = std::function<int(int)>; // returns a tile's slot in the pool; GRASS_NO_SLOT while it sleeps

	// Chooses the tiles again. p_cover: null on level ground that is fully covered by grass. p_levels: of find_levels().
	void choose(const CullField &p_field, const FieldView &p_view, const TileCover *p_cover, const SlotOf &p_slot_of,
			LevelSet p_levels = ALL_LEVELS);

	// Returns the instances of a level by the last choice, GRASS_INSTANCE_FLOATS each.
	std::span<const float> get_instances(int p_level) const { return _instances[size_t(p_level)]; }
	int get_count(int p_level) const { return int(_instances[size_t(p_level)].size()) / GRASS_INSTANCE_FLOATS; }
	// Return for the picture and for shadows: the number of blades drawn, and of tiles that did not fit.
	const std::array<int64_t, 2> &get_blades() const { return _blades; }
	const std::array<int64_t, 2> &get_left_out() const { return _left_out; }
	size_t get_memory_usage() const; // bytes

private:
	void choose_tile(
			const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground, int p_x, int p_z, const SlotOf &p_slot_of);
	// Adds the tile to one of the levels in [p_first, p_end).
	void add_tile(const CullField &p_field, int p_x, int p_z, const LodNeed &p_need, int p_first, int p_end, const SlotOf &p_slot_of);
	// Removes the tiles of the levels in [p_first, p_end) that do not fit. Returns their number.
	int64_t leave_out(int p_first, int p_end, uint32_t p_room, uint32_t p_seed);
	int64_t count_blades(int p_first, int p_end) const;

	LevelSet _levels = ALL_LEVELS; // to choose from
	std::array<std::vector<float>, GRASS_ALL_LEVELS> _instances;
	std::array<int64_t, 2> _blades = {}, _left_out = {};
};

} // namespace grass
