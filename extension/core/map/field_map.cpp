// SPDX-License-Identifier: MIT
#include "core/map/field_map.h"

#include <algorithm>

namespace grass {

FieldMap::FieldMap(const TileGrid &p_grid, double p_tallest, float p_follow) : _grid(p_grid), _follow(p_follow) {
	_layers.reset(p_grid, p_tallest);
	_cover->reset(p_grid);
	touch(get_region());
}

void FieldMap::Changes::add(const Changes &p_changes) {
	layers.insert(layers.end(), p_changes.layers.begin(), p_changes.layers.end());
	tiles = tiles.count() == 0 ? p_changes.tiles : (p_changes.tiles.count() == 0 ? tiles : tiles.joined(p_changes.tiles));
}

void FieldMap::touch(const MapRegion &p_region) {
	for (const MapKey &key : _layers.get_chunks(p_region)) {
		const MapRegion here = p_region.shared(MapRegion::of_chunk(key).grown(MapLayers::CHANGE_MARGIN));
		const auto [entry, is_new] = _waiting.try_emplace({ key.z, key.x }, here);
		if (!is_new) {
			entry->second = entry->second.joined(here);
		}
	}
}

FieldMap::Changes FieldMap::work(const PaintMap &p_map) {
	Changes changes;
	if (_waiting.empty()) {
		return changes;
	}
	const auto [place, region] = *_waiting.begin();
	_waiting.erase(_waiting.begin());
	if (const int layer = _layers.update(p_map, { place.second, place.first }, region); layer != GRASS_NO_LAYER) {
		changes.layers.push_back(layer);
	}
	changes.tiles = _cover->update(_layers, region);
	return changes;
}

FieldMap::Changes FieldMap::update(const PaintMap &p_map, const MapRegion &p_region) {
	touch(p_region);
	Changes changes;
	while (get_waiting() > 0) {
		changes.add(work(p_map));
	}
	return changes;
}

bool FieldMap::is_waiting_at(const Eigen::Vector2f &p_place) const {
	const MapKey key = key_at(p_place.cast<double>());
	return _waiting.contains({ key.z, key.x });
}

int FieldMap::count_painted(const PaintMap &p_map) const {
	const std::vector<MapKey> chunks = _layers.get_chunks(get_region());
	return int(std::count_if(chunks.begin(), chunks.end(),
			[&](const MapKey &p_key) { return _layers.find(p_key) != GRASS_NO_LAYER || p_map.find(p_key) != nullptr; }));
}

size_t FieldMap::get_memory_usage() const {
	constexpr size_t LAYER = size_t(MapLayer::FINE) * MapLayer::FINE * 4 + size_t(MapLayer::COARSE) * MapLayer::COARSE * 13;
	constexpr size_t LEDGES = size_t(GRASS_LEDGE_TEXELS) * GRASS_LEDGE_TEXELS;
	return size_t(_layers.get_count()) * LAYER + _layers.get_ledge_layers().size() * LEDGES + _cover->get_memory_usage() +
			_layers.get_pages().size() * sizeof(float);
}

} // namespace grass
