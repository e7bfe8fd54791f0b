// SPDX-License-Identifier: MIT
#include "field/field_picture.h"

#include "draw/frame_share.h"
#include "shared/convert.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Tiles of the cover in one part: 0.3 MB. More: a frame's upload takes longer. Fewer: a plot takes more frames to appear.
constexpr int TILES_AT_ONCE = 16384;

} // namespace

bool FieldPicture::show(GeometryInstance3D *p_node, const Transform3D &p_transform, bool p_is_hidden) {
	const Look look = find_look();
	if (!is_look_waiting() || (has_shader_workers() && !prepare_shaders(look))) {
		return true;
	}
	if (!is_shown() && !are_pictured(_parts.plants)) {
		return true;
	}
	if (!are_compiled(look)) {
		return false;
	}
	if (is_shown()) {
		_parts.backend->set_look(look);
		_ground.set_look(look);
		_look = look;
	} else {
		show_parts(look, p_is_hidden);
		if (!is_shown()) {
			return true;
		}
		follow(p_node, p_transform);
	}
	drop_hooked_shaders();
	_parts.properties.hook.hand_on(_set);
	return true;
}

void FieldPicture::show_parts(const Look &p_look, bool p_is_hidden) {
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
	const TileGrid &grid = _parts.field.get_grid();
	const int rows = _parts.map ? grid.get_tiles_z() : 0, at_once = p_is_hidden ? std::max(TILES_AT_ONCE / grid.get_tiles_x(), 1) : rows;
	while (_part == Part::COVER && _rows_shown < rows && may_go_on()) {
		const int end = std::min(_rows_shown + at_once, rows);
		_parts.backend->set_cover(_parts.map->get_layers().get_cover(), { 0, grid.get_tiles_x(), _rows_shown, end });
		FrameShare::count_bytes(int64_t(end - _rows_shown) * grid.get_tiles_x() * int64_t(sizeof(TileCover::Tile)));
		_rows_shown = end;
	}
	if (_part == Part::COVER && _rows_shown >= rows) {
		_part = Part::ALL;
	}
}

void FieldPicture::show_part(const Look &p_look) {
	switch (_part) {
		case Part::LOOK:
			_parts.backend->set_look(p_look);
			_look = p_look;
			break;
		case Part::GROUND:
			_ground.create(_parts.field.get_grid(), p_look);
			_is_carried = false;
			_parts.backend->set_uniform("ground_carries", 0.0);
			break;
		case Part::PLANTS:
			set_plants();
			break;
		case Part::UNIFORMS:
			_uniforms.set_all(_parts.properties, _parts.field.get_setup(), _set);
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

void FieldPicture::set_plants() {
	uint32_t with_mesh = 0;
	for (size_t s = 0; s < _parts.plants.size(); s++) {
		with_mesh |= _parts.plants[s].model ? 1u << s : 0u;
	}
	_parts.backend->set_plants(_parts.plants, [this, with_mesh](int p_x, int p_z, std::vector<StandingPlant> &r_plants) {
		_parts.field.get_blades().find_plants(p_x, p_z, with_mesh, r_plants);
	});
}

void FieldPicture::set_species_uniforms() {
	const float distance = float(_parts.properties.quality.factor(QUALITY_PLANT_DISTANCE));
	_uniforms.set_species(_parts.field.get_setup(), _parts.species, _parts.plants, distance, _set, _set_of_blades);
}

void FieldPicture::update_species() {
	if (_part > Part::SPECIES) { // otherwise show() does it
		set_species_uniforms();
	}
}

void FieldPicture::update_quality() {
	for (const FieldParam &param : FIELD_PARAMS) {
		if (param.effect == Effect::UNIFORM && param.factor != QUALITY_FACTORS) {
			set_uniform(param.tunable.name, _parts.properties.scaled(param.id));
		}
	}
	update_species();
}

void FieldPicture::set_uniform(const StringName &p_name, const Variant &p_value) {
	if (_parts.backend) {
		_parts.backend->set_uniform(p_name, p_value);
		_ground.set_uniform(p_name, p_value);
	}
}

// Binds the map's textures. p_all: all of them, for a new backend; otherwise only the new ones.
void FieldPicture::bind_map(bool p_all) {
	if (p_all || (_parts.map && _parts.map->has_new_textures())) {
		const MapBinding binding = _parts.map ? _parts.map->bind() : MapBinding();
		_parts.backend->set_map(binding);
		binding.set_uniforms([this](const StringName &p_name, const Variant &p_value) { _ground.set_uniform(p_name, p_value); });
	}
	if (_parts.map) {
		set_uniform("map_base_density", _parts.map->get_map()->get_base_density());
		const GroundGrid &heights = _parts.map->get_layers().get_ground_grid();
		const Eigen::Vector2d offset = heights.offset();
		set_uniform("map_ground_grid", Vector3(real_t(offset.x()), real_t(offset.y()), real_t(heights.split)));
	}
}

void FieldPicture::show_new_textures() {
	if (is_shown() && _parts.map->has_new_textures()) { // otherwise show() does it, for all of the map
		bind_map(false);
		request_draw();
	}
}

void FieldPicture::show_cover(const TileRange &p_tiles) {
	if (is_shown()) { // likewise
		bind_map(false);
		_parts.backend->set_cover(_parts.map->get_layers().get_cover(), p_tiles);
	}
}

void FieldPicture::blow(std::span<const Force> p_forces, double p_delta) {
	_uniforms.set_forces(p_forces, _parts.field.get_grid(), _set_of_blades);
	if (_uniforms.blow(_parts.properties, p_delta, !p_forces.empty()) && _parts.field.is_seen()) {
		show_wind_clock();
	}
}

void FieldPicture::show_wind_clock() {
	_uniforms.set_wind_clock(_set);
	_wind_updates++;
}

void FieldPicture::follow(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	if (!is_shown()) {
		return;
	}
	_parts.backend->follow(p_node, p_transform);
	if (_uniforms.turn(to_eigen(p_transform).linear())) {
		update_wind();
	}
	const bool is_carried = _parts.properties.has_soil;
	if (const TileCover *cover = _parts.map ? _parts.map->get_layers().get_cover().get() : nullptr) {
		_ground.set_heights(cover->get_low(), cover->get_high(), has_ledges(), _parts.map->get_layers().get_ground_grid());
	}
	_ground.follow(p_node, p_transform, is_carried);
	if (_is_carried != is_carried) {
		_is_carried = is_carried;
		_parts.backend->set_uniform("ground_carries", _is_carried ? 1.0 : 0.0);
	}
}

void FieldPicture::begin(bool p_has_backend) {
	_ground.free();
	_rows_shown = 0;
	_part = p_has_backend ? Part::LOOK : Part::BACKEND;
}

void FieldPicture::free() {
	_ground.free();
	_part = Part::NOTHING;
}

void FieldPicture::add_to(FieldStatistics &r_statistics) const {
	r_statistics.is_waiting = r_statistics.is_waiting || (_parts.backend != nullptr && is_look_waiting());
	r_statistics.instance_updates += _ground.get_updates();
	r_statistics.wind_updates = _wind_updates;
}

} // namespace grass
