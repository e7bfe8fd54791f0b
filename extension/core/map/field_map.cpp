// SPDX-License-Identifier: MIT
#include "core/map/field_map.h"

namespace grass {

FieldMap::FieldMap(const TileGrid &p_grid, double p_tallest, float p_follow) : _grid(p_grid), _follow(p_follow) {
	_layers.reset(p_grid, p_tallest);
	_cover->reset(p_grid);
}

FieldMap::Changes FieldMap::update(const PaintMap &p_map, const MapRegion &p_region) {
	Changes changes;
	changes.layers = _layers.update(p_map, p_region);
	changes.tiles = _cover->update(_layers, p_region);
	return changes;
}

size_t FieldMap::get_memory_usage() const {
	constexpr size_t LAYER = size_t(MapLayer::FINE) * MapLayer::FINE * 4 + size_t(MapLayer::COARSE) * MapLayer::COARSE * 13;
	return size_t(_layers.get_count()) * LAYER + _cover->get_memory_usage() + _layers.get_pages().size() * sizeof(float);
}

} // namespace grass
