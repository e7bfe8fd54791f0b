// SPDX-License-Identifier: MIT
// The buffers and textures of GpuField on the device. Its ticks are in gpu_field_step.cpp, its frames in gpu_field_draw.cpp.
#include "gpu/gpu_field.h"

#include "draw/shared_shader.h"
#include "gpu/gpu_times.h"

#include <godot_cpp/classes/rd_sampler_state.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

void GpuField::create(const FieldSetup &p_setup, const RID &p_patch, const Ref<Texture2DRD> &p_pool, const Ref<Texture2DRD> &p_drawn) {
	_counts.allocate(COUNTS * 4);
	_pool = p_pool;
	_drawn = p_drawn;
	Ref<RDSamplerState> state;
	state.instantiate();
	_sampler = main_device()->sampler_create(state);
	_cull.create(CULL_CODE, has_shader_workers() ? GpuPass::Compile::LATER : GpuPass::Compile::NOW);
	_kind = kind_of(p_setup);
	make_simulate();
	_reader.create();
	set_field(p_setup, p_patch);
}

void GpuField::set_field(const FieldSetup &p_setup, const RID &p_patch) {
	const PassKind kind_before = std::exchange(_kind, kind_of(p_setup));
	_tiles = p_setup.grid.get_tile_count();
	_is_mapped = p_setup.is_mapped;
	if (_kind.species) {
		_species_steps.resize(GRASS_MAX_SPECIES * int64_t(sizeof(GrassStep)));
	} else {
		_blade_species.free();
		_species_steps.free();
	}
	fit_tables();
	if (_kind != kind_before) {
		make_simulate();
	}
	_patch = RenderingServer::get_singleton()->texture_get_rd_texture(p_patch);
	_used_rows = 0;
	make_pool(0, {}); // also if it was empty: what a slot has may differ
}

// Makes the buffers by tile, with spare room, so that a growing field can usually keep them.
void GpuField::fit_tables() {
	_table_changed = true;
	const int64_t room = tile_room(_tiles), cover = _is_mapped ? room * int64_t(sizeof(TileCover::Tile)) : 0;
	if (!_is_mapped || cover > _cover.size()) {
		_cover.resize(cover);
	}
	if (_tiles * 4 <= _table.size()) {
		_table.clear();
	} else {
		_table.allocate(room * 4);
	}
}

// Makes row 0, and one row for each GRASS_PLACES_PER_ROW.
void GpuField::make_drawn_texture(int64_t p_places) {
	const int rows = 1 + int((p_places + GRASS_PLACES_PER_ROW - 1) / GRASS_PLACES_PER_ROW);
	if (rows != _drawn_rows) {
		_drawn_rows = rows;
		const TextureUsage usage = RenderingDevice::TEXTURE_USAGE_STORAGE_BIT | RenderingDevice::TEXTURE_USAGE_SAMPLING_BIT;
		const RID made = make_texture(RenderingDevice::DATA_FORMAT_R32G32B32A32_SFLOAT, 2 * GRASS_PLACES_PER_ROW, rows, usage);
		replace_texture(_drawn, std::exchange(_drawn_texture, made), made);
		_table_changed = true;
	}
}

void GpuField::set_motion(const Ref<Texture2DRD> &p_before) {
	if (_before.is_valid()) {
		replace_texture(_before, std::exchange(_before_texture, RID()), RID());
	}
	_before = p_before;
	if (_before.is_valid()) {
		_before_texture = make_rows(Rows::BEFORE, _pool_size);
		_before->set_texture_rd_rid(_before_texture);
		_has_moved = true;
	}
	free_unneeded_rows();
}

void GpuField::set_between(bool p_is_between) {
	if (p_is_between == _mix.is_created()) {
		return;
	}
	if (p_is_between) {
		_mix.create(_pool_texture, _sampler, _pool_size, _used_rows);
	} else {
		_pool->set_texture_rd_rid(_pool_texture); // it has a view of the texture that is freed next
		_mix.free();
		free_unneeded_rows();
	}
	_has_moved = true;
	std::lock_guard lock(_report->mutex);
	report_memory();
}

void GpuField::free_unneeded_rows() {
	if (!_before.is_valid() && !_mix.is_created()) {
		_resting_rows.free();
	}
}

// Runs before draw(), which shows the result.
void GpuField::mix(float p_share) {
	if (!_has_kept) {
		keep_pool();
		_has_kept = true;
	}
	const bool was_showing = _mix.is_showing(), has_mixed = _mix.mix(p_share, _used_rows);
	if (_mix.is_showing() && !was_showing) {
		_pool->set_texture_rd_rid(_mix.get_shown());
	}
	_has_moved = _has_moved || has_mixed;
	std::lock_guard lock(_report->mutex);
	_report->statistics.mixes += has_mixed ? 1 : 0;
}

// Keeps what the last frame showed, for the motion vectors of the next one.
void GpuField::keep_pool() {
	if (_before.is_valid() && _has_moved && _used_rows > 0) {
		copy_rows(_mix.is_showing() ? _mix.get_shown() : _pool_texture, _before_texture, 0, 0, _used_rows);
		_has_moved = false;
	}
}

// Tiles that wake in this step were at rest in the frame and in the step before. Their rows hold the blades of other tiles, or are
// undefined.
void GpuField::rest_before(std::span<const GrassSlot> p_slots) {
	if (_before.is_valid()) {
		_resting_rows.copy_to(_before_texture, p_slots);
	}
	if (_mix.is_created()) {
		_resting_rows.copy_to(_mix.get_earlier(), p_slots);
	}
}

void GpuField::make_simulate() {
	for (auto &passes : _simulate) { // those for crowds and for many tiles are made when they are first needed
		for (GpuPass &pass : passes) {
			pass.free();
		}
	}
	_simulate[size_t(SlotPass::PLAIN)][0].create(simulate_code(_kind, SlotPass::PLAIN), GpuPass::Compile::LATER);
	_join.create(join_code(_kind), GpuPass::Compile::LATER);
	_simulate[size_t(SlotPass::FREE)][0].create(simulate_code(_kind, SlotPass::FREE), GpuPass::Compile::LATER);
	_simulate[size_t(SlotPass::EDGES)][0].create(simulate_code(_kind, SlotPass::EDGES), GpuPass::Compile::LATER);
	if (_kind.method == Method::DIRECT) {
		_simulate[size_t(SlotPass::STRAINS)][1].create(simulate_code(_kind, SlotPass::STRAINS, true), GpuPass::Compile::LATER);
	}
}

void GpuField::set_cover(int64_t p_first, const PackedByteArray &p_tiles) {
	const int64_t uploaded = _cover.write(p_first * int64_t(sizeof(TileCover::Tile)), p_tiles);
	_table_changed = true; // the drawn tiles may change
	std::lock_guard lock(_report->mutex);
	_report->statistics.uploaded_bytes += uploaded;
}

std::array<GpuBuffer *, 19> GpuField::buffers() {
	return { &_slot_records, &_join_records, &_colliders, &_collider_list, &_planes, &_forces, &_knots, &_halves, &_twists, &_energy,
		&_table, &_growth, &_blade_species, &_species_steps, &_section_records, &_cover, &_view, &_cameras, &_counts };
}

void GpuField::free(const FieldMultiMeshes &p_multimeshes) {
	RenderingServer *server = RenderingServer::get_singleton();
	RenderingDevice *device = main_device();
	set_motion(Ref<Texture2DRD>());
	set_between(false);
	for (Ref<Texture2DRD> *shown : { &_pool, &_drawn }) {
		if (shown->is_valid()) { // the texture resource first, since it has a view of what is freed next
			(*shown)->set_texture_rd_rid(RID());
			shown->unref();
		}
	}
	const auto commands_of = [server](const RID &p_multimesh) {
		return p_multimesh.is_valid() ? server->multimesh_get_command_buffer_rd_rid(p_multimesh) : RID(); // it was never shown
	};
	for (const RID &rid :
			{ _pool_texture, _drawn_texture, _sampler, commands_of(p_multimeshes.picture), commands_of(p_multimeshes.shadows) }) {
		if (rid.is_valid()) {
			device->free_rid(rid);
		}
	}
	_pool_texture = _drawn_texture = _sampler = RID();
	_plants.free();
	for (auto &passes : _simulate) {
		for (GpuPass &pass : passes) {
			pass.free();
		}
	}
	_cull.free();
	_join.free();
	_reader.free();
	_work.reset();
	for (GpuBuffer *buffer : buffers()) {
		buffer->free();
	}
}

void GpuField::report_times() {
	const GpuTimes times = read_gpu_times(this);
	std::lock_guard lock(_report->mutex);
	BackendStatistics &statistics = _report->statistics; // a pass that did not run in this frame keeps its last known time
	statistics.simulate_ms = times.simulate_ms > 0.0 ? times.simulate_ms : statistics.simulate_ms;
	statistics.timed_steps += times.simulate_ms > 0.0 ? 1 : 0;
	statistics.cull_ms = times.cull_ms > 0.0 ? times.cull_ms : statistics.cull_ms;
}

// The caller must hold the report's mutex.
void GpuField::report_memory() {
	const int64_t textures =
			POOL_ROW_BYTES * (_before.is_valid() ? 2 : 1) * _pool_size + _mix.get_memory_usage() + _resting_rows.get_memory_usage();
	int64_t bytes = textures + int64_t(_drawn_rows) * 2 * GRASS_PLACES_PER_ROW * int64_t(sizeof(vec4)) + _reader.get_memory_usage();
	for (const GpuBuffer *buffer : buffers()) {
		bytes += buffer->size();
	}
	_report->statistics.buffer_bytes = bytes + _plants.get_memory_usage();
	_report->statistics.pool_bytes = textures;
	for (const GpuBuffer *buffer : { &_knots, &_halves, &_twists, &_energy, &_growth, &_blade_species }) {
		_report->statistics.pool_bytes += buffer->size();
	}
}

} // namespace grass
