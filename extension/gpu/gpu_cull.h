// SPDX-License-Identifier: MIT
// Chooses what a frame draws of a field, in passes that write the instances and commands of its MultiMeshes. Render thread.
#pragma once

#include "core/field/field_setup.h"
#include "gpu/gpu_report.h"
#include "gpu/plant_passes.h"
#include "gpu/view_records.h"

#include <godot_cpp/classes/texture2drd.hpp>

#include <array>
#include <memory>

namespace grass {

class GpuCull {
public:
	explicit GpuCull(std::shared_ptr<GpuReport> p_report) : _report(std::move(p_report)) {}

	// Creates the passes. p_drawn: receives the texture of the drawn tiles.
	void create(const godot::Ref<godot::Texture2DRD> &p_drawn);
	// Begins with another field, or with one of another size. Keeps buffers that fit.
	void set_field(const FieldSetup &p_setup);
	// Sets the cover of consecutive tiles from p_first on: TileCover::Tile[].
	void set_cover(int64_t p_first, const godot::PackedByteArray &p_tiles);
	// Sets the MultiMeshes of plants. Frees the command buffers of the former ones, which must still exist.
	void set_plants(const FieldSetup &p_setup, const std::vector<PlantTarget> &p_targets);
	// Must be called when the slot of a tile has changed: the next frame chooses again.
	void change() { _is_changed = true; }

	// What the passes read of the field: the slot of each tile; the patch's texture and a sampler for it.
	struct Sources {
		godot::RID table, patch, sampler;
	};
	// Runs the passes if anything differs from the last frame. Returns whether they ran. p_owner: see Stopwatch.
	bool draw(const ViewRecords &p_records, const FieldMultiMeshes &p_multimeshes, const Sources &p_sources, bool p_measure,
			const void *p_owner);

	int64_t get_memory_usage() const; // bytes
	// Frees everything. p_multimeshes: frees their command buffers too, since the engine never does (seen in 4.6).
	void free(const FieldMultiMeshes &p_multimeshes);

private:
	// Words of CountBuffer in cull.glsl: offsets of some counts, the number of words that are reported, and the number of all words.
	static constexpr int COUNT_BLADES = 2 * GRASS_ALL_LEVELS, COUNT_LEFT_OUT = COUNT_BLADES + 2, COUNTS_REPORTED = COUNT_LEFT_OUT + 2;
	static constexpr int COUNTS = COUNTS_REPORTED + 2 + GRASS_ALL_LEVELS * GRASS_TURNS;

	bool bind(const FieldMultiMeshes &p_multimeshes, const Sources &p_sources);
	bool bind_plants(const ViewRecords &p_records, const Sources &p_sources);
	void dispatch(int64_t p_list, const FieldMultiMeshes &p_multimeshes);
	void make_drawn_texture(int64_t p_places);
	void report_counts(int64_t p_uploaded);

	std::shared_ptr<GpuReport> _report;
	int64_t _tiles = 0;
	bool _is_changed = true; // since the passes ran last
	// Written by the main thread, read by cull: the frame's view, and where tiles are, which changes with the map. Fields without a map
	// have no cover (16 bytes).
	GpuBuffer _view, _cameras, _cover;
	GpuBuffer _counts; // lives for one frame, read and written by cull
	// Lives as long as the MultiMeshes, written by cull, read by the blade shader: the list of drawn tiles (GRASS_PLACES_PER_ROW).
	godot::RID _drawn_texture;
	godot::Ref<godot::Texture2DRD> _drawn;
	int _drawn_rows = 0;
	std::array<godot::RID, 2> _instances, _begun; // the MultiMeshes' buffers; those that GRASS_CULL_BEGIN has written
	GpuPass _cull;
	PlantPasses _plants;
};

} // namespace grass
