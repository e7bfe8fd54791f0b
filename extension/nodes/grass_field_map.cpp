// SPDX-License-Identifier: MIT
// GrassField's map: from what was painted to tiles, textures and the blades of awake tiles.
#include "nodes/grass_field.h"

#include "convert.h"
#include "draw/frame_share.h"
#include "nodes/main_thread.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {
// Chunks of the map (64 m) that may change without waiting for anything: less than 1 ms each. More: frames stutter when a large brush is
// used. Less: what is painted with it comes in pieces.
constexpr int CHUNKS_AT_ONCE = 4;
} // namespace

void GrassField::set_map(const Ref<GrassMap> &p_map) {
	GRASS_MAIN_THREAD_ONLY();
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
	_is_map_bare = is_map_bare();
	request_rebuild();
}

// Nothing grows on it, nor will by a rule.
bool GrassField::is_map_bare() const {
	const bool is_filled = _fill.rule.is_valid() && _fill.is_live;
	return _map.is_valid() && _map->is_readable() && !is_filled && _map->get_base_density() == 0.0 && !_map->get_map().uses(MAP_DENSITY);
}

// The editor looks at a node's warnings only when it is told to, and then draws its whole tree of nodes anew.
void GrassField::watch_bare_map() {
	if (_is_map_bare != is_map_bare()) {
		_is_map_bare = !_is_map_bare;
		update_configuration_warnings();
	}
}

// However often the map changes, it is looked at once, at the next tick or frame.
void GrassField::_map_changed(const TypedArray<Vector2i> &p_chunks, const Rect2 &p_region) {
	touch_fill(p_chunks);
	watch_bare_map();
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	for (ShownMap *map : shown_maps()) {
		if (map != nullptr && map->get_map() == _map) {
			map->touch(region);
		}
	}
	request_draw();
}

// All of it, to a backend that has not seen it yet.
void GrassField::show_map() {
	_regrown = {};
	const auto set = [this](const char *p_name, const Variant &p_value) { set_uniform(p_name, p_value); };
	if (!_standing.map) {
		MapTextures::clear_uniforms(set);
		return;
	}
	_standing.map->set_uniforms(set);
	const TileGrid &grid = _standing.setup.grid;
	_backend->set_cover(_standing.map->get_field().get_cover(), { 0, grid.get_tiles_x(), 0, grid.get_tiles_z() });
	_tiles.set_params(tile_params()); // lowest and highest ground
}

// Takes over what changed in the map since the last call: a few chunks at once, more of them as frames have time.
void GrassField::update_map() {
	if (!_standing.map || _standing.map->get_waiting() == 0) {
		return;
	}
	const bool are_few = _standing.map->get_waiting() <= CHUNKS_AT_ONCE;
	const FieldMap::Changes changes = _standing.map->update([are_few] { return are_few || FrameShare::has_time(); });
	if (changes.tiles.count() == 0) {
		return;
	}
	_regrown = _regrown.count() > 0 ? _regrown.joined(changes.tiles) : changes.tiles;
	_standing.map->set_uniforms([this](const char *p_name, const Variant &p_value) { set_uniform(p_name, p_value); });
	_backend->set_cover(_standing.map->get_field().get_cover(), changes.tiles);
	_tiles.set_params(tile_params());
	if (shown_layers()->is_full()) {
		WARN_PRINT_ONCE(vformat(
				"%s: `map` has more painted chunks under the field than it can show (%d, about 8 km\u00b2); the rest stays bare. Use "
				"several smaller fields.",
				label(), GRASS_MAX_LAYERS));
	}
}

// What the map says about a place, as it is now: what the field shows of it, or r_own, where that waits to change. Null without a map.
const MapLayers *GrassField::layers_at(const Eigen::Vector2f &p_place, MapLayers &r_own) const {
	if (_map.is_null()) {
		return nullptr;
	}
	if (_standing.map && _standing.map->get_map() == _map && !_standing.map->get_field().is_waiting_at(p_place)) {
		return shown_layers();
	}
	r_own.reset(_standing.setup.grid, _standing.setup.blade_length());
	r_own = r_own.read(_map->get_map(), p_place);
	return &r_own;
}

// How the blades grow of tiles that woke in this tick, and of those awake below which the map changed.
std::span<const SlotGrowth> GrassField::grow_tiles() {
	_growth.clear();
	if (_standing.blades.is_told()) {
		for (const GrassSlot &slot : _tiles.get_slots()) {
			const bool is_retired = slot.list.w & GRASS_SLOT_RETIRED, is_fresh = slot.list.w & GRASS_SLOT_FRESH;
			if (!is_retired && (is_fresh || _regrown.has(slot.tile.x, slot.tile.y))) {
				_growth.push_back(_standing.blades.grow(slot));
			}
		}
		_regrown = {};
	}
	return _growth;
}

// Metres that the ground rises above or falls below the field.
double GrassField::ground_reach() const {
	return _standing.map ? std::max(-_standing.map->get_field().get_cover()->get_low(), _standing.map->get_field().get_cover()->get_high())
						 : 0.0;
}

// Metres from the lowest ground to the highest.
double GrassField::ground_range() const {
	return _standing.map
			? double(_standing.map->get_field().get_cover()->get_high()) - double(_standing.map->get_field().get_cover()->get_low())
			: 0.0;
}

} // namespace grass
