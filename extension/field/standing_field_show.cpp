// SPDX-License-Identifier: MIT
// Shows a field that was made: at once, or part by part while it is hidden.
#include "field/standing_field.h"

#include "draw/field_shaders.h"
#include "draw/frame_share.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Tiles of the cover in one part: 0.3 MB. More: a frame's upload takes longer. Fewer: a plot takes more frames to appear.
constexpr int TILES_AT_ONCE = 16384;

} // namespace

bool StandingField::show(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	const bool is_hidden = _properties.is_streamed && !p_node->is_visible();
	if (_part == Part::BACKEND) {
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
	if (is_shown()) {
		_backend->set_look(look);
		_ground.set_look(look);
		_look = look;
	} else {
		show_parts(look, is_hidden);
		if (!is_shown()) {
			return true;
		}
		follow(p_node, p_transform);
	}
	drop_hooked_shaders();
	_properties.hook.hand_on(_set);
	return true;
}

void StandingField::show_parts(const Look &p_look, bool p_is_hidden) {
	if (_part > Part::LOOK && _look != p_look) {
		_part = Part::LOOK;
		_rows_shown = 0;
	}
	FrameShare::Turn turn(this);
	const auto may_go_on = [&turn, p_is_hidden] { return !p_is_hidden || turn.has_part(); };
	while (_part < Part::COVER && may_go_on()) {
		show_part(p_look);
		_part = Part(int(_part) + 1);
	}
	const TileGrid &grid = _field.get_grid();
	const int rows = _map ? grid.get_tiles_z() : 0, at_once = p_is_hidden ? std::max(TILES_AT_ONCE / grid.get_tiles_x(), 1) : rows;
	while (_part == Part::COVER && _rows_shown < rows && may_go_on()) {
		const int end = std::min(_rows_shown + at_once, rows);
		_backend->set_cover(_map->get_layers().get_cover(), { 0, grid.get_tiles_x(), _rows_shown, end });
		FrameShare::count_bytes(int64_t(end - _rows_shown) * grid.get_tiles_x() * int64_t(sizeof(TileCover::Tile)));
		_rows_shown = end;
	}
	if (_part == Part::COVER && _rows_shown >= rows) {
		_part = Part::ALL;
	}
}

void StandingField::show_part(const Look &p_look) {
	switch (_part) {
		case Part::LOOK:
			_backend->set_look(p_look);
			_look = p_look;
			break;
		case Part::GROUND:
			_ground.create(_field.get_grid(), p_look);
			_is_carried = false;
			_backend->set_uniform("ground_carries", 0.0);
			break;
		case Part::PLANTS:
			set_plants();
			break;
		case Part::UNIFORMS:
			_uniforms.set_all(_properties, _field.get_setup(), _set);
			_uniforms.set_wind_clock(_set);
			break;
		case Part::SPECIES:
			set_species_uniforms();
			break;
		case Part::MAP:
			bind_map(true);
			break;
		default:
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
