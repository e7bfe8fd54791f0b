// SPDX-License-Identifier: MIT
// GrassField's resources and its terrain: setting them, and what follows when they change.
#include "nodes/grass_field.h"

#include "shared/convert.h"
#include "shared/editor_hooks.h"
#include "shared/main_thread.h"
#include "shared/script_call.h"
#include "shared/watch_resource.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

void GrassField::set_noise_origin(const Vector2i &p_place) {
	if (_parts.properties.noise_origin != p_place) {
		_parts.properties.noise_origin = p_place;
		request_rebuild();
	}
}

void GrassField::set_simulated(bool p_simulated) {
	GRASS_MAIN_THREAD_ONLY();
	if (replace(_parts.properties.simulated, p_simulated)) {
		request_rebuild(); // awake tiles return to rest
		_ticks.emit_leaving();
	}
}

void GrassField::set_species(const TypedArray<GrassSpecies> &p_species) {
	GRASS_MAIN_THREAD_ONLY();
	if (p_species == _parts.properties.species.get()) {
		return;
	}
	_parts.properties.species.set(p_species, callable_mp(this, &GrassField::_species_changed));
	request_rebuild();
}

// Colours and frequencies take effect at once; a change of blades makes the field again.
void GrassField::_species_changed() {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_species_changed); // another thread changed a part of the resource
	stir();
	if (!_parts.properties.species.read_plants(*this)) {
		return;
	}
	if (_parts.life.is_waiting() || !_parts.standing.update_species()) {
		request_rebuild();
	}
}

void GrassField::make_map() {
	Ref<GrassMap> map;
	map.instantiate();
	map->set_base_density(1.0);
	set_map(map);
}

void GrassField::set_map(const Ref<GrassMap> &p_map) {
	GRASS_MAIN_THREAD_ONLY();
	if (!watch_instead(_parts.properties.map, p_map, callable_mp(this, &GrassField::_map_changed), "chunks_changed")) {
		return;
	}
	if (p_map.is_valid()) {
		p_map->wait_for_threads();
	}
	_parts.work.forget_map();
	_parts.sources.forget_map();
	request_rebuild();
}

void GrassField::show_map(const Ref<GrassMap> &p_map, std::unique_ptr<ShownMap> p_prepared) {
	set_map(p_map);
	_parts.life.offer(std::move(p_prepared));
}

// Notes a change of the map. However often it changes, it is read once, in the next tick or frame.
void GrassField::_map_changed(const TypedArray<Vector2i> &p_chunks, const Rect2 &p_region) {
	stir();
	end_preview();
	_parts.sources.map_changed(p_chunks);
	const MapRegion region{ to_eigen(p_region.position), to_eigen(p_region.get_end()) };
	for (ShownMap *map : { _parts.standing.get_map(), _parts.life.get_map() }) {
		if (map != nullptr && map->get_map() == _parts.properties.map) {
			map->touch(region);
		}
	}
	_parts.standing.get_picture().request_draw();
}

void GrassField::preview(const MapShape &p_shape, const Brush &p_brush) {
	ShownMap *map = _parts.standing.get_map();
	if (map != nullptr && map->get_map() == _parts.properties.map) {
		map->preview([&](PaintMap &r_map) { return apply_brush(r_map, p_shape, p_brush); });
		_parts.standing.get_picture().request_draw();
	}
}

void GrassField::end_preview() {
	ShownMap *map = _parts.standing.get_map();
	if (map != nullptr && map->end_preview()) {
		_parts.standing.get_picture().request_draw();
	}
}

void GrassField::set_fill_rule(const Ref<GrassFillRule> &p_rule) {
	GRASS_MAIN_THREAD_ONLY();
	_parts.sources.set_fill_rule(p_rule, callable_mp(this, &GrassField::_fill_rule_changed));
}

void GrassField::_fill_rule_changed() {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_fill_rule_changed); // another thread changed a part of the resource
	_parts.sources.rule_changed();
}

// Runs for the inspector's button.
void GrassField::_fill_pressed() {
	if (get_fill_rule().is_valid() && is_inside_tree() && editor_hooks.fill != nullptr) {
		editor_hooks.fill(*this);
	}
}

Callable GrassField::get_fill_button() const {
	return callable_mp(const_cast<GrassField *>(this), &GrassField::_fill_pressed);
}

void GrassField::set_surface_hook(const Ref<ShaderInclude> &p_include) {
	GRASS_MAIN_THREAD_ONLY();
	_parts.settings.set_surface_hook(p_include, callable_mp(this, &GrassField::_hook_changed));
}

// Compiles the hook once the engine has processed the change, since its own shaders depend on the include too.
void GrassField::_hook_changed() {
	callable_mp(this, &GrassField::_compile_hook).call_deferred();
}

void GrassField::_terrain_edited(const AABB &p_area) {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_terrain_edited, p_area);
	if (p_area.is_finite()) {
		_parts.sources.get_terrain_reader().area_changed(p_area);
	}
}

void GrassField::_terrain_replaced() {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_terrain_replaced);
	_parts.sources.get_terrain_reader().anything_changed();
}

void GrassField::_terrain_rectangle_changed(const Rect2 &p_cells) {
	_terrain_cells_changed(p_cells.position.x, p_cells.position.y, p_cells.size.x, p_cells.size.y, 0);
}

void GrassField::_terrain_cells_changed(double p_x, double p_y, double p_width, double p_height, int64_t p_channel) {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_terrain_cells_changed, p_x, p_y, p_width, p_height, p_channel);
	const Vector2 first{ real_t(p_x), real_t(p_y) }, count{ real_t(p_width), real_t(p_height) };
	(void)_parts.sources.get_terrain_reader().cells_changed(first, count); // nothing may follow this
}

bool GrassField::_set(const StringName &p_name, const Variant &p_value) {
	if (!FieldHook::is_property(p_name)) {
		return false;
	}
	GRASS_MAIN_THREAD_ONLY_V(true);
	_parts.properties.hook.set_property(p_name, p_value);
	_parts.properties.hook.hand_on(_parts.standing.get_picture().setter());
	return true;
}

bool GrassField::_get(const StringName &p_name, Variant &r_value) const {
	if (!FieldHook::is_property(p_name)) {
		return false;
	}
	GRASS_MAIN_THREAD_ONLY_V(false);
	r_value = _parts.properties.hook.get_property(p_name);
	return true;
}

} // namespace grass
