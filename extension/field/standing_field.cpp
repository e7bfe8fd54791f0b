// SPDX-License-Identifier: MIT
#include "field/standing_field.h"

#include "draw/blade_mesh.h"
#include "draw/frame_share.h"
#include "shared/convert.h"

#include <algorithm>
#include <optional>

using namespace godot;

namespace grass {

namespace {

// Chunks of the map (64 m) that may change in one frame without waiting: less than 1 ms each. More: frames stutter when a large brush is
// used. Less: its paint appears in pieces.
constexpr int CHUNKS_AT_ONCE = 4;

} // namespace

void StandingField::make(WantedField &&p_wanted, bool p_in_parts) {
	_is_crowded = false;
	update_project_pool();
	_field.set(p_wanted.setup, p_wanted.bounds, p_wanted.map ? &p_wanted.map->get_layers() : nullptr, patches_of(p_wanted.species),
			_properties.field_params(p_wanted.species));
	_species = std::move(p_wanted.species);
	_plants = std::move(p_wanted.plants);
	_map = std::move(p_wanted.map);
	_ground.free();
	_rows_shown = 0;
	const FieldSetup &setup = _field.get_setup();
	const bool can_go_on = _backend && !setup.patch->is_empty() && _backend->set_field(setup);
	_part = can_go_on ? Part::LOOK : Part::BACKEND;
	if (!can_go_on && !p_in_parts) {
		make_backend();
	}
}

void StandingField::drop_backend() {
	_backend.reset();
	_part = Part::NOTHING;
	_ground.free();
	_field.rest(); // its blades went with the backend
}

void StandingField::clear() {
	drop_backend();
	_field.forget_map();
	_map.reset();
}

void StandingField::update_params() {
	if (_backend) { // otherwise make() does it
		_field.set_params(_properties.field_params(_species));
		_field.stir();
	}
	update_measuring();
}

void StandingField::update_measuring() {
	if (_backend) {
		_backend->set_measure_time(_properties.measure_time || _is_measured || _properties.param(PARAM_SIMULATION_BUDGET) > 0.0);
	}
}

void StandingField::measure_time() {
	if (!_is_measured) {
		_is_measured = true;
		update_measuring();
	}
}

bool StandingField::update_species() {
	const FieldSpecies &species = _properties.species;
	const FieldSetup &setup = _field.get_setup();
	if (!_backend || !species.prepare_patches() || !species.is_joined() || species.is_plain() != (setup.species == nullptr) ||
			(setup.species && !setup.species->chooses_as(*find_mix(_properties))) || species.find_card_size() != setup.card_size ||
			species.find_leaf_area() != setup.leaf_area || species.find_plants(_properties.param(PARAM_DENSITY)) != _plants) {
		return false;
	}
	set_species_uniforms();
	update_params();
	return true;
}

void StandingField::update_quality() {
	if (!_backend) { // make() does it
		return;
	}
	for (const FieldParam &param : FIELD_PARAMS) {
		if (param.effect == Effect::UNIFORM && param.factor != QUALITY_FACTORS) {
			set_uniform(param.tunable.name, _properties.scaled(param.id));
		}
	}
	if (_part > Part::SPECIES) { // else it will be
		set_species_uniforms();
	}
	update_project_pool();
	fit_pool();
	request_draw();
}

void StandingField::update_tint() {
	if (_backend) {
		_field.set_tint(_properties.clump().tint);
		FieldUniforms::set_clump(_field.get_setup().clump, _set);
	}
}

void StandingField::fit_pool() {
	const int slots = _backend ? find_pool_size(_properties, _field.get_setup()) : 0;
	if (_backend && slots != _field.get_setup().pool_size) {
		_field.set_pool_size(*_backend, slots);
	}
}

void StandingField::set_uniform(const StringName &p_name, const Variant &p_value) {
	if (_backend) {
		_backend->set_uniform(p_name, p_value);
		_ground.set_uniform(p_name, p_value);
	}
}

// p_all: for a backend that knows nothing of what another was told. Else only textures that are new.
void StandingField::bind_map(bool p_all) {
	if (p_all || (_map && _map->has_new_textures())) {
		const MapBinding binding = _map ? _map->bind() : MapBinding();
		_backend->set_map(binding);
		binding.set_uniforms([this](const StringName &p_name, const Variant &p_value) { _ground.set_uniform(p_name, p_value); });
	}
	if (_map) {
		set_uniform("map_base_density", _map->get_map()->get_base_density());
		const GroundGrid &heights = _map->get_layers().get_ground_grid();
		const Eigen::Vector2d offset = heights.offset();
		set_uniform("map_ground_grid", Vector3(real_t(offset.x()), real_t(offset.y()), real_t(heights.split)));
	}
}

bool StandingField::update_map() {
	if (!_backend || !is_map_waiting()) {
		return true;
	}
	const bool are_few = _map->get_waiting() <= CHUNKS_AT_ONCE && !_map->is_growing(), is_streamed = _properties.is_streamed;
	std::optional<FrameShare::Turn> turn;
	if (is_streamed || !are_few) { // otherwise at once, outside the frame's share
		turn.emplace(this);
	}
	const MapLayers::Changes changes = _map->update([&] { return !turn || (is_streamed ? turn->has_part() : turn->has_time()); });
	turn.reset();
	if (is_shown() && _map->has_new_textures()) { // else show() does it, for all of the map
		bind_map(false);
		request_draw();
	}
	if (changes.tiles.count() == 0) {
		return true;
	}
	if (is_shown()) { // likewise
		bind_map(false);
		_backend->set_cover(_map->get_layers().get_cover(), changes.tiles);
	}
	_field.regrow(changes.tiles);
	return !_field.get_layers()->is_full();
}

const MapLayers *StandingField::layers_at(const Eigen::Vector2f &p_place) const {
	if (_properties.map.is_null()) {
		return nullptr;
	}
	if (_map && _map->get_map() == _properties.map && !_map->is_preview() && !_map->get_layers().is_waiting_at(p_place)) {
		return _field.get_layers();
	}
	_layers_there.read(_properties.map->get_map(), _field.get_setup().map_place(), p_place);
	return &_layers_there;
}

bool StandingField::begin_tick(bool p_is_listened, double p_delta) {
	return _field.begin_tick(*_backend, p_is_listened, p_delta);
}

bool StandingField::tick(
		std::span<ColliderShape> p_colliders, std::span<const Force> p_forces, double p_delta, const ParallelFor &p_parallel_for) {
	_field.set_params(_properties.field_params(_species));
	const bool has_moved = _field.tick(*_backend, p_colliders, p_delta, p_forces, p_parallel_for);
	if (has_moved) {
		request_draw();
	}
	return has_moved;
}

void StandingField::blow(std::span<const Force> p_forces, double p_delta) {
	_uniforms.set_forces(p_forces, _field.get_grid(), _set_of_blades);
	if (_uniforms.blow(_properties, p_delta, !p_forces.empty()) && _field.is_seen()) {
		_uniforms.set_wind_clock(_set);
		_wind_updates++;
	}
}

void StandingField::follow(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	if (!is_shown()) {
		return;
	}
	_backend->follow(p_node, p_transform);
	if (_uniforms.turn(to_eigen(p_transform).linear())) {
		update_wind();
	}
	const bool is_carried = _properties.has_soil;
	if (const TileCover *cover = _map ? _map->get_layers().get_cover().get() : nullptr) {
		_ground.set_heights(cover->get_low(), cover->get_high(), has_ledges(), _map->get_layers().get_ground_grid());
	}
	_ground.follow(p_node, p_transform, is_carried);
	if (_is_carried != is_carried) {
		_is_carried = is_carried;
		_backend->set_uniform("ground_carries", _is_carried ? 1.0 : 0.0);
	}
}

void StandingField::ask(std::span<const BladeNumber> p_blades) {
	std::vector<int> tiles;
	for (const BladeNumber blade : p_blades) {
		tiles.push_back(tile_of(blade));
	}
	_field.ask(*_backend, tiles);
}

void StandingField::read_asked() {
	_backend->read_asked([this](int p_tile) { return _field.get_tiles().get_slot_of(p_tile); });
}

bool StandingField::draw(const FieldView &p_view, bool p_is_visible) {
	const bool was_seen = _field.is_seen(), was_crowded = _is_crowded;
	_field.see(*_backend, p_view, p_is_visible);
	if (is_shown() && p_view.is_watched && (_field.is_seen() || was_seen)) { // once more, to know that nothing is drawn
		_backend->draw(p_view);
		_is_crowded = _is_crowded || leaves_tiles_out();
	}
	if (_field.is_seen() && !was_seen && _properties.param(PARAM_WIND_SPEED) > 0.0) {
		_uniforms.set_wind_clock(_set);
		_wind_updates++;
	}
	return _is_crowded && !was_crowded;
}

bool StandingField::leaves_tiles_out() const {
	const FieldSetup &setup = _field.get_setup();
	if (int(setup.grid.get_tile_count()) <= std::min(setup.instance_capacity(), setup.shadow_capacity())) {
		return false; // there is room for all of them
	}
	const auto [picture, shadows] = _backend->get_statistics().left_out_tiles;
	return picture + shadows > 0;
}

AABB StandingField::get_bounds() const {
	FieldSetup setup;
	setup.grid = _properties.grid();
	setup.patch = _backend ? _field.get_setup().patch : _properties.species.join();
	return field_bounds(setup, _field.get_cover());
}

int64_t StandingField::get_memory_usage() const {
	const TileBounds *bounds = _field.get_bounds();
	const size_t tiles = _field.get_tiles().get_memory_usage() + (bounds != nullptr ? bounds->get_memory_usage() : 0);
	return int64_t(tiles) + (_map ? _map->get_memory_usage() : 0) + _uniforms.get_cards_memory() +
			(_backend ? _backend->get_memory().all : 0);
}

DrawnStatistics StandingField::count_drawn() const {
	const BackendStatistics backend = _backend->get_statistics();
	DrawnStatistics drawn;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const size_t list = level < GRASS_LOD_LEVELS ? 0 : 1;
		const int64_t count = backend.drawn_tiles[size_t(level)];
		drawn.tiles[list] += count;
		drawn.triangles[list] += count * lod_blades(level) * lod_triangles_per_blade(level, _field.get_setup().card_size > 0.0f);
	}
	return drawn;
}

void StandingField::add_to(FieldStatistics &r_statistics) const {
	if (_backend) {
		r_statistics.backend = _backend->get_name();
		r_statistics.backend_work = _backend->get_statistics();
		r_statistics.drawn = count_drawn();
		r_statistics.pool_tiles = _field.get_setup().pool_size;
		r_statistics.pool_slots = _field.get_tiles().get_room();
		r_statistics.pool_bytes = _backend->get_memory().pool;
		r_statistics.awake_tiles = _field.get_tiles().get_statistics().awake;
		r_statistics.is_waiting = r_statistics.is_waiting || is_look_waiting();
	}
	if (_map) {
		r_statistics.bare_tiles = _map->get_layers().get_cover()->get_bare_count();
		r_statistics.map_bytes = _map->get_textures().get_uploaded_bytes();
		r_statistics.map_waiting += _map->get_waiting();
	}
	r_statistics.coarseness = _field.get_coarseness();
	r_statistics.tile_work = _field.get_tiles().get_statistics();
	r_statistics.instance_updates = r_statistics.backend_work.instance_updates + _ground.get_updates();
	r_statistics.builds = _builds;
	r_statistics.unseen_ticks = _field.get_unseen_ticks();
	r_statistics.wind_updates = _wind_updates;
	r_statistics.tiles_ms = _field.get_tiles_ms();
}

} // namespace grass
