// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/layout.h"

#include <array>
#include <cstdint>

namespace grass {

// The work of a backend, counted since it was made unless a comment says otherwise.
struct BackendStatistics {
	int64_t steps = 0; // simulation dispatches (GPU) or passes over the awake tiles (CPU)
	int64_t simulated_blades = 0; // blades stepped
	int64_t strain_blades = 0; // of simulated_blades, those that moved by their strains
	int64_t edge_tile_steps = 0; // GPU: steps of tiles with a collider that blades' edges must meet
	int64_t free_tile_steps = 0; // GPU: steps of tiles without a collider
	int64_t crowd_tile_steps = 0; // GPU: steps of tiles with more colliders than a workgroup shares
	int64_t workgroups = 0; // GPU: of steps; one has a tile, or several of which few blades are simulated
	int64_t compiling = 0; // GPU: passes that the driver is still compiling. Until they are ready, only knots meet sharp colliders,
						   // and free tiles take whole solves
	int64_t uploaded_bytes = 0; // GPU: bytes sent to the device
	int64_t buffer_bytes = 0; // now: of the buffers and textures on the device, except patch and MultiMesh
	int64_t pool_bytes = 0; // now: the part of them that grows with the pool
	int64_t culls = 0; // culling passes
	int64_t render_jobs = 0; // GPU: jobs given to the render thread
	int64_t mixes = 0; // frames that mixed the offsets of two steps
	int64_t instance_updates = 0; // changes of the node that were passed to the renderer: place, world, visibility, layers
	// In the newest frame known (GPU: about two frames late): tiles of each level, blades in the picture and in shadows.
	std::array<int64_t, GRASS_ALL_LEVELS> drawn_tiles{};
	int64_t drawn_blades = 0, shadow_blades = 0;
	std::array<int64_t, 2> left_out_tiles{}; // that did not fit in the MultiMeshes of picture and shadows
	// In the newest frame known: drawn by a mesh; by its impostor; left out for lack of room.
	int64_t drawn_plants = 0, drawn_impostors = 0, left_out_plants = 0;
	int64_t knots_read = 0; // GPU: blades whose knots were read back without waiting, counted in each read
	int64_t knot_waits = 0; // GPU: times that the main thread waited for knots
	int64_t knots_age = 0; // GPU, now: steps by which the known knots are late; 0 if nothing queries them
	int64_t energy_reads = 0; // GPU: times that the energies of all slots were requested
	int64_t undrawn_batches = 0; // GPU, of all fields together: times that the device did its work without a frame that is drawn
	int64_t timed_steps = 0; // times that simulate_ms was measured; GPU: by a frame that has steps
	double upload_ms = 0.0; // CPU time of handing a step's records to the GPU: copies, uploads, recording the pass
	double simulate_ms = 0.0, cull_ms = 0.0; // of one step, of one cull: GPU timestamps, or CPU time; 0 until known
};

} // namespace grass
