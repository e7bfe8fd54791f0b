// SPDX-License-Identifier: MIT
// What GpuField has on the device. A tick: gpu_field_step.cpp; a frame: gpu_field_draw.cpp.
#include "gpu/gpu_field.h"

#include "compute_shaders.gen.h"
#include "gpu/gpu_times.h"

#include <godot_cpp/classes/rd_sampler_state.hpp>
#include <godot_cpp/classes/rd_texture_format.hpp>
#include <godot_cpp/classes/rd_texture_view.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <bit>

using namespace godot;

namespace grass {

namespace {

constexpr int POOL_TEXTURE_WIDTH = GRASS_KNOTS * GRASS_POOL_BLADES_PER_ROW;

} // namespace

void GpuField::create(const FieldSetup &p_setup, const RID &p_patch, const Ref<Texture2DRD> &p_pool) {
	RenderingDevice *device = main_device();
	_tiles = p_setup.grid.get_tile_count();
	_instances = p_setup.instance_capacity();
	_shadow_instances = p_setup.shadow_capacity();
	_slots = p_setup.pool_tiles;
	_knots.allocate(_slots * KNOT_FLOATS_PER_SLOT * 4);
	_knots_before.allocate(_slots * KNOT_FLOATS_PER_SLOT * 4);
	_energy.allocate(_slots * int64_t(sizeof(vec4)));
	_is_mapped = p_setup.is_mapped;
	_has_species = p_setup.species != nullptr;
	set_tiles(_tiles);
	_counts.allocate(COUNTS * 4);
	_growth.allocate(_is_mapped || _has_species ? _slots * int64_t(sizeof(SlotGrowth::blades)) : 0);
	if (_has_species) {
		_blade_species.allocate(_slots * int64_t(sizeof(SlotGrowth::species)));
		_species_steps.allocate(GRASS_MAX_SPECIES * int64_t(sizeof(GrassStep)));
	}

	Ref<RDTextureFormat> format;
	format.instantiate();
	format->set_format(RenderingDevice::DATA_FORMAT_R16G16B16A16_SFLOAT);
	format->set_width(POOL_TEXTURE_WIDTH);
	format->set_height(uint32_t(std::max<int64_t>(_slots, 1))); // no texture is empty
	format->set_usage_bits(RenderingDevice::TEXTURE_USAGE_STORAGE_BIT | RenderingDevice::TEXTURE_USAGE_SAMPLING_BIT);
	Ref<RDTextureView> view;
	view.instantiate();
	_pool_texture = device->texture_create(format, view);
	_pool = p_pool;
	_pool->set_texture_rd_rid(_pool_texture);
	Ref<RDSamplerState> state;
	state.instantiate();
	_sampler = device->sampler_create(state);

	using Code = std::span<const uint32_t>;
	_simulate.create(_has_species ? Code(shader::SIMULATE_GRASS_SPECIES_SPIRV) : Code(shader::SIMULATE_SPIRV), "GrassField simulate");
	_simulate_edges.create(_has_species ? Code(shader::SIMULATE_GRASS_SPECIES_EDGES_SPIRV) : Code(shader::SIMULATE_GRASS_EDGES_SPIRV),
			"GrassField simulate edges", GpuPass::Compile::LATER);
	_cull.create(shader::CULL_SPIRV, "GrassField cull");
	bind_simulate(RenderingServer::get_singleton()->texture_get_rd_texture(p_patch));
	std::lock_guard lock(_report->mutex);
	report_memory();
}

void GpuField::set_tiles(int64_t p_tiles) {
	_tiles = p_tiles;
	_table_changed = true;
	const int64_t room = int64_t(std::bit_ceil(uint64_t(_tiles)));
	if (const int64_t cover = _is_mapped ? room * int64_t(sizeof(TileCover::Tile)) : 0; cover > _cover.size() || !_cover.rid().is_valid()) {
		_cover.allocate(cover);
	}
	if (_tiles * 4 <= _table.size()) {
		_table.clear();
		return;
	}
	_table.allocate(room * 4);
	for (GpuPass *pass : { &_simulate, &_simulate_edges }) {
		pass->bind_buffer(GRASS_BINDING_TILE_TABLE, _table.rid());
	}
}

void GpuField::set_cover(int64_t p_first, const std::vector<TileCover::Tile> &p_tiles) {
	const int64_t uploaded = _cover.write(p_first * int64_t(sizeof(TileCover::Tile)), std::span<const TileCover::Tile>(p_tiles));
	_table_changed = true; // other tiles may be drawn now
	std::lock_guard lock(_report->mutex);
	_report->statistics.uploaded_bytes += uploaded;
}

void GpuField::free(const FieldMultiMeshes &p_multimeshes) {
	RenderingServer *server = RenderingServer::get_singleton();
	RenderingDevice *device = main_device();
	if (_pool.is_valid()) { // the texture resource first: it holds a view of what is freed next
		_pool->set_texture_rd_rid(RID());
		_pool.unref();
	}
	for (const RID &rid : { _pool_texture, _sampler, server->multimesh_get_command_buffer_rd_rid(p_multimeshes.picture),
				 server->multimesh_get_command_buffer_rd_rid(p_multimeshes.shadows) }) {
		if (rid.is_valid()) {
			device->free_rid(rid);
		}
	}
	_pool_texture = _sampler = RID();
	_simulate.free();
	_simulate_edges.free();
	_cull.free();
	for (GpuBuffer *buffer : { &_slot_records, &_colliders, &_collider_list, &_planes, &_knots, &_knots_before, &_energy, &_table, &_growth,
				 &_blade_species, &_species_steps, &_cover, &_view, &_cameras, &_counts }) {
		buffer->free();
	}
}

void GpuField::report_times() {
	const GpuTimes times = read_gpu_times();
	std::lock_guard lock(_report->mutex);
	BackendStatistics &statistics = _report->statistics; // of a pass that the frame had not, the last known time stands
	statistics.simulate_ms = times.simulate_ms > 0.0 ? times.simulate_ms : statistics.simulate_ms;
	statistics.cull_ms = times.cull_ms > 0.0 ? times.cull_ms : statistics.cull_ms;
}

// The report's mutex is held.
void GpuField::report_memory() {
	int64_t bytes = _slots * POOL_TEXTURE_WIDTH * 8;
	for (const GpuBuffer *buffer : { &_slot_records, &_colliders, &_collider_list, &_planes, &_knots, &_knots_before, &_energy, &_table,
				 &_growth, &_blade_species, &_species_steps, &_cover, &_view, &_cameras, &_counts }) {
		bytes += buffer->size();
	}
	_report->statistics.buffer_bytes = bytes;
}

} // namespace grass
