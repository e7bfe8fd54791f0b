// SPDX-License-Identifier: MIT
// A field on the GPU: moves the blades of its pool in ticks, and draws them in frames. Every function must be called on the render thread
// (gpu_backend.h posts the calls through FieldJobs).
#pragma once

#include "core/solver/strain/sections.h"
#include "gpu/gpu_cull.h"
#include "gpu/gpu_pool.h"
#include "gpu/knot_reader.h"
#include "gpu/step_passes.h"

namespace grass {

class GpuField {
public:
	explicit GpuField(std::shared_ptr<GpuReport> p_report) : _report(std::move(p_report)), _cull(_report) {}
	// Creates the field. p_patch: the renderer's patch texture. p_pool, p_drawn: receive the textures of the pool and of the drawn tiles.
	void create(const FieldSetup &p_setup, const godot::RID &p_patch, const godot::Ref<godot::Texture2DRD> &p_pool,
			const godot::Ref<godot::Texture2DRD> &p_drawn);
	// Becomes another field, all of it at rest, and keeps the buffers that fit. p_patch: as for create().
	void set_field(const FieldSetup &p_setup, const godot::RID &p_patch);
	// Changes the number of slots, none at first. Awake tiles go on where p_moves says. p_room: the memory for that many; null: it is made.
	void resize_pool(int p_slots, std::span<const SlotMove> p_moves, PoolRoom *p_room);
	// Runs one tick: uploads the records, simulates their tiles, requests their energy.
	void step(const StepRecords &p_records, bool p_measure);
	// Gives blades that are drawn from now on their poses. p_slots, p_step: see Simulator::join().
	void join(std::span<const GrassSlot> p_slots, const GrassStep &p_step);
	// Runs one frame: writes the instances and commands of p_multimeshes.
	void draw(const ViewRecords &p_records, const FieldMultiMeshes &p_multimeshes, bool p_measure);
	// Do what GpuPool's and GpuCull's functions of these names do. mix() must be called before draw().
	void set_motion(const godot::Ref<godot::Texture2DRD> &p_before) { _pool.set_motion(p_before); }
	void set_between(bool p_is_between);
	void mix(float p_share);
	void set_plants(const FieldSetup &p_setup, const std::vector<PlantTarget> &p_targets);
	void set_cover(int64_t p_first, const godot::PackedByteArray &p_tiles) { _cull.set_cover(p_first, p_tiles); }
	KnotReader &get_reader() { return _reader; }
	// Frees everything. p_multimeshes: frees their command buffers too, since the engine never does (seen in 4.6).
	void free(const FieldMultiMeshes &p_multimeshes);

private:
	std::array<GpuBuffer *, 9> buffers();
	void make_passes(const PassKind &p_kind);
	void pool_changed();
	void bind_blades(GpuPass &r_pass);
	void bind_simulate(GpuPass &r_pass);
	int64_t upload(const StepRecords &p_records);
	int64_t dispatch_join(std::span<const GrassSlot> p_slots, const GrassStep &p_step);
	void read_energy(uint64_t p_number);
	void report_step(const StepRecords &p_records, int64_t p_uploaded, double p_upload_ms);
	void report_memory();

	std::shared_ptr<GpuReport> _report;
	PassKind _kind;
	GpuPool _pool;
	GpuCull _cull;
	StepPasses _simulate{ [this](GpuPass &r_pass) { bind_simulate(r_pass); } };
	GpuPass _join;
	KnotReader _reader;
	// Lives for one step: written by the main thread's records in every step, read by simulate.
	GpuBuffer _slot_records, _colliders, _collider_list, _planes, _forces;
	// Lives for one step or one frame: written by the main thread's records, read by join.
	GpuBuffer _join_records;
	// Lives as long as the field, written by simulate, read by cull: slot of each tile.
	GpuBuffer _table;
	// For fields with several species: written in every step, read by simulate: each species' step.
	GpuBuffer _species_steps;
	// Written by the main thread when the section of a species changes, read by strains.
	GpuBuffer _section_records;
	StrainSections _sections;
	godot::RID _patch; // a texture of the renderer
	uint64_t _energy_batch = UINT64_MAX; // in which the energies were last requested
};

} // namespace grass
