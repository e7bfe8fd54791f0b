// SPDX-License-Identifier: MIT
// All counts and measurements of a field, for scripts and tests. The simulation does not read them.
#pragma once

#include "core/bodies/body_reads.h"
#include "core/field/backend_statistics.h"
#include "core/tiles/tiles.h"

namespace grass {

// For the picture and for shadows, in the newest frame known.
struct DrawnStatistics {
	std::array<int64_t, 2> tiles{}, triangles{};
};

struct FieldStatistics {
	const char *backend = "none";
	int64_t blades = 0, pool_tiles = 0, bare_tiles = 0;
	int64_t pool_slots = 0, pool_bytes = 0; // that exist now
	int64_t memory = 0; // bytes
	int64_t awake_tiles = 0;
	double coarseness = 1.0; // see Field::get_coarseness()
	int64_t wheels = 0, bones = 0; // of vehicles near the grass; of skeletons that bend grass
	int64_t soft_bodies = 0, mesh_pieces = 0; // near the grass; convex pieces of moving trimeshes
	int64_t areas = 0; // of the physics server, for all fields together
	BodyReads reads;
	int64_t plant_nodes = 0; // plants that have a node
	int64_t stems_looked_at = 0, plant_tiles_looked_at = 0; // in search of such plants, so far
	int64_t forces = 0, forces_left_out = 0; // that blow over it; left out for lack of room
	TileStatistics tile_work;
	BackendStatistics backend_work;
	DrawnStatistics drawn;

	int64_t map_bytes = 0; // uploaded so far
	int64_t map_waiting = 0; // chunks
	int64_t fill_cells = 0; // texels on which rules have run
	int64_t fill_waiting = 0; // chunks
	int64_t terrain_queries = 0, terrain_calls = 0, terrain_waiting = 0; // places queried so far; calls for them; chunks
	bool is_waiting = false; // to be made again
	int64_t builds = 0, makings = 0; // backends made; number of times that the field was made
	int64_t unseen_ticks = 0; // skipped ticks
	int64_t visited_ticks = 0, visited_frames = 0; // in which it did not rest
	int64_t wind_updates = 0; // frames that passed the wind's clock to the materials
	int64_t instance_updates = 0; // changes of the node that were passed to the renderer

	// CPU time, milliseconds: of the last tick (reading bodies, choosing tiles), of the last frame, of making the field (the longest in one
	// frame).
	double gather_ms = 0.0, tiles_ms = 0.0, frame_ms = 0.0, build_ms = 0.0;
};

} // namespace grass
