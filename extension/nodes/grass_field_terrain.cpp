// SPDX-License-Identifier: MIT
// GrassField's terrain: setting it, reading it, and listening to it.
#include "nodes/grass_field.h"

#include "shared/main_thread.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

void GrassField::set_terrain(const NodePath &p_path) {
	GRASS_MAIN_THREAD_ONLY();
	stir();
	if (_terrain.get_path() == p_path) {
		_terrain.look_soon();
		return;
	}
	_terrain.set_path(p_path);
	_filler.set_terrain(nullptr);
	update_configuration_warnings();
}

// Runs when the field has its properties, and once in each frame. Returns false if a script freed the field.
bool GrassField::update_terrain() {
	const TerrainSource::Handlers handlers{ callable_mp(this, &GrassField::_terrain_edited),
		callable_mp(this, &GrassField::_terrain_replaced), callable_mp(this, &GrassField::_terrain_cells_changed),
		callable_mp(this, &GrassField::_terrain_rectangle_changed) };
	if (!_terrain.look(field_transform(), MapRegion::of_grid(_properties.grid()), handlers)) {
		return false;
	}
	_filler.set_terrain(_terrain.get_ids());
	if (is_inside_tree() && _terrain.can_read()) {
		if (_properties.map.is_null()) {
			make_map();
		}
		const double ledge_slope = _properties.param(PARAM_LEDGE_SLOPE);
		if (!_terrain.read(_properties.map, ledge_slope, [this](const MapRegion &p_region) { _filler.touch_textures(p_region); })) {
			return false;
		}
	}
	if (const Ref<Texture2D> colors = _terrain.get_colors(); _properties.terrain_colors != colors) {
		show_terrain_texture(_properties.terrain_texture, colors);
	}
	if (_terrain.has_new_warning()) {
		report_warnings();
	}
	return true;
}

void GrassField::terrain_changed(const AABB &p_area) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_COND_MSG(!p_area.is_finite(), message("terrain_changed() needs a finite area, or an empty one for everything."));
	_terrain.area_changed(p_area);
}

// Signals of a terrain may arrive on any thread.
void GrassField::_terrain_edited(const AABB &p_area) {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_terrain_edited, p_area);
	if (p_area.is_finite()) {
		_terrain.area_changed(p_area);
	}
}

void GrassField::_terrain_replaced() {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_terrain_replaced);
	_terrain.anything_changed();
}

void GrassField::_terrain_rectangle_changed(const Rect2 &p_cells) {
	_terrain_cells_changed(p_cells.position.x, p_cells.position.y, p_cells.size.x, p_cells.size.y, 0);
}

void GrassField::_terrain_cells_changed(double p_x, double p_y, double p_width, double p_height, int64_t p_channel) {
	GRASS_LATER_ON_MAIN_THREAD(&GrassField::_terrain_cells_changed, p_x, p_y, p_width, p_height, p_channel);
	(void)_terrain.cells_changed(Vector2(real_t(p_x), real_t(p_y)), Vector2(real_t(p_width), real_t(p_height))); // nothing may follow this
}

} // namespace grass
