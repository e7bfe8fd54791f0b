// SPDX-License-Identifier: MIT
#include "gpu/gpu_field.h"

#include "core/base/cpu_clock.h"
#include "core/field/device_fit.h"
#include "gpu/gpu_times.h"
#include "gpu/render_queue.h"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <cstring>
#include <utility>

using namespace godot;

namespace grass {

void GpuField::create(const FieldSetup &p_setup, const RID &p_patch, const Ref<Texture2DRD> &p_pool, const Ref<Texture2DRD> &p_drawn) {
	_pool.create(p_pool);
	_cull.create(p_drawn);
	make_passes(kind_of(p_setup));
	_reader.create();
	set_field(p_setup, p_patch);
}

void GpuField::make_passes(const PassKind &p_kind) {
	_kind = p_kind;
	_simulate.create(_kind);
	_join.create(join_code(_kind), GpuPass::Compile::LATER);
}

// Makes the table with spare room, so that a growing field can usually keep it.
void GpuField::set_field(const FieldSetup &p_setup, const RID &p_patch) {
	if (const PassKind kind = kind_of(p_setup); kind != _kind) {
		make_passes(kind);
	}
	if (_kind.species) {
		_species_steps.resize(GRASS_MAX_SPECIES * int64_t(sizeof(GrassStep)));
	} else {
		_species_steps.free();
	}
	const int64_t tiles = p_setup.grid.get_tile_count();
	if (tiles * 4 <= _table.size()) {
		_table.clear();
	} else {
		_table.allocate(tile_room(tiles) * 4);
	}
	_cull.set_field(p_setup);
	_patch = RenderingServer::get_singleton()->texture_get_rd_texture(p_patch);
	_pool.start(p_setup.is_mapped, _kind.species);
	pool_changed();
}

// Changes the number of slots. If it is the same as before, tiles have only come to rest.
void GpuField::resize_pool(int p_slots, std::span<const SlotMove> p_moves, PoolRoom *p_room) {
	for (const SlotMove &move : p_moves) {
		const int32_t entry = move.to == GRASS_NO_SLOT ? 0 : move.to + 1; // as simulate writes it
		_table.write(int64_t(move.tile) * 4, std::span(&entry, 1));
	}
	_cull.change();
	if (p_slots != _pool.get_slots()) {
		_pool.resize(p_slots, p_moves, p_room);
		pool_changed();
	}
}

void GpuField::pool_changed() {
	if (_pool.get_slots() == 0) {
		_simulate.free_room();
	}
	_simulate.bind();
	bind_blades(_join);
	_pool.bind(_reader);
	report_memory();
}

// Binds the pool, and what its blades grow from.
void GpuField::bind_blades(GpuPass &r_pass) {
	_pool.bind(r_pass);
	r_pass.bind_sampled(GRASS_BINDING_PATCH, _pool.get_sampler(), _patch);
}

void GpuField::bind_simulate(GpuPass &r_pass) {
	bind_blades(r_pass);
	_pool.bind_energy(r_pass);
	r_pass.bind_buffer(GRASS_BINDING_TILE_TABLE, _table.rid());
	if (_kind.species) {
		r_pass.bind_buffer(GRASS_BINDING_SPECIES_STEPS, _species_steps.rid());
	}
}

void GpuField::step(const StepRecords &p_records, bool p_measure) {
	if (p_records.slots.empty() || !_simulate.is_ready()) {
		return;
	}
	CpuClock clock;
	if (p_measure) {
		report_gpu_times(this, *_report);
	}
	_pool.begin_step(p_records.slots);
	int64_t uploaded = upload(p_records);
	_simulate.make_room(p_records);
	{
		Stopwatch watch(p_measure, Stopwatch::SIMULATE, this);
		_simulate.dispatch(p_records,
				{ _slot_records.rid(), _forces.rid(), _colliders.rid(), _collider_list.rid(), _planes.rid(), _section_records.rid() });
		uploaded += dispatch_join(p_records.followers, p_records.step);
	}
	_pool.end_step(p_records.slots);
	const double upload_ms = clock.lap();
	if (std::ranges::any_of(
				p_records.slots, [](const GrassSlot &p_slot) { return (p_slot.list.w & (GRASS_SLOT_RETIRED | GRASS_SLOT_FRESH)) != 0; })) {
		_cull.change();
	}
	report_step(p_records, uploaded, upload_ms);
	read_energy(p_records.number - 1);
}

// Returns the number of uploaded bytes.
int64_t GpuField::upload(const StepRecords &p_records) {
	int64_t uploaded = _slot_records.upload(std::span<const GrassSlot>(p_records.slots));
	uploaded += _colliders.upload(std::span<const GrassCollider>(p_records.colliders));
	uploaded += _collider_list.upload(std::span<const uint32_t>(p_records.collider_list));
	uploaded += _planes.upload(std::span<const Eigen::Vector4f>(p_records.planes));
	uploaded += _forces.upload(std::span<const GrassForce>(p_records.forces));
	uploaded += _pool.write_growth(p_records.growth);
	if (_kind.species) {
		uploaded += _species_steps.upload(std::span<const GrassStep>(p_records.species));
	}
	if (p_records.passes[size_t(SlotPass::STRAINS)].tiles() > 0) {
		uploaded += _section_records.upload(_sections.find_numbers(_kind.species ? p_records.species : std::span(&p_records.step, 1)));
	}
	return uploaded;
}

void GpuField::report_step(const StepRecords &p_records, int64_t p_uploaded, double p_upload_ms) {
	const int64_t edges = _simulate.count_tiles(p_records, SlotPass::EDGES), free = _simulate.count_tiles(p_records, SlotPass::FREE),
				  crowds = _simulate.count_tiles(p_records, SlotPass::CROWD);
	const PassGroups &strains = p_records.passes[size_t(SlotPass::STRAINS)];
	report_memory();
	std::lock_guard lock(_report->mutex);
	BackendStatistics &statistics = _report->statistics;
	statistics.steps++;
	statistics.workgroups += p_records.count_groups();
	statistics.edge_tile_steps += edges;
	statistics.free_tile_steps += free + strains.tiles();
	statistics.crowd_tile_steps += crowds;
	statistics.simulated_blades += p_records.count_blades();
	statistics.strain_blades += strains.many.blades;
	statistics.uploaded_bytes += p_uploaded;
	statistics.upload_ms = p_records.copy_ms + p_upload_ms;
}

// Returns the number of uploaded bytes.
int64_t GpuField::dispatch_join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) {
	if (p_slots.empty() || !_join.is_ready()) {
		return 0;
	}
	const int64_t uploaded = _join_records.upload(p_slots);
	_join.bind_buffer(GRASS_BINDING_SLOTS, _join_records.rid());
	RenderingDevice *device = main_device();
	const int64_t list = device->compute_list_begin();
	_join.dispatch(list, p_step, uint32_t(p_slots.size()));
	device->compute_list_end();
	return uploaded;
}

void GpuField::join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) {
	const int64_t uploaded = dispatch_join(p_slots, p_step);
	_pool.set_moved();
	std::lock_guard lock(_report->mutex);
	_report->statistics.uploaded_bytes += uploaded;
}

// Asks for the energies after a step, once in a batch: the answers come all together. The device makes the copy between the dispatches of
// this step and the next one, so it has this step's energies, which are those at its start: after step p_number.
void GpuField::read_energy(uint64_t p_number) {
	RenderQueue *queue = RenderQueue::get_singleton();
	if (queue->get_batch() == _energy_batch) {
		return;
	}
	const auto receive = [report = _report, p_number](const PackedByteArray &p_data) {
		std::lock_guard lock(report->mutex);
		report->energy_step = p_number;
		const size_t slots = size_t(p_data.size()) / sizeof(vec4);
		report->energy.resize(slots);
		report->bends.resize(slots);
		for (size_t slot = 0; slot < slots; slot++) {
			vec4 record;
			std::memcpy(&record, p_data.ptr() + slot * sizeof(vec4), sizeof(vec4));
			report->energy[slot] = record.x;
			report->bends[slot] = { record.y, record.z, record.w };
		}
	};
	if (queue->read_later(_pool.get_energy(), _pool.get_energy_bytes(), receive)) {
		_energy_batch = queue->get_batch();
		std::lock_guard lock(_report->mutex);
		_report->statistics.energy_reads++;
	}
}

void GpuField::draw(const ViewRecords &p_records, const FieldMultiMeshes &p_multimeshes, bool p_measure) {
	_pool.begin_frame();
	if (_cull.draw(p_records, p_multimeshes, { _table.rid(), _patch, _pool.get_sampler() }, p_measure, this)) {
		report_memory();
	}
}

void GpuField::set_between(bool p_is_between) {
	_pool.set_between(p_is_between);
	report_memory();
}

void GpuField::mix(float p_share) {
	const bool has_mixed = _pool.mix(p_share);
	std::lock_guard lock(_report->mutex);
	_report->statistics.mixes += has_mixed ? 1 : 0;
}

void GpuField::set_plants(const FieldSetup &p_setup, const std::vector<PlantTarget> &p_targets) {
	_cull.set_plants(p_setup, p_targets);
	report_memory();
}

std::array<GpuBuffer *, 9> GpuField::buffers() {
	return { &_slot_records, &_join_records, &_colliders, &_collider_list, &_planes, &_forces, &_table, &_species_steps,
		&_section_records };
}

void GpuField::report_memory() {
	const int64_t pool = _pool.get_memory_usage();
	int64_t bytes = pool + _cull.get_memory_usage() + _reader.get_memory_usage();
	for (const GpuBuffer *buffer : buffers()) {
		bytes += buffer->size();
	}
	std::lock_guard lock(_report->mutex);
	_report->statistics.buffer_bytes = bytes;
	_report->statistics.pool_bytes = pool;
}

void GpuField::free(const FieldMultiMeshes &p_multimeshes) {
	_pool.free();
	_cull.free(p_multimeshes);
	_simulate.free();
	_simulate.free_room();
	_join.free();
	_reader.free();
	for (GpuBuffer *buffer : buffers()) {
		buffer->free();
	}
}

} // namespace grass
