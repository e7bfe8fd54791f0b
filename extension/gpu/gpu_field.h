// SPDX-License-Identifier: MIT
// A field on the GPU: its buffers and the list of its passes. Every function must be called on the render thread (gpu_backend.h posts the
// calls through RenderQueue).
#pragma once

#include "core/field/backend_statistics.h"
#include "core/field/device_fit.h"
#include "core/field/field_setup.h"
#include "core/solver/slot_passes.h"
#include "core/solver/strain/sections.h"
#include "gpu/device.h"
#include "gpu/field_passes.h"
#include "gpu/knot_reader.h"
#include "gpu/plant_passes.h"
#include "gpu/pool_mix.h"
#include "gpu/pool_room.h"
#include "gpu/pool_rows.h"

#include <godot_cpp/classes/texture2drd.hpp>

#include <array>
#include <atomic>
#include <memory>
#include <mutex>

namespace grass {

// The records of one simulation step, copied on the main thread for the render thread.
struct StepRecords {
	uint64_t number;
	std::vector<GrassSlot> slots;
	std::vector<GrassCollider> colliders;
	std::vector<uint32_t> collider_list;
	std::vector<Eigen::Vector4f> planes;
	std::vector<SlotGrowth> growth;
	std::vector<GrassStep> species;
	std::vector<GrassForce> forces;
	std::vector<GrassSlot> followers;
	GrassStep step;
	SlotPasses passes; // of the slots
	double copy_ms; // CPU time of this copy

	// p_energies: see choose_passes(). p_kind: of the field.
	StepRecords(const StepInput &p_input, std::span<const float> p_energies, const PassKind &p_kind);
};

// The records of one drawn frame.
struct ViewRecords {
	GrassView view;
	std::vector<GrassCamera> cameras;
	PaintedSpecies painted; // for fields with plants and a map
	float plant_reach = 1.0f; // see FieldView
	uint64_t number = 0; // of the frame among those of the field
};

// The MultiMeshes that draw a field.
struct FieldMultiMeshes {
	godot::RID picture, shadows;
	uint32_t picture_capacity, shadow_capacity; // instances
};

// The results that the render thread reports to the main thread.
struct GpuReport {
	std::mutex mutex;
	BackendStatistics statistics;
	uint64_t energy_step = 0; // StepInput::number of the step after which `energy` was read
	std::vector<float> energy; // per slot
	std::vector<Eigen::Vector3f> bends; // per slot
	std::atomic<uint64_t> settled = 0; // ViewRecords::number of the last frame that found everything up to date
};

class GpuField {
public:
	explicit GpuField(std::shared_ptr<GpuReport> p_report) : _report(std::move(p_report)) {}
	// p_patch: the renderer's patch texture. p_pool, p_drawn: receive the textures of the pool and of the drawn tiles.
	void create(const FieldSetup &p_setup, const godot::RID &p_patch, const godot::Ref<godot::Texture2DRD> &p_pool,
			const godot::Ref<godot::Texture2DRD> &p_drawn);
	// Becomes another field, all of it at rest, and keeps the buffers that fit. p_patch: as for create().
	void set_field(const FieldSetup &p_setup, const godot::RID &p_patch);
	// Changes the number of slots, none at first. Awake tiles go on where p_moves says. p_room: the memory for that many; null: it is made.
	void resize_pool(int p_slots, std::span<const SlotMove> p_moves, PoolRoom *p_room);
	// Runs one tick: uploads the records, simulates their tiles, requests their energy.
	void step(const StepRecords &p_records, bool p_measure);
	// Poses blades that are drawn from now on. p_slots, p_step: see Simulator::join().
	void join(std::span<const GrassSlot> p_slots, const GrassStep &p_step);
	// Runs one frame: writes the instances and commands of p_multimeshes.
	void draw(const ViewRecords &p_records, const FieldMultiMeshes &p_multimeshes, bool p_measure);
	// Sets the MultiMeshes of plants. Frees the command buffers of the former ones, which must still exist.
	void set_plants(const FieldSetup &p_setup, const std::vector<PlantTarget> &p_targets);
	// p_before: receives a texture of where the last drawn frame showed the pool's blades; null: nothing reads motion vectors.
	void set_motion(const godot::Ref<godot::Texture2DRD> &p_before);
	// Sets whether frames between two ticks show a mix of their steps; if so, mix() must be called.
	void set_between(bool p_is_between);
	// Mixes p_share of the last step with the rest of the one before. Must be called before draw().
	void mix(float p_share);
	// Sets the cover of consecutive tiles from p_first on: TileCover::Tile[].
	void set_cover(int64_t p_first, const godot::PackedByteArray &p_tiles);
	KnotReader &get_reader() { return _reader; }
	// p_multimeshes: frees their command buffers too, since the engine never does (seen in 4.6).
	void free(const FieldMultiMeshes &p_multimeshes);

private:
	// Words of CountBuffer in cull.glsl: offsets of some counts, the number of words that are reported, and the number of all words.
	static constexpr int COUNT_BLADES = 2 * GRASS_ALL_LEVELS, COUNT_LEFT_OUT = COUNT_BLADES + 2, COUNTS_TOLD = COUNT_LEFT_OUT + 2;
	static constexpr int COUNTS = COUNTS_TOLD + 2 + GRASS_ALL_LEVELS * GRASS_TURNS;

	std::array<GpuBuffer *, 19> buffers();
	void fit_tables();
	void make_pool(int p_slots, std::span<const SlotMove> p_moves);
	void take_room(PoolRoom &r_room, std::span<const SlotMove> p_moves);
	void take_textures(PoolRoom &r_room, int p_kept, std::span<const SlotMove> p_moves);
	void keep_pool();
	void free_unneeded_rows();
	void rest_before(std::span<const GrassSlot> p_slots);
	void make_simulate();
	// Returns the pass that simulates workgroups of a kind: their own, or another one until that is compiled.
	GpuPass &find_pass(SlotPass p_pass, bool p_many);
	void dispatch_simulate(const StepRecords &p_records);
	int64_t dispatch_join(std::span<const GrassSlot> p_slots, const GrassStep &p_step);
	void bind_pool(GpuPass &r_pass);
	void bind_simulate();
	// Makes room for a step of p_groups workgroups, of which one dispatch takes p_most; 0: none.
	void make_room_to_work(uint32_t p_groups, uint32_t p_most);
	bool bind_plants(const ViewRecords &p_records);
	bool bind_cull(const FieldMultiMeshes &p_multimeshes);
	void dispatch_cull(int64_t p_list, const FieldMultiMeshes &p_multimeshes);
	void make_drawn_texture(int64_t p_places);
	void read_energy(uint64_t p_number);
	void report_counts(int64_t p_uploaded);
	void report_times();
	void report_memory();

	std::shared_ptr<GpuReport> _report;
	int64_t _tiles = 0, _pool_size = 0; // slots that exist
	bool _table_changed = true; // since the last cull

	// Lives for one step: written by the main thread's records in every step, read by simulate.
	GpuBuffer _slot_records, _colliders, _collider_list, _planes, _forces;
	// Lives for one step or one frame: written by the main thread's records, read by join.
	GpuBuffer _join_records;
	// Lives as long as the pool has slots, read and written by simulate and join: knots of awake tiles, now and one step earlier in two
	// halves; which half is which; twists of their joints or strains, and the blades' lengths; energy. All by slot.
	GpuBuffer _knots, _halves, _twists, _energy;
	// Lives for one dispatch, read and written by simulate: what its threads keep of their blades' joints, unless each has an array for it.
	std::shared_ptr<GpuBuffer> _work; // shared by all fields
	// Lives as long as the field, written by simulate, read by cull: slot of each tile.
	GpuBuffer _table;
	// Live as long as the field, written by the main thread when the map changes: how blades grow, read by simulate; where tiles are, read
	// by cull. Fields without a map have none (16 bytes).
	GpuBuffer _growth, _cover;
	bool _is_mapped = false;
	// The same for fields with species: the species of each slot's blades; and, in every step, each species' step.
	GpuBuffer _blade_species, _species_steps;
	// Written by the main thread when the section of a species changes, read by strains.
	GpuBuffer _section_records;
	StrainSections _sections;
	PassKind _kind;
	// Written in every frame, read by cull.
	GpuBuffer _view, _cameras;
	// Live for one frame, read and written by cull.
	GpuBuffer _counts;
	// Lives as long as the field, written by simulate, read by the blade shader: offsets of the knots from rest.
	godot::RID _pool_texture, _sampler, _patch; // the patch texture belongs to the renderer
	godot::Ref<godot::Texture2DRD> _pool;
	// Lives as long as the MultiMeshes, written by cull, read by the blade shader: the list of drawn tiles (GRASS_PLACES_PER_ROW).
	godot::RID _drawn_texture;
	godot::Ref<godot::Texture2DRD> _drawn;
	int _drawn_rows = 0;
	std::array<godot::RID, 2> _instances, _begun; // the MultiMeshes' buffers; those that GRASS_CULL_BEGIN has written
	// A copy of the pool's texture, which exists while motion vectors are read: written before the first step of a frame, read by the blade
	// shader.
	godot::RID _before_texture;
	// Exists as long as that copy or _mix: rows to copy into both.
	RestingRows _resting_rows;
	// If physics is interpolated: written in each frame in which the share of the last step changes, read by the blade shader instead of
	// the pool's texture.
	PoolMix _mix;
	godot::Ref<godot::Texture2DRD> _before; // null: nothing reads them
	int _used_rows = 0; // of the pool's texture
	uint64_t _energy_batch = UINT64_MAX; // in which the energies were last requested
	bool _has_kept = false; // since the last frame
	bool _has_moved = false; // whether blades have, since the copy was made
	KnotReader _reader;
	PlantPasses _plants;
	std::array<std::array<GpuPass, 2>, SLOT_PASSES> _simulate; // by SlotPass: with one tile in a workgroup, and with many
	GpuPass _cull, _join;
};

} // namespace grass
