// SPDX-License-Identifier: MIT
// The effects of changing properties, species, map or fill rule.
#include "nodes/grass_field.h"

#include "core/solver/hang.h"
#include "shared/convert.h"
#include "shared/editor_hooks.h"
#include "shared/main_thread.h"
#include "shared/script_call.h"
#include "shared/watch_resource.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

void GrassField::request_rebuild() {
	stir();
	_life.ask();
	update_gizmos();
	update_configuration_warnings();
}

// The ground beside the cameras is there from the first frame on.
bool GrassField::read_scene() {
	const bool is_first = !_standing.stands() && !_properties.is_streamed;
	_properties.species.set_pull(find_pull(to_eigen(field_transform()).linear()));
	return (!is_first || update_terrain()) && start_fill() && _properties.species.read_plants(*this);
}

void GrassField::set_noise_origin(const Vector2i &p_place) {
	if (_properties.noise_origin != p_place) {
		_properties.noise_origin = p_place;
		request_rebuild();
	}
}

void GrassField::set_species(const TypedArray<GrassSpecies> &p_species) {
	GRASS_MAIN_THREAD_ONLY();
	if (p_species == _properties.species.get()) {
		return;
	}
	_properties.species.set(p_species, callable_mp(this, &GrassField::_species_changed));
	_has_own_species = false;
	request_rebuild();
}

// Colours and frequencies take effect at once; a change of blades makes the field again.
void GrassField::_species_changed() {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_species_changed); // another thread changed a part of the resource
	stir();
	if (!_properties.species.read_plants(*this)) {
		return;
	}
	if (_life.is_waiting() || !_standing.update_species()) {
		request_rebuild();
	}
}

void GrassField::set_map(const Ref<GrassMap> &p_map) {
	GRASS_MAIN_THREAD_ONLY();
	if (!watch_instead(_properties.map, p_map, callable_mp(this, &GrassField::_map_changed), "chunks_changed")) {
		return;
	}
	if (p_map.is_valid()) {
		p_map->wait_for_threads();
	}
	_work.forget_map();
	_filler.forget_map();
	_terrain.read_all(_properties.is_streamed);
	_is_map_bare = is_map_bare();
	request_rebuild();
}

void GrassField::show_map(const Ref<GrassMap> &p_map, std::unique_ptr<ShownMap> p_prepared) {
	set_map(p_map);
	_life.offer(std::move(p_prepared));
}

// A field without a terrain texture has shaders without any code for it.
void GrassField::set_terrain_texture(const Ref<Texture2D> &p_texture) {
	GRASS_MAIN_THREAD_ONLY();
	show_terrain_texture(p_texture, _properties.terrain_colors);
}

// The user's texture takes precedence over the terrain's own.
void GrassField::show_terrain_texture(const Ref<Texture2D> &p_texture, const Ref<Texture2D> &p_colors) {
	const Ref<Texture2D> before = _properties.find_terrain_texture();
	(void)replace(_properties.terrain_texture, p_texture);
	_properties.terrain_colors = p_colors;
	const Ref<Texture2D> now = _properties.find_terrain_texture();
	if (before.is_valid() != now.is_valid()) {
		request_rebuild();
	} else if (before != now) {
		_standing.set_uniform("terrain_texture", now);
	}
}

// Returns whether no grass grows on it, and no rule will fill it.
bool GrassField::is_map_bare() const {
	const Ref<GrassMap> &map = _properties.map;
	return map.is_valid() && map->is_readable() && !_filler.has_live_rule() && map->get_base_density() == 0.0 &&
			!map->get_map().uses(MAP_DENSITY);
}

// The editor reads a node's warnings only when notified, and then redraws the whole scene tree.
void GrassField::watch_bare_map() {
	if (_is_map_bare != is_map_bare()) {
		_is_map_bare = !_is_map_bare;
		update_configuration_warnings();
	}
}

// However often the map changes, it is read once, in the next tick or frame.
void GrassField::_map_changed(const TypedArray<Vector2i> &p_chunks, const Rect2 &p_region) {
	stir();
	end_preview();
	_filler.touch(_properties.map, p_chunks);
	watch_bare_map();
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	for (ShownMap *map : { _standing.get_map(), _life.get_map() }) {
		if (map != nullptr && map->get_map() == _properties.map) {
			map->touch(region);
		}
	}
	_standing.request_draw();
}

void GrassField::preview(const MapShape &p_shape, const Brush &p_brush) {
	ShownMap *map = _standing.get_map();
	if (map != nullptr && map->get_map() == _properties.map) {
		map->preview([&](PaintMap &r_map) { return apply_brush(r_map, p_shape, p_brush); });
		_standing.request_draw();
	}
}

void GrassField::end_preview() {
	ShownMap *map = _standing.get_map();
	if (map != nullptr && map->end_preview()) {
		_standing.request_draw();
	}
}

void GrassField::update_map() {
	if (_standing.is_map_waiting()) {
		stir(); // what it shows then may need another look
	}
	if (!_standing.update_map()) {
		WARN_PRINT_ONCE(vformat(String::utf8("%s: `map` has more painted chunks under the field than the field can show (%d, about "
											 "8 km\u00b2). The rest stays bare. Use several smaller fields."),
				label(), GRASS_MAX_LAYERS));
	}
}

void GrassField::set_fill_rule(const Ref<GrassFillRule> &p_rule) {
	GRASS_MAIN_THREAD_ONLY();
	if (_filler.get_rule() == p_rule || !_filler.set_rule(p_rule, callable_mp(this, &GrassField::_fill_rule_changed), _properties.map)) {
		return;
	}
	_fill_rule_changed();
	notify_property_list_changed();
}

void GrassField::set_fill_live(bool p_live) {
	GRASS_MAIN_THREAD_ONLY();
	if (_filler.is_live() == p_live) {
		return;
	}
	_filler.set_live(p_live, _properties.map);
	update_configuration_warnings();
	notify_property_list_changed();
}

void GrassField::_fill_rule_changed() {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_fill_rule_changed); // another thread changed a part of the resource
	_filler.rule_changed();
	update_configuration_warnings();
}

FieldFiller::Place GrassField::fill_place() const {
	return { field_transform(), MapRegion::of_grid(_properties.grid()),
		Eigen::Vector2d(_properties.noise_origin.x, _properties.noise_origin.y) };
}

// Fills a field that enters the tree completely before its first frame; a field that is in the tree is filled gradually.
bool GrassField::start_fill() {
	if (_filler.is_set() || !is_inside_tree() || !_filler.is_needed(fill_place())) {
		return true;
	}
	if (_properties.map.is_null()) {
		make_map();
	}
	return _filler.start(_properties.map, fill_place(), !_standing.stands() && !_properties.is_streamed);
}

bool GrassField::update_fill() {
	if (!start_fill() || (_filler.is_set() && is_inside_tree() && !_filler.update(_properties.map, fill_place()))) {
		return false;
	}
	return !_filler.is_set() || !_filler.take_finished() || outlives(*this, [&] { emit_signal("fill_finished"); });
}

// Runs for the inspector's button.
void GrassField::_fill_pressed() {
	if (_filler.get_rule().is_valid() && is_inside_tree() && editor_hooks.fill != nullptr) {
		editor_hooks.fill(*this);
	}
}

Callable GrassField::get_fill_button() const {
	return callable_mp(const_cast<GrassField *>(this), &GrassField::_fill_pressed);
}

} // namespace grass
