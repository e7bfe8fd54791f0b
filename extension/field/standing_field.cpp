// SPDX-License-Identifier: MIT
#include "field/standing_field.h"

#include "draw/blade_mesh.h"
#include "draw/frame_share.h"
#include "field/field_device.h"

#include <algorithm>
#include <optional>

using namespace godot;

namespace grass {

namespace {

// Chunks of the map (64 m) that may change in one frame without waiting: less than 1 ms each. More: frames stutter when a large brush is
// used. Less: its paint appears in pieces.
constexpr int CHUNKS_AT_ONCE = 4;

// Returns the view of a field that no camera sees, and of which all is simulated.
FieldView view_whole() {
	FieldView view;
	view.is_drawn = false;
	return view;
}

} // namespace

void StandingField::make(WantedField &&p_wanted, bool p_in_parts) {
	_is_crowded = false;
	update_project_pool();
	_parts.field.set(p_wanted.setup, p_wanted.bounds, p_wanted.map ? &p_wanted.map->get_layers() : nullptr, patches_of(p_wanted.species),
			_parts.properties.field_params(p_wanted.species));
	_parts.species = std::move(p_wanted.species);
	_parts.plants = std::move(p_wanted.plants);
	_parts.map = std::move(p_wanted.map);
	const FieldSetup &setup = _parts.field.get_setup();
	const bool can_go_on = _parts.backend && !setup.patch->is_empty() && _parts.backend->set_field(setup);
	_picture.begin(can_go_on);
	if (!can_go_on && !p_in_parts) {
		make_backend();
	}
}

void StandingField::make_backend() {
	_parts.backend.reset();
	_parts.backend = grass::make_backend(_parts.properties, _parts.field.get_setup());
	if (!_parts.backend) {
		_picture.free();
		return;
	}
	_picture.begin(true);
	update_measuring();
	_builds++;
}

bool StandingField::show(GeometryInstance3D *p_node, const Transform3D &p_transform) {
	const bool is_hidden = _parts.properties.is_streamed && !p_node->is_visible();
	if (_picture.needs_backend()) {
		FrameShare::Turn turn(this);
		if (is_hidden && !turn.has_part()) {
			return true;
		}
		make_backend();
	}
	return _picture.show(p_node, p_transform, is_hidden);
}

void StandingField::drop_backend() {
	_parts.backend.reset();
	_picture.free();
	_parts.field.rest(); // its blades went with the backend
}

void StandingField::leave_device() {
	drop_backend();
	_picture.begin(false);
}

void StandingField::clear() {
	drop_backend();
	_parts.field.forget_map();
	_parts.map.reset();
}

void StandingField::update_params() {
	if (_parts.backend) { // otherwise make() does it
		_parts.field.set_params(_parts.properties.field_params(_parts.species));
		_parts.field.stir();
	}
	update_measuring();
}

void StandingField::update_measuring() {
	if (_parts.backend) {
		_parts.backend->set_measure_time(
				_parts.properties.measure_time || _is_measured || _parts.properties.param(PARAM_SIMULATION_BUDGET) > 0.0);
	}
}

void StandingField::measure_time() {
	if (!_is_measured) {
		_is_measured = true;
		update_measuring();
	}
}

bool StandingField::update_species() {
	const FieldSpecies &species = _parts.properties.species;
	const FieldSetup &setup = _parts.field.get_setup();
	if (!_parts.backend || !species.prepare_patches() || !species.is_joined() || species.is_plain() != (setup.species == nullptr) ||
			(setup.species && !setup.species->chooses_as(*find_mix(_parts.properties))) || species.find_card_size() != setup.card_size ||
			species.find_leaf_area() != setup.leaf_area || species.find_plants(_parts.properties.param(PARAM_DENSITY)) != _parts.plants) {
		return false;
	}
	_picture.update_species();
	update_params();
	return true;
}

void StandingField::update_quality() {
	if (_parts.backend) { // otherwise make() does it
		_picture.update_quality();
		update_project_pool();
		fit_pool();
		_picture.request_draw();
	}
}

void StandingField::update_tint() {
	if (_parts.backend) {
		_parts.field.set_tint(_parts.properties.clump().tint);
		_picture.update_tint();
	}
}

void StandingField::fit_pool() {
	const int slots = _parts.backend ? find_pool_size(_parts.properties, _parts.field.get_setup()) : 0;
	if (_parts.backend && slots != _parts.field.get_setup().pool_size) {
		_parts.field.set_pool_size(*_parts.backend, slots);
	}
}

bool StandingField::update_map() {
	if (!_parts.backend || !is_map_waiting()) {
		return true;
	}
	const bool are_few = _parts.map->get_waiting() <= CHUNKS_AT_ONCE && !_parts.map->is_growing(),
			   is_streamed = _parts.properties.is_streamed;
	std::optional<FrameShare::Turn> turn;
	if (!_is_whole && (is_streamed || !are_few)) { // otherwise at once, outside the frame's share
		turn.emplace(this);
	}
	const MapLayers::Changes changes = _parts.map->update([&] { return !turn || (is_streamed ? turn->has_part() : turn->has_time()); });
	turn.reset();
	_picture.show_new_textures();
	if (changes.tiles.count() == 0) {
		return true;
	}
	_picture.show_cover(changes.tiles);
	_parts.field.regrow(changes.tiles);
	return !_parts.field.get_layers()->is_full();
}

const MapLayers *StandingField::layers_at(const Eigen::Vector2f &p_place) const {
	if (_parts.properties.map.is_null()) {
		return nullptr;
	}
	if (_parts.map && _parts.map->get_map() == _parts.properties.map && !_parts.map->is_preview() &&
			!_parts.map->get_layers().is_waiting_at(p_place)) {
		return _parts.field.get_layers();
	}
	_layers_there.read(_parts.properties.map->get_map(), _parts.field.get_setup().map_place(), p_place);
	return &_layers_there;
}

void StandingField::replay(int p_slots, const FieldParams *p_new) {
	if (p_slots != _parts.field.get_setup().pool_size) {
		_parts.field.set_pool_size(*_parts.backend, p_slots);
	}
	if (p_new != nullptr) {
		_parts.field.set_params(*p_new);
		_parts.field.stir();
	}
}

FieldParams StandingField::find_params() const {
	FieldParams params = _parts.properties.field_params(_parts.species);
	if (_is_whole) {
		params.detail = SimulationDetail::WHOLE;
		params.budget = 0.0; // which times decide
	}
	return params;
}

bool StandingField::begin_tick(bool p_is_listened, double p_delta) {
	if (_is_whole) {
		_parts.field.see(*_parts.backend, view_whole(), true);
	}
	return _parts.field.begin_tick(*_parts.backend, p_is_listened || _is_whole, p_delta);
}

bool StandingField::tick(const FieldParams &p_params, std::span<ColliderShape> p_colliders, std::span<const Force> p_forces, double p_delta,
		const ParallelFor &p_parallel_for) {
	_parts.field.set_params(p_params);
	const bool has_moved = _parts.field.tick(*_parts.backend, p_colliders, p_delta, p_forces, p_parallel_for);
	if (has_moved) {
		_picture.request_draw();
	}
	return has_moved;
}

void StandingField::ask(std::span<const BladeNumber> p_blades) {
	std::vector<int> tiles;
	for (const BladeNumber blade : p_blades) {
		tiles.push_back(tile_of(blade));
	}
	_parts.field.ask(*_parts.backend, tiles);
}

void StandingField::read_asked() {
	_parts.backend->read_asked([this](int p_tile) { return _parts.field.get_tiles().get_slot_of(p_tile); });
}

bool StandingField::draw(const FieldView &p_view, bool p_is_visible) {
	const bool was_seen = _parts.field.is_seen(), was_crowded = _is_crowded;
	_parts.field.see(*_parts.backend, _is_whole ? view_whole() : p_view, p_is_visible || _is_whole);
	if (_picture.is_shown() && p_view.is_watched && (_parts.field.is_seen() || was_seen)) { // once more, to know that nothing is drawn
		_parts.backend->draw(p_view);
		_is_crowded = _is_crowded || leaves_tiles_out();
	}
	if (_parts.field.is_seen() && !was_seen && _parts.properties.param(PARAM_WIND_SPEED) > 0.0) {
		_picture.show_wind_clock();
	}
	return _is_crowded && !was_crowded;
}

bool StandingField::leaves_tiles_out() const {
	const FieldSetup &setup = _parts.field.get_setup();
	if (int(setup.grid.get_tile_count()) <= std::min(setup.instance_capacity(), setup.shadow_capacity())) {
		return false; // there is room for all of them
	}
	const auto [picture, shadows] = _parts.backend->get_statistics().left_out_tiles;
	return picture + shadows > 0;
}

AABB StandingField::get_bounds() const {
	FieldSetup setup;
	setup.grid = _parts.properties.grid();
	setup.patch = _parts.backend ? _parts.field.get_setup().patch : _parts.properties.species.join();
	return field_bounds(setup, _parts.field.get_cover());
}

int64_t StandingField::get_memory_usage() const {
	const TileBounds *bounds = _parts.field.get_bounds();
	const size_t tiles = _parts.field.get_tiles().get_memory_usage() + (bounds != nullptr ? bounds->get_memory_usage() : 0);
	return int64_t(tiles) + (_parts.map ? _parts.map->get_memory_usage() : 0) + _picture.get_cards_memory() +
			(_parts.backend ? _parts.backend->get_memory().all : 0);
}

DrawnStatistics StandingField::count_drawn() const {
	const BackendStatistics backend = _parts.backend->get_statistics();
	DrawnStatistics drawn;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const size_t list = level < GRASS_LOD_LEVELS ? 0 : 1;
		const int64_t count = backend.drawn_tiles[size_t(level)];
		drawn.tiles[list] += count;
		drawn.triangles[list] += count * lod_blades(level) * lod_triangles_per_blade(level, _parts.field.get_setup().card_size > 0.0f);
	}
	return drawn;
}

void StandingField::add_to(FieldStatistics &r_statistics) const {
	if (_parts.backend) {
		r_statistics.backend = _parts.backend->get_name();
		r_statistics.backend_work = _parts.backend->get_statistics();
		r_statistics.drawn = count_drawn();
		r_statistics.pool_tiles = _parts.field.get_setup().pool_size;
		r_statistics.pool_slots = _parts.field.get_tiles().get_room();
		r_statistics.pool_bytes = _parts.backend->get_memory().pool;
		r_statistics.awake_tiles = _parts.field.get_tiles().get_statistics().awake;
	}
	if (_parts.map) {
		r_statistics.bare_tiles = _parts.map->get_layers().get_cover()->get_bare_count();
		r_statistics.map_bytes = _parts.map->get_textures().get_uploaded_bytes();
		r_statistics.map_waiting += _parts.map->get_waiting();
	}
	r_statistics.coarseness = _parts.field.get_coarseness();
	r_statistics.tile_work = _parts.field.get_tiles().get_statistics();
	r_statistics.instance_updates = r_statistics.backend_work.instance_updates;
	_picture.add_to(r_statistics);
	r_statistics.builds = _builds;
	r_statistics.unseen_ticks = _parts.field.get_unseen_ticks();
	r_statistics.tiles_ms = _parts.field.get_tiles_ms();
}

} // namespace grass
