// SPDX-License-Identifier: MIT
#include "field/statistics_dictionary.h"

#include "shared/build_info.h"

#include <godot_cpp/variant/variant.hpp>

using namespace godot;

namespace grass {

Dictionary statistics_dictionary(const FieldStatistics &p_statistics) {
	const BackendStatistics &backend = p_statistics.backend_work;
	const DrawnStatistics &drawn = p_statistics.drawn;
	Dictionary result;
	result["version"] = get_version();
	result["backend"] = p_statistics.backend;
	result["device"] = get_device();
	result["driver"] = get_driver();
	result["waiting"] = p_statistics.is_waiting;
	result["compiling"] = backend.compiling;
	result["blades"] = p_statistics.blades;
	result["awake_tiles"] = p_statistics.awake_tiles;
	result["refused"] = int64_t(p_statistics.tile_work.refused);
	result["drawn_tiles"] = drawn.tiles[0];
	result["drawn_blades"] = backend.drawn_blades;
	result["drawn_triangles"] = drawn.triangles[0];
	result["left_out_tiles"] = backend.left_out_tiles[0];
	result["management_ms"] = p_statistics.gather_ms + p_statistics.tiles_ms;
	result["simulation_coarseness"] = p_statistics.coarseness;
	result["simulate_ms"] = backend.simulate_ms;
	result["cull_ms"] = backend.cull_ms;
	result["memory"] = p_statistics.memory;
	return result;
}

Dictionary counters_dictionary(const FieldStatistics &p_statistics) {
	const TileStatistics &tiles = p_statistics.tile_work;
	const BackendStatistics &backend = p_statistics.backend_work;
	const DrawnStatistics &drawn = p_statistics.drawn;
	Dictionary result;
	result["bare_tiles"] = p_statistics.bare_tiles;
	result["map_bytes"] = p_statistics.map_bytes;
	result["map_waiting"] = p_statistics.map_waiting;
	result["fill_cells"] = p_statistics.fill_cells;
	result["fill_waiting"] = p_statistics.fill_waiting;
	result["terrain_queries"] = p_statistics.terrain_queries;
	result["terrain_calls"] = p_statistics.terrain_calls;
	result["terrain_waiting"] = p_statistics.terrain_waiting;
	result["pool_tiles"] = p_statistics.pool_tiles;
	result["pool_slots"] = p_statistics.pool_slots;
	result["pool_bytes"] = p_statistics.pool_bytes;
	result["still_tiles"] = tiles.still;
	result["tile_steps"] = int64_t(tiles.tile_steps);
	result["followed_blade_steps"] = int64_t(tiles.followed_blades);
	result["widened_tiles"] = int64_t(tiles.widened);
	result["unseen_ticks"] = p_statistics.unseen_ticks;
	result["visited_ticks"] = p_statistics.visited_ticks;
	result["visited_frames"] = p_statistics.visited_frames;
	result["wind_updates"] = p_statistics.wind_updates;
	result["woken"] = int64_t(tiles.woken);
	result["evicted"] = int64_t(tiles.evicted);
	result["capped"] = int64_t(tiles.capped);
	result["wheels"] = p_statistics.wheels;
	result["bones"] = p_statistics.bones;
	result["soft_bodies"] = p_statistics.soft_bodies;
	result["areas"] = p_statistics.areas;
	result["mesh_pieces"] = p_statistics.mesh_pieces;
	result["plant_nodes"] = p_statistics.plant_nodes;
	result["stems_looked_at"] = p_statistics.stems_looked_at;
	result["plant_tiles_looked_at"] = p_statistics.plant_tiles_looked_at;
	result["forces"] = p_statistics.forces;
	result["forces_left_out"] = p_statistics.forces_left_out;
	result["body_reads"] = p_statistics.reads.poses;
	result["shape_reads"] = p_statistics.reads.shapes;
	result["engine_calls"] = p_statistics.reads.engine_calls;
	result["tiles_looked_at"] = int64_t(tiles.looked_at);
	result["colliders"] = tiles.colliders;
	result["steps"] = backend.steps;
	result["simulated_blades"] = backend.simulated_blades;
	result["strain_blades"] = backend.strain_blades;
	result["edge_tile_steps"] = backend.edge_tile_steps;
	result["free_tile_steps"] = backend.free_tile_steps;
	result["workgroups"] = backend.workgroups;
	result["crowd_tile_steps"] = backend.crowd_tile_steps;
	result["uploaded_bytes"] = backend.uploaded_bytes;
	result["knots_read"] = backend.knots_read;
	result["knot_waits"] = backend.knot_waits;
	result["energy_reads"] = backend.energy_reads;
	result["undrawn_batches"] = backend.undrawn_batches;
	result["mixes"] = backend.mixes;
	result["knots_age"] = backend.knots_age;
	result["culls"] = backend.culls;
	result["render_jobs"] = backend.render_jobs;
	result["instance_updates"] = p_statistics.instance_updates;
	result["drawn_plants"] = backend.drawn_plants;
	result["drawn_impostors"] = backend.drawn_impostors;
	result["left_out_plants"] = backend.left_out_plants;
	result["shadow_tiles"] = drawn.tiles[1];
	result["shadow_blades"] = backend.shadow_blades;
	result["shadow_triangles"] = drawn.triangles[1];
	result["left_out_shadow_tiles"] = backend.left_out_tiles[1];
	result["gather_ms"] = p_statistics.gather_ms;
	result["tiles_ms"] = p_statistics.tiles_ms;
	result["upload_ms"] = backend.upload_ms;
	result["frame_ms"] = p_statistics.frame_ms;
	result["build_ms"] = p_statistics.build_ms;
	result["builds"] = p_statistics.builds;
	result["makings"] = p_statistics.makings;
	return result;
}

} // namespace grass
