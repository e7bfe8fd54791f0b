// SPDX-License-Identifier: MIT
// What is drawn of a field that was made: at once, or part by part where it is hidden until all of it is there.
#include "field/standing_field.h"

#include "draw/field_shaders.h"
#include "draw/frame_share.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Of the cover, in one part: 0.3 MB. More: a frame's upload is longer. Fewer: a plot takes more frames to come.
constexpr int TILES_AT_ONCE = 16384;

} // namespace

bool StandingField::show(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	const bool is_hidden = _properties.is_streamed && !p_node->is_visible();
	if (_is_backend_waiting) {
		FrameShare::Turn turn(this);
		if (is_hidden && !turn.has_part()) {
			return true;
		}
		make_backend();
	}
	const Look look = find_look();
	if (!is_look_waiting() || (has_shader_workers() && !prepare_shaders(look))) {
		return true;
	}
	if (!are_compiled(look)) {
		return false;
	}
	if (_is_shown) {
		_backend->set_look(look);
		_ground.set_look(look);
		_look = look;
	} else if (show_parts(look, is_hidden)) {
		_is_shown = true;
		follow(p_node, p_transform);
	} else {
		return true;
	}
	drop_hooked_shaders();
	_properties.hook.hand_on(setter());
	return true;
}

// True once all is done.
bool StandingField::show_parts(const Look &p_look, bool p_is_hidden) {
	if (_parts_shown > 0 && !(_look == p_look)) {
		_parts_shown = _rows_shown = 0;
	}
	FrameShare::Turn turn(this);
	const auto may_go_on = [&turn, p_is_hidden] { return !p_is_hidden || turn.has_part(); };
	while (_parts_shown < PARTS && may_go_on()) {
		show_part(p_look, _parts_shown++);
	}
	const TileGrid &grid = _field.get_grid();
	const int rows = _map ? grid.get_tiles_z() : 0, at_once = p_is_hidden ? std::max(TILES_AT_ONCE / grid.get_tiles_x(), 1) : rows;
	while (_parts_shown == PARTS && _rows_shown < rows && may_go_on()) {
		const int end = std::min(_rows_shown + at_once, rows);
		_backend->set_cover(_map->get_field().get_cover(), { 0, grid.get_tiles_x(), _rows_shown, end });
		FrameShare::count_bytes(int64_t(end - _rows_shown) * grid.get_tiles_x() * int64_t(sizeof(TileCover::Tile)));
		_rows_shown = end;
	}
	return _parts_shown == PARTS && _rows_shown >= rows;
}

void StandingField::show_part(const Look &p_look, int p_part) {
	switch (p_part) {
		case 0:
			_backend->set_look(p_look);
			_look = p_look;
			break;
		case 1:
			_ground.create(_field.get_grid(), p_look);
			_is_carried = false;
			_backend->set_uniform("ground_carries", 0.0);
			break;
		case 2:
			set_plants();
			break;
		case 3:
			_uniforms.set_all(_properties, _field.get_setup(), uniform_setter(true));
			set_wind_clock();
			break;
		case 4:
			set_species_uniforms();
			break;
		case 5:
			if (_map) {
				_map->set_uniforms(uniform_setter(true), true); // a backend knows nothing of what another was told
			} else {
				MapTextures::clear_uniforms(uniform_setter(true));
			}
			break;
	}
}

void StandingField::set_plants() {
	uint32_t with_mesh = 0;
	for (size_t s = 0; s < _plants.size(); s++) {
		with_mesh |= _plants[s].model ? 1u << s : 0u;
	}
	_backend->set_plants(_plants, [this, with_mesh](int p_x, int p_z, std::vector<StandingPlant> &r_plants) {
		_field.get_blades().find_plants(p_x, p_z, with_mesh, r_plants);
	});
}

} // namespace grass
