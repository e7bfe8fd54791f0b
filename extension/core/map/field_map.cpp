// SPDX-License-Identifier: MIT
#include "core/map/field_map.h"

#include "core/blade.h"
#include "core/half.h"

namespace grass {

FieldMap::FieldMap(const TileGrid &p_grid, std::shared_ptr<const Patch> p_patch, const ClumpParams &p_clump, float p_follow) :
		_grid(p_grid), _patch(std::move(p_patch)), _clump(p_clump), _follow(p_follow) {
	_layers.reset(p_grid, double(_patch->max_length) * CLUMP_TALLEST);
	_cover->reset(p_grid);
}

FieldMap::Changes FieldMap::update(const PaintMap &p_map, const MapRegion &p_region) {
	Changes changes;
	changes.layers = _layers.update(p_map, p_region);
	changes.tiles = _cover->update(_layers, p_region);
	return changes;
}

FieldMap::BladePose FieldMap::get_pose(int p_tile_x, int p_tile_z, int p_blade) const {
	const auto knot = [&](int p_knot) {
		const uint16_t *halves = &_patch->texels[Patch::texel_index(p_blade, p_knot)];
		return Eigen::Vector3f(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
	};
	const Eigen::Vector2f place = root_place(Eigen::Vector2f(float(p_tile_x), float(p_tile_z)), knot(0).head<2>(),
			Eigen::Vector2f(float(_grid.get_tiles_x()), float(_grid.get_tiles_z())), float(_grid.get_tile_size()));
	const Growth here = _layers.sample(place, _follow);
	const float length = knot(1).norm() * float(GRASS_SEGMENTS); // all segments are equally long
	return { grown(clump_at(place, _clump), here, length), here.ground, here.density };
}

SlotGrowth FieldMap::grow(const GrassSlot &p_slot) const {
	SlotGrowth growth;
	growth.slot = p_slot.tile.w;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const BladePose pose = get_pose(p_slot.tile.x, p_slot.tile.y, int(p_slot.list.x) + b);
		growth.blades[size_t(b)] = { pose.clump.height, pose.clump.lean.x(), pose.clump.lean.y(), pose.ground };
	}
	return growth;
}

size_t FieldMap::get_memory_usage() const {
	constexpr size_t LAYER = size_t(MapLayer::FINE) * MapLayer::FINE * 4 + size_t(MapLayer::COARSE) * MapLayer::COARSE * 12;
	return size_t(_layers.get_count()) * LAYER + _cover->get_memory_usage() + _layers.get_pages().size() * sizeof(float);
}

} // namespace grass
