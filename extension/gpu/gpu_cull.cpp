// SPDX-License-Identifier: MIT
#include "gpu/gpu_cull.h"

#include "core/field/device_fit.h"
#include "draw/shared_shader.h"
#include "gpu/field_passes.h"
#include "gpu/gpu_times.h"
#include "gpu/pool_rows.h"
#include "gpu/render_queue.h"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace grass {

namespace {

uint32_t groups_of(int64_t p_threads, int64_t p_group) {
	return uint32_t((p_threads + p_group - 1) / p_group);
}

} // namespace

void GpuCull::create(const Ref<Texture2DRD> &p_drawn) {
	_counts.allocate(COUNTS * 4);
	_drawn = p_drawn;
	_cull.create(CULL_CODE, has_shader_workers() ? GpuPass::Compile::LATER : GpuPass::Compile::NOW);
}

// Begins with another field. Buffers have spare room, so that a growing field can usually keep them.
void GpuCull::set_field(const FieldSetup &p_setup) {
	_is_changed = true;
	_tiles = p_setup.grid.get_tile_count();
	const int64_t cover = p_setup.is_mapped ? tile_room(_tiles) * int64_t(sizeof(TileCover::Tile)) : 0;
	if (!p_setup.is_mapped || cover > _cover.size()) {
		_cover.resize(cover);
	}
}

void GpuCull::set_cover(int64_t p_first, const PackedByteArray &p_tiles) {
	const int64_t uploaded = _cover.write(p_first * int64_t(sizeof(TileCover::Tile)), p_tiles);
	_is_changed = true;
	std::lock_guard lock(_report->mutex);
	_report->statistics.uploaded_bytes += uploaded;
}

void GpuCull::set_plants(const FieldSetup &p_setup, const std::vector<PlantTarget> &p_targets) {
	_plants.set(p_setup, p_targets);
	std::lock_guard lock(_report->mutex);
	BackendStatistics &statistics = _report->statistics;
	statistics.drawn_plants = statistics.drawn_impostors = statistics.left_out_plants = 0;
}

bool GpuCull::draw(const ViewRecords &p_records, const FieldMultiMeshes &p_multimeshes, const Sources &p_sources, bool p_measure,
		const void *p_owner) {
	if (!_cull.is_ready()) {
		return false;
	}
	int64_t uploaded = _view.upload(std::span<const GrassView>(&p_records.view, 1));
	uploaded += _cameras.upload(std::span<const GrassCamera>(p_records.cameras));
	if (!bind(p_multimeshes, p_sources)) {
		return false;
	}
	if (p_measure) {
		report_gpu_times(p_owner, *_report);
	}
	const bool has_plants = bind_plants(p_records, p_sources);
	if (uploaded == 0 && !_is_changed && !_cull.has_changed() && !(has_plants && _plants.has_changed())) {
		if (has_plants || _plants.is_empty()) {
			_report->settled = p_records.number;
		}
		return false; // the same view of the same tiles: the MultiMeshes are up to date
	}
	_is_changed = false;
	{
		Stopwatch watch(p_measure, Stopwatch::CULL, p_owner);
		RenderingDevice *device = main_device();
		device->buffer_clear(_counts.rid(), 0, uint32_t(_counts.size()));
		if (has_plants) {
			_plants.clear_counts();
		}
		const int64_t list = device->compute_list_begin();
		dispatch(list, p_multimeshes);
		if (has_plants) {
			_plants.dispatch(list, int(p_records.cameras.size()), p_records.painted);
		}
		device->compute_list_end();
	}
	report_counts(uploaded);
	return true;
}

bool GpuCull::bind(const FieldMultiMeshes &p_multimeshes, const Sources &p_sources) {
	RenderingServer *server = RenderingServer::get_singleton();
	_instances = { server->multimesh_get_buffer_rd_rid(p_multimeshes.picture), server->multimesh_get_buffer_rd_rid(p_multimeshes.shadows) };
	const RID commands = server->multimesh_get_command_buffer_rd_rid(p_multimeshes.picture);
	const RID shadow_commands = server->multimesh_get_command_buffer_rd_rid(p_multimeshes.shadows);
	if (!_instances[0].is_valid() || !commands.is_valid() || !_instances[1].is_valid() || !shadow_commands.is_valid()) {
		return false;
	}
	_cull.bind_buffer(GRASS_CULL_VIEW, _view.rid());
	_cull.bind_buffer(GRASS_CULL_CAMERAS, _cameras.rid());
	_cull.bind_buffer(GRASS_CULL_TABLE, p_sources.table);
	_cull.bind_buffer(GRASS_CULL_COVER, _cover.rid());
	_cull.bind_buffer(GRASS_CULL_COUNTS, _counts.rid());
	_cull.bind_buffer(GRASS_CULL_INSTANCES, _instances[0]);
	_cull.bind_buffer(GRASS_CULL_COMMANDS, commands);
	_cull.bind_buffer(GRASS_CULL_SHADOW_INSTANCES, _instances[1]);
	_cull.bind_buffer(GRASS_CULL_SHADOW_COMMANDS, shadow_commands);
	make_drawn_texture(int64_t(p_multimeshes.picture_capacity) + int64_t(p_multimeshes.shadow_capacity));
	_cull.bind_image(GRASS_CULL_DRAWN, _drawn_texture);
	return true;
}

bool GpuCull::bind_plants(const ViewRecords &p_records, const Sources &p_sources) {
	_plants.set_reach(p_records.plant_reach);
	return !_plants.is_empty() &&
			_plants.bind(
					{ _view.rid(), _cameras.rid(), p_sources.table, _cover.rid(), p_sources.patch, p_sources.sampler }, p_records.painted);
}

// Makes row 0, and one row for each GRASS_PLACES_PER_ROW.
void GpuCull::make_drawn_texture(int64_t p_places) {
	const int rows = 1 + int((p_places + GRASS_PLACES_PER_ROW - 1) / GRASS_PLACES_PER_ROW);
	if (std::exchange(_drawn_rows, rows) != rows) {
		const TextureUsage usage = RenderingDevice::TEXTURE_USAGE_STORAGE_BIT | RenderingDevice::TEXTURE_USAGE_SAMPLING_BIT;
		const RID made = make_texture(RenderingDevice::DATA_FORMAT_R32G32B32A32_SFLOAT, 2 * GRASS_PLACES_PER_ROW, rows, usage);
		replace_texture(_drawn, std::exchange(_drawn_texture, made), made);
		_is_changed = true;
	}
}

void GpuCull::dispatch(int64_t p_list, const FieldMultiMeshes &p_multimeshes) {
	const uint32_t capacity = p_multimeshes.picture_capacity, shadow_capacity = p_multimeshes.shadow_capacity;
	const auto run = [&](uint32_t p_phase, uint32_t p_threads, uint32_t p_groups) {
		const uvec4 constants{ p_phase, p_threads, capacity, shadow_capacity };
		_cull.dispatch(p_list, constants, p_groups);
	};
	if (std::exchange(_begun, _instances) != _instances) {
		const uint32_t instances = std::max(capacity, shadow_capacity);
		run(GRASS_CULL_BEGIN, instances, groups_of(instances, GRASS_CULL_GROUP));
		main_device()->compute_list_add_barrier(p_list);
	}
	const bool have_room = _tiles <= std::min(capacity, shadow_capacity); // for all tiles together
	for (uint32_t phase = GRASS_CULL_COUNT; phase <= GRASS_CULL_WRITE; phase++) {
		if (have_room && phase > GRASS_CULL_COUNT && phase < GRASS_CULL_WRITE) {
			continue;
		}
		run(phase, uint32_t(_tiles), phase == GRASS_CULL_FIT ? 1 : groups_of(_tiles, GRASS_CULL_GROUP));
		main_device()->compute_list_add_barrier(p_list);
	}
}

void GpuCull::report_counts(int64_t p_uploaded) {
	{
		std::lock_guard lock(_report->mutex);
		_report->statistics.culls++;
		_report->statistics.uploaded_bytes += p_uploaded;
	}
	const auto receive = [report = _report](const PackedByteArray &p_data) {
		if (p_data.size() < COUNTS_REPORTED * 4) {
			return;
		}
		std::lock_guard lock(report->mutex);
		BackendStatistics &statistics = report->statistics;
		for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
			statistics.drawn_tiles[size_t(level)] = p_data.decode_u32(level * 4);
		}
		statistics.drawn_blades = p_data.decode_u32(4 * COUNT_BLADES);
		statistics.shadow_blades = p_data.decode_u32(4 * (COUNT_BLADES + 1));
		statistics.left_out_tiles = { p_data.decode_u32(4 * COUNT_LEFT_OUT), p_data.decode_u32(4 * (COUNT_LEFT_OUT + 1)) };
	};
	if (!RenderQueue::get_singleton()->read_later(_counts.rid(), COUNTS_REPORTED * 4, receive)) {
		_is_changed = true; // the next frame counts again
	}
	if (!_plants.is_empty()) {
		const auto receive_plants = [report = _report, targets = _plants.get_targets()](const PackedByteArray &p_data) {
			if (p_data.size() >= GRASS_MAX_SPECIES * 4) {
				std::lock_guard lock(report->mutex);
				PlantPasses::count(targets, p_data, report->statistics);
			}
		};
		RenderQueue::get_singleton()->read_later(_plants.counts(), PlantPasses::COUNT_BYTES, receive_plants);
	}
}

int64_t GpuCull::get_memory_usage() const {
	int64_t bytes = int64_t(_drawn_rows) * 2 * GRASS_PLACES_PER_ROW * int64_t(sizeof(vec4)) + _plants.get_memory_usage();
	for (const GpuBuffer *buffer : { &_view, &_cameras, &_cover, &_counts }) {
		bytes += buffer->size();
	}
	return bytes;
}

void GpuCull::free(const FieldMultiMeshes &p_multimeshes) {
	RenderingServer *server = RenderingServer::get_singleton();
	if (_drawn.is_valid()) { // the texture resource first, since it has a view of what is freed next
		_drawn->set_texture_rd_rid(RID());
		_drawn.unref();
	}
	const auto commands_of = [server](const RID &p_multimesh) {
		return p_multimesh.is_valid() ? server->multimesh_get_command_buffer_rd_rid(p_multimesh) : RID(); // it was never shown
	};
	for (const RID &rid :
			{ std::exchange(_drawn_texture, RID()), commands_of(p_multimeshes.picture), commands_of(p_multimeshes.shadows) }) {
		if (rid.is_valid()) {
			main_device()->free_rid(rid);
		}
	}
	_plants.free();
	_cull.free();
	for (GpuBuffer *buffer : { &_view, &_cameras, &_cover, &_counts }) {
		buffer->free();
	}
}

} // namespace grass
