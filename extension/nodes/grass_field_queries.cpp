// SPDX-License-Identifier: MIT
// What scripts and the editor may ask of a GrassField.
#include "nodes/grass_field.h"

#include "convert.h"
#include "draw/blade_mesh.h"
#include "draw/patch_texture.h"
#include "nodes/build_info.h"
#include "nodes/main_thread.h"
#include "nodes/statistics_dictionary.h"

#include <godot_cpp/classes/engine.hpp>

using namespace godot;

namespace grass {

namespace {

DrawnStatistics count_drawn(const BackendStatistics &p_backend, const FieldSetup &p_setup) {
	DrawnStatistics drawn;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const size_t list = level < GRASS_LOD_LEVELS ? 0 : 1;
		const int64_t count = p_backend.drawn_tiles[size_t(level)];
		drawn.tiles[list] += count;
		drawn.triangles[list] += count * lod_blades(level) * lod_triangles_per_blade(level, p_setup.card_size > 0.0f);
	}
	return drawn;
}

} // namespace

String GrassField::label() const {
	return vformat("GrassField '%s'", get_name());
}
String GrassField::message(const String &p_text) const {
	// On another thread the renderer answers only once the main thread is free, which may be waiting for this one.
	if (_has_reported || !is_main_thread()) {
		return vformat("%s: %s", label(), p_text);
	}
	_has_reported = true;
	PackedStringArray build;
	build.push_back("GrassField " + get_version());
	build.push_back(_backend ? vformat("%s backend", _backend->get_name()) : String("no backend"));
	if (const String device = get_device(); !device.is_empty()) {
		build.push_back(device);
		build.push_back(get_driver());
	}
	return vformat("%s: %s (%s)", label(), p_text, String(", ").join(build));
}

// Whether grass stands, or will as soon as the field is made.
bool GrassField::has_blades() const {
	return _backend ||
			(is_inside_tree() && _maker.is_waiting() && !(_properties.species.prepare_patches() && _properties.species.join()->is_empty()));
}

int64_t GrassField::get_blade_count() const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	return has_blades() ? int64_t(find_grid().get_tile_count()) * GRASS_BLADES_PER_TILE : 0;
}

Vector2i GrassField::get_tiles() const {
	GRASS_MAIN_THREAD_ONLY_V(Vector2i());
	const TileGrid grid = find_grid();
	return has_blades() ? Vector2i(grid.get_tiles_x(), grid.get_tiles_z()) : Vector2i();
}

// Of the standing field; before there is one, of the field that the properties describe.
TileGrid GrassField::find_grid() const {
	return _backend ? _field.get_grid() : _properties.grid();
}

double GrassField::get_tile_size() const {
	GRASS_MAIN_THREAD_ONLY_V(0.0);
	return find_grid().get_tile_size();
}

Vector2i GrassField::get_tile_at(const Vector3 &p_global_position) const {
	GRASS_MAIN_THREAD_ONLY_V(Vector2i(-1, -1));
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), Vector2i(-1, -1), message("add the node to the scene tree before asking for tiles."));
	const Eigen::Vector3d place = to_eigen(field_transform()).inverse(Eigen::Isometry) * to_eigen(p_global_position);
	if (!place.allFinite()) {
		return Vector2i(-1, -1);
	}
	const TileGrid grid = find_grid();
	const TilePlace tile = grid.get_place(place);
	return grid.has_tile(tile.x, tile.z) ? Vector2i(tile.x, tile.z) : Vector2i(-1, -1);
}

Vector3 GrassField::get_tile_center(const Vector2i &p_tile) const {
	GRASS_MAIN_THREAD_ONLY_V(Vector3());
	ERR_FAIL_COND_V_MSG(!is_inside_tree(), Vector3(), message("add the node to the scene tree before asking for tiles."));
	return to_godot(Eigen::Vector3d(to_eigen(field_transform()) * find_grid().get_centre(p_tile.x, p_tile.y)));
}

bool GrassField::is_tile_awake(const Vector2i &p_tile) const {
	GRASS_MAIN_THREAD_ONLY_V(false);
	return _backend && _field.get_grid().has_tile(p_tile.x, p_tile.y) &&
			_field.get_tiles().is_awake(_field.get_grid().get_index(p_tile.x, p_tile.y));
}

int64_t GrassField::get_awake_tile_count() const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	return _backend ? _field.get_tiles().get_statistics().awake : 0;
}

PackedVector3Array GrassField::get_knots(const Vector2i &p_tile, int64_t p_blade) const {
	GRASS_MAIN_THREAD_ONLY_V(PackedVector3Array());
	ERR_FAIL_INDEX_V_MSG(p_blade, int64_t(GRASS_BLADES_PER_TILE), PackedVector3Array(), message("a tile has 64 blades, 0 to 63."));
	return find_knots(p_tile, int(p_blade), 1);
}

PackedVector3Array GrassField::get_tile_knots(const Vector2i &p_tile) const {
	GRASS_MAIN_THREAD_ONLY_V(PackedVector3Array());
	return find_knots(p_tile, 0, GRASS_BLADES_PER_TILE);
}

int64_t GrassField::get_blade_species(const Vector2i &p_tile, int64_t p_blade) const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	ERR_FAIL_COND_V_MSG(!_backend, 0, message("there are no blades yet. Ask after the node's first frame in the tree."));
	ERR_FAIL_COND_V_MSG(
			!_field.get_grid().has_tile(p_tile.x, p_tile.y), 0, message("there is no such tile. get_tiles() tells how many there are."));
	ERR_FAIL_INDEX_V_MSG(p_blade, int64_t(GRASS_BLADES_PER_TILE), 0, message("a tile has 64 blades, 0 to 63."));
	return _field.get_blades().get_pose(p_tile.x, p_tile.y, int(p_blade)).species;
}

PackedVector3Array GrassField::find_knots(const Vector2i &p_tile, int p_first, int p_count) const {
	PackedVector3Array result;
	ERR_FAIL_COND_V_MSG(!_backend, result, message("there are no blades yet. Ask after the node's first frame in the tree."));
	ERR_FAIL_COND_V_MSG(!_field.get_grid().has_tile(p_tile.x, p_tile.y), result,
			message("there is no such tile. get_tiles() tells how many there are."));
	const int slot = _field.get_tiles().get_slot_of(_field.get_grid().get_index(p_tile.x, p_tile.y));
	const std::vector<Eigen::Vector3f> simulated =
			slot != GRASS_NO_SLOT ? _backend->read_knots(slot, p_first, p_count) : std::vector<Eigen::Vector3f>();
	const Eigen::Affine3d to_world = to_eigen(field_transform());
	for (const Eigen::Vector3d &knot : _field.find_knots(p_tile.x, p_tile.y, p_first, p_count, simulated)) {
		result.push_back(to_godot(Eigen::Vector3d(to_world * knot)));
	}
	return result;
}

int64_t GrassField::get_memory_usage() const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	const size_t tiles =
			_field.get_tiles().get_memory_usage() + (_field.get_bounds() != nullptr ? _field.get_bounds()->get_memory_usage() : 0);
	int64_t maps = 0;
	for (const ShownMap *map : shown_maps()) {
		maps += map != nullptr ? int64_t(map->get_field().get_memory_usage()) + map->get_textures().get_memory_usage() : 0;
	}
	return maps + int64_t(tiles) + _uniforms.get_cards_memory() + (_backend ? _backend->get_memory_usage() : 0);
}

String GrassField::get_version() {
	return grass::get_version();
}

double GrassField::get_monitor(FieldMonitor p_monitor) {
	if (!_backend) {
		return 0.0;
	}
	const bool is_time = p_monitor == MONITOR_SIMULATE || p_monitor == MONITOR_CULL;
	if (is_time && !_is_watched) {
		_is_watched = true;
		_backend->set_measure_time(true);
	}
	const BackendStatistics backend = _backend->get_statistics();
	switch (p_monitor) {
		case MONITOR_AWAKE_TILES:
			return double(get_awake_tile_count());
		case MONITOR_SIMULATED_BLADES:
			return _field.is_seen() ? double(_field.get_tiles().get_statistics().simulated) * GRASS_BLADES_PER_TILE : 0.0;
		case MONITOR_DRAWN_BLADES:
			return double(backend.drawn_blades);
		case MONITOR_DRAWN_TRIANGLES:
			return double(count_drawn(backend, _field.get_setup()).triangles[0]);
		case MONITOR_MANAGEMENT:
			return 1e-3 * (_gather_ms + _field.get_tiles_ms());
		case MONITOR_SIMULATE:
			return 1e-3 * backend.simulate_ms;
		case MONITOR_CULL:
			return 1e-3 * backend.cull_ms;
		case MONITOR_MEMORY:
			return double(get_memory_usage());
		default:
			return 0.0;
	}
}

FieldStatistics GrassField::find_statistics() const {
	FieldStatistics statistics;
	if (_backend) {
		statistics.backend = _backend->get_name();
		statistics.backend_work = _backend->get_statistics();
		statistics.tiles = _field.get_grid().get_tile_count();
		statistics.pool_tiles = _field.get_setup().pool_size;
		statistics.instance_updates = statistics.backend_work.instance_updates;
	}
	statistics.tile_work = _field.get_tiles().get_statistics();
	statistics.drawn = count_drawn(statistics.backend_work, _field.get_setup());
	statistics.blades = get_blade_count();
	statistics.awake_tiles = get_awake_tile_count();
	statistics.memory = get_memory_usage();
	statistics.bodies = get_body_count();
	statistics.reads = _tracker.get_reads();
	if (_map) {
		statistics.bare_tiles = _map->get_field().get_cover()->get_bare_count();
		statistics.map_bytes = _map->get_textures().get_uploaded_bytes();
	}
	for (const ShownMap *map : shown_maps()) {
		statistics.map_waiting += map != nullptr ? map->get_waiting() : 0;
	}
	statistics.fill_cells = _filler.get_cells();
	statistics.fill_waiting = _filler.get_waiting();
	statistics.is_waiting = _maker.is_waiting();
	statistics.builds = _builds;
	statistics.makings = _maker.get_makings();
	statistics.unseen_ticks = _field.get_unseen_ticks();
	statistics.wind_updates = _wind_updates;
	statistics.instance_updates += _ground.get_updates();
	statistics.gather_ms = _gather_ms;
	statistics.tiles_ms = _field.get_tiles_ms();
	statistics.frame_ms = _frame_ms;
	statistics.build_ms = _maker.get_time();
	return statistics;
}

Dictionary GrassField::get_statistics() const {
	GRASS_MAIN_THREAD_ONLY_V(Dictionary());
	return to_dictionary(find_statistics());
}

AABB GrassField::_get_aabb() const {
	FieldSetup setup;
	setup.grid = _properties.grid();
	setup.patch = _backend ? _field.get_setup().patch : _properties.species.join();
	return field_bounds(setup, _field.get_cover());
}

String GrassField::crowded_warning() const {
	return vformat(
			"More tiles are in view than there is room for: %d, and %d that cast shadows. Some far ones are left out (see `left_out_tiles` "
			"in get_statistics()). Raise `drawn_tiles_max`, lower `density` for fewer, larger tiles, or bring the camera's far plane "
			"nearer.",
			_field.get_setup().instance_capacity(), _field.get_setup().shadow_capacity());
}

PackedStringArray GrassField::_get_configuration_warnings() const {
	PackedStringArray warnings;
	_properties.warn_of_blades(warnings);
	if (is_map_bare() && Engine::get_singleton()->is_editor_hint()) { // a game may begin with bare ground
		warnings.push_back("`map` has nothing painted and `base_density` 0, so no grass grows. Paint with the brush, or set the map's "
						   "`base_density` to 1.");
	}
	if (is_inside_tree()) {
		const Transform3D transform = get_global_transform();
		if (!transform.is_finite()) {
			warnings.push_back("The node's transform is not a number. Set its position and rotation again.");
		} else if (!transform.basis.get_scale().is_equal_approx(Vector3(1, 1, 1))) {
			warnings.push_back("The node's scale is ignored. Use `size` for the field, and the patch's lengths and widths for the blades.");
		}
	}
	_properties.warn_of_tiles(warnings);
	if (_is_crowded) {
		warnings.push_back(crowded_warning());
	}
	_filler.warn(_properties.map, warnings);
	return warnings;
}

} // namespace grass
