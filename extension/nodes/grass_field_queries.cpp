// SPDX-License-Identifier: MIT
// What scripts and the editor may ask of a GrassField.
#include "nodes/grass_field.h"

#include "convert.h"
#include "draw/blade_mesh.h"
#include "draw/patch_texture.h"
#include "nodes/build_info.h"
#include "nodes/main_thread.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

using namespace godot;

namespace grass {

namespace {

// Tiles along a side whose numbers survive the 16-bit floats that the Compatibility renderer packs an instance's numbers in.
constexpr int EXACT_TILES = 2048;

bool is_compatibility() {
	return RenderingServer::get_singleton()->get_current_rendering_method() == String("gl_compatibility");
}

} // namespace

// Whether grass stands, or will as soon as the field is made.
bool GrassField::has_blades() const {
	return _backend || (is_inside_tree() && _dirty && !(prepare_patches() && find_patch()->is_empty()));
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
	return _backend ? _standing.setup.grid : TileGrid::make(_size.x, _size.y, param(PARAM_DENSITY));
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
	return _backend && _standing.setup.grid.has_tile(p_tile.x, p_tile.y) &&
			_tiles.is_awake(_standing.setup.grid.get_index(p_tile.x, p_tile.y));
}

int64_t GrassField::get_awake_tile_count() const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	return _backend ? _tiles.get_statistics().awake : 0;
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

PackedVector3Array GrassField::find_knots(const Vector2i &p_tile, int p_first, int p_count) const {
	PackedVector3Array result;
	ERR_FAIL_COND_V_MSG(!_backend, result, message("there are no blades yet. Ask after the node's first frame in the tree."));
	ERR_FAIL_COND_V_MSG(!_standing.setup.grid.has_tile(p_tile.x, p_tile.y), result,
			message("there is no such tile. get_tiles() tells how many there are."));
	const TileGrid &grid = _standing.setup.grid;
	const int slot = _tiles.get_slot_of(grid.get_index(p_tile.x, p_tile.y));
	std::vector<Eigen::Vector3f> simulated;
	if (slot != GRASS_NO_SLOT) {
		simulated = _backend->read_knots(slot, p_first, p_count);
	}
	const Eigen::Affine3d field = to_eigen(field_transform());
	for (int i = 0; i < p_count; i++) {
		const FieldBlades::Pose pose = _standing.blades.get_pose(p_tile.x, p_tile.y, p_first + i);
		const Eigen::Vector2d offset = (pose.root.cast<double>().array() - 0.5) * grid.get_tile_size();
		const Eigen::Vector3d root = grid.get_centre(p_tile.x, p_tile.y) + Eigen::Vector3d(offset.x(), pose.ground, offset.y());
		for (int knot = 0; knot < GRASS_KNOTS; knot++) {
			const bool at_rest = simulated.empty() || knot < GRASS_CLAMPED_KNOTS;
			const Eigen::Vector3f in_blade =
					at_rest ? _standing.blades.get_rest_knot(pose, knot) : simulated[size_t(i * GRASS_KNOTS + knot)];
			result.push_back(to_godot(Eigen::Vector3d(field * (root + in_blade.cast<double>()))));
		}
	}
	return result;
}

int64_t GrassField::get_memory_usage() const {
	GRASS_MAIN_THREAD_ONLY_V(0);
	const size_t tiles = _tiles.get_memory_usage() + (_standing.bounds ? _standing.bounds->get_memory_usage() : 0);
	int64_t maps = 0;
	for (const ShownMap *map : shown_maps()) {
		maps += map != nullptr ? int64_t(map->get_field().get_memory_usage()) + map->get_textures().get_memory_usage() : 0;
	}
	return maps + int64_t(tiles) + _cards.get_memory_usage() + (_backend ? _backend->get_memory_usage() : 0);
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
			return _is_seen ? double(_tiles.get_statistics().simulated) * GRASS_BLADES_PER_TILE : 0.0;
		case MONITOR_DRAWN_BLADES:
			return double(backend.drawn_blades);
		case MONITOR_DRAWN_TRIANGLES:
			return double(find_drawn(backend).triangles[0]);
		case MONITOR_MANAGEMENT:
			return 1e-3 * (_gather_ms + _tiles_ms);
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

GrassField::Drawn GrassField::find_drawn(const BackendStatistics &p_backend) const {
	Drawn drawn;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const size_t list = level < GRASS_LOD_LEVELS ? 0 : 1;
		const int64_t count = p_backend.drawn_tiles[size_t(level)];
		drawn.tiles[list] += count;
		drawn.triangles[list] += count * lod_blades(level) * lod_triangles_per_blade(level, _standing.setup.card_size > 0.0f);
	}
	return drawn;
}

Dictionary GrassField::get_statistics() const {
	GRASS_MAIN_THREAD_ONLY_V(Dictionary());
	const TileStatistics &tiles = _tiles.get_statistics();
	const BackendStatistics backend = _backend ? _backend->get_statistics() : BackendStatistics();
	const Drawn drawn = find_drawn(backend);
	Dictionary result;
	result["version"] = get_version();
	result["backend"] = _backend ? _backend->get_name() : "none";
	result["device"] = get_device();
	result["driver"] = get_driver();
	result["tiles"] = _backend ? int64_t(_standing.setup.grid.get_tile_count()) : int64_t(0);
	result["blades"] = get_blade_count();
	result["bare_tiles"] = _standing.map ? int64_t(_standing.map->get_field().get_cover()->get_bare_count()) : int64_t(0);
	result["map_bytes"] = _standing.map ? _standing.map->get_textures().get_uploaded_bytes() : int64_t(0);
	int64_t map_waiting = 0;
	for (const ShownMap *map : shown_maps()) {
		map_waiting += map != nullptr ? map->get_waiting() : 0;
	}
	result["map_waiting"] = map_waiting;
	result["waiting"] = _dirty;
	result["fill_cells"] = _fill.cells;
	result["fill_waiting"] = _fill.state.get_waiting();
	result["pool_tiles"] = _backend ? _standing.setup.pool_tiles : 0;
	result["awake_tiles"] = get_awake_tile_count();
	result["settling_tiles"] = tiles.settling;
	result["still_tiles"] = tiles.still;
	result["tile_steps"] = int64_t(tiles.tile_steps);
	result["unseen_tile_steps"] = int64_t(tiles.unseen_steps);
	result["still_tile_steps"] = int64_t(tiles.still_steps);
	result["unseen_ticks"] = _unseen_ticks;
	result["wind_updates"] = _wind_updates;
	result["woken"] = int64_t(tiles.woken);
	result["slept"] = int64_t(tiles.slept);
	result["evicted"] = int64_t(tiles.evicted);
	result["refused"] = int64_t(tiles.refused);
	result["capped"] = int64_t(tiles.capped);
	result["bodies"] = get_body_count();
	result["body_reads"] = _tracker.get_statistics().body_reads;
	result["shape_reads"] = _tracker.get_statistics().shape_reads;
	result["engine_calls"] = _tracker.get_statistics().engine_calls;
	result["tiles_looked_at"] = int64_t(tiles.looked_at);
	result["colliders"] = tiles.colliders;
	result["list_entries"] = tiles.list_entries;
	result["bad_colliders"] = int64_t(tiles.bad_colliders);
	result["steps"] = backend.steps;
	result["simulated_blades"] = backend.simulated_blades;
	result["edge_tile_steps"] = backend.edge_tile_steps;
	result["free_tile_steps"] = backend.free_tile_steps;
	result["compiling"] = backend.compiling;
	result["uploaded_bytes"] = backend.uploaded_bytes;
	result["culls"] = backend.culls;
	result["instance_updates"] = backend.instance_updates + _ground.get_updates();
	result["drawn_tiles"] = drawn.tiles[0];
	result["drawn_blades"] = backend.drawn_blades;
	result["drawn_triangles"] = drawn.triangles[0];
	result["left_out_tiles"] = backend.left_out_tiles[0];
	result["shadow_tiles"] = drawn.tiles[1];
	result["shadow_blades"] = backend.shadow_blades;
	result["shadow_triangles"] = drawn.triangles[1];
	result["left_out_shadow_tiles"] = backend.left_out_tiles[1];
	result["gather_ms"] = _gather_ms;
	result["tiles_ms"] = _tiles_ms;
	result["management_ms"] = _gather_ms + _tiles_ms;
	result["upload_ms"] = backend.upload_ms;
	result["frame_ms"] = _frame_ms;
	result["build_ms"] = _build_ms;
	result["builds"] = _builds;
	result["makings"] = _makings;
	result["simulate_ms"] = backend.simulate_ms;
	result["cull_ms"] = backend.cull_ms;
	result["memory"] = get_memory_usage();
	return result;
}

AABB GrassField::_get_aabb() const {
	FieldSetup setup;
	setup.grid = TileGrid::make(_size.x, _size.y, param(PARAM_DENSITY));
	setup.patch = _backend ? _standing.setup.patch : find_patch();
	return field_bounds(setup, _standing.map ? _standing.map->get_field().get_cover().get() : nullptr);
}

String GrassField::crowded_warning() const {
	return vformat(
			"More tiles are in view than there is room for: %d, and %d that cast shadows. Some far ones are left out (see `left_out_tiles` "
			"in get_statistics()). Raise `drawn_tiles_max`, lower `density` for fewer, larger tiles, or bring the camera's far plane "
			"nearer.",
			_standing.setup.instance_capacity(), _standing.setup.shadow_capacity());
}

PackedStringArray GrassField::_get_configuration_warnings() const {
	PackedStringArray warnings;
	if (prepare_patches() && find_patch()->is_empty()) {
		warnings.push_back(vformat("No grass grows: %s", find_patch()->empty_because));
	}
	if (_species.empty() && _patch.is_valid()) {
		warnings.append_array(_patch->find_warnings("`patch`"));
	}
	warn_of_species(warnings);
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
	if (_simulated && _collision_mask == 0) {
		warnings.push_back("`collision_mask` is empty, so no body bends the grass. Set the layers of the bodies that should, or turn "
						   "`simulated` off.");
	}
	if (_simulated && _pool_tiles == 0) {
		warnings.push_back("`pool_tiles` is 0, so no tile can be simulated. Raise it, or turn `simulated` off.");
	}
	const TileGrid grid = TileGrid::make(_size.x, _size.y, param(PARAM_DENSITY));
	if (is_compatibility() && std::max(grid.get_tiles_x(), grid.get_tiles_z()) > EXACT_TILES) {
		warnings.push_back(
				vformat("The Compatibility renderer tells tiles apart up to %d along a side only: beyond, tiles share their clumps, "
						"wind and map. Lower `density` or `size`, or use several fields.",
						EXACT_TILES));
	}
	if (grid.was_limited()) {
		warnings.push_back("The field has more tiles than 8192 along a side, so it is smaller than `size`. Lower `density` or `size`, or "
						   "use several fields.");
	}
	if (_is_crowded) {
		warnings.push_back(crowded_warning());
	}
	if (_fill.rule.is_valid() && _fill.rule->asks_ground() && (_map.is_null() || !_map->get_map().uses(MAP_GROUND))) {
		warnings.push_back(
				"`fill_rule` asks for slope or height, but the map knows no ground, so all of it counts as level, at the field's "
				"height. Bake the ground.");
	}
	if (_fill.rule.is_valid()) {
		warnings.append_array(_fill.rule->find_warnings());
	}
	return warnings;
}

} // namespace grass
