// SPDX-License-Identifier: MIT
// GrassField's map: from what was painted to tiles, textures and the blades of awake tiles.
#include "nodes/grass_field.h"

#include "convert.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

void GrassField::set_map(const Ref<GrassMap> &p_map) {
	const Callable changed = callable_mp(this, &GrassField::_map_changed);
	if (_map.is_valid()) {
		_map->disconnect("chunks_changed", changed);
	}
	_map = p_map;
	_recovery.reset();
	_fill.state = LiveFill();
	if (_map.is_valid()) {
		_map->connect("chunks_changed", changed);
	}
	request_rebuild();
}

// However often the map changes, it is looked at once, at the next tick or frame.
void GrassField::_map_changed(const TypedArray<Vector2i> &p_chunks, const Rect2 &p_region) {
	touch_fill(p_chunks);
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	_changed_region = _map_has_changed ? _changed_region.joined(region) : region;
	_map_has_changed = true;
	request_draw();
}

// Before the backend is made.
void GrassField::build_map() {
	_field_map.reset();
	_map_textures.free();
	_regrown = {};
	_bounds->set_cover(nullptr, 0.0);
	if (_setup.is_mapped && !_setup.patch->is_empty()) {
		_field_map = std::make_unique<FieldMap>(_setup.grid, _setup.blade_length(), _setup.follow_slope);
		_changed_region = _field_map->get_region();
		_map_has_changed = true;
		_bounds->set_cover(_field_map->get_cover(), slope_lean(_setup.follow_slope) * _setup.blade_length());
	}
}

// Takes over what changed in the map since the last call.
void GrassField::update_map() {
	if (!_field_map || !_map_has_changed) {
		return;
	}
	_map_has_changed = false;
	const FieldMap::Changes changes = _field_map->update(_map->get_map(), _changed_region);
	_regrown = _regrown.count() > 0 ? _regrown.joined(changes.tiles) : changes.tiles;
	const auto set = [this](const char *p_name, const Variant &p_value) { set_uniform(p_name, p_value); };
	_map_textures.update(_field_map->get_layers(), changes.layers, _setup.species != nullptr, set);
	set_uniform("map_base_density", _map->get_base_density());
	_backend->set_cover(_field_map->get_cover(), changes.tiles);
	_tiles.set_params(tile_params()); // lowest and highest ground
	if (_field_map->get_layers().is_full()) {
		WARN_PRINT_ONCE(vformat(
				"%s: `map` has more painted chunks under the field than it can show (%d, about 8 km\u00b2); the rest stays bare. Use "
				"several smaller fields.",
				label(), GRASS_MAX_LAYERS));
	}
}

// How the blades grow of tiles that woke in this tick, and of those awake below which the map changed.
std::span<const SlotGrowth> GrassField::grow_tiles() {
	_growth.clear();
	if (_blades.is_told()) {
		for (const GrassSlot &slot : _tiles.get_slots()) {
			const bool is_retired = slot.list.w & GRASS_SLOT_RETIRED, is_fresh = slot.list.w & GRASS_SLOT_FRESH;
			if (!is_retired && (is_fresh || _regrown.has(slot.tile.x, slot.tile.y))) {
				_growth.push_back(_blades.grow(slot));
			}
		}
		_regrown = {};
	}
	return _growth;
}

// Metres that the ground rises above or falls below the field.
double GrassField::ground_reach() const {
	return _field_map ? std::max(-_field_map->get_cover()->get_low(), _field_map->get_cover()->get_high()) : 0.0;
}

// Metres from the lowest ground to the highest.
double GrassField::ground_range() const {
	return _field_map ? double(_field_map->get_cover()->get_high()) - double(_field_map->get_cover()->get_low()) : 0.0;
}

} // namespace grass
