// SPDX-License-Identifier: MIT
// A frame of GpuField: the passes that choose what is drawn, and their counts.
#include "gpu/gpu_field.h"
#include "gpu/gpu_times.h"
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

bool GpuField::bind_cull(const FieldMultiMeshes &p_multimeshes) {
	RenderingServer *server = RenderingServer::get_singleton();
	_instances = { server->multimesh_get_buffer_rd_rid(p_multimeshes.picture), server->multimesh_get_buffer_rd_rid(p_multimeshes.shadows) };
	const RID commands = server->multimesh_get_command_buffer_rd_rid(p_multimeshes.picture);
	const RID shadow_commands = server->multimesh_get_command_buffer_rd_rid(p_multimeshes.shadows);
	if (!_instances[0].is_valid() || !commands.is_valid() || !_instances[1].is_valid() || !shadow_commands.is_valid()) {
		return false;
	}
	_cull.bind_buffer(GRASS_CULL_VIEW, _view.rid());
	_cull.bind_buffer(GRASS_CULL_CAMERAS, _cameras.rid());
	_cull.bind_buffer(GRASS_CULL_TABLE, _table.rid());
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

void GpuField::set_plants(const FieldSetup &p_setup, const std::vector<PlantTarget> &p_targets) {
	_plants.set(p_setup, p_targets);
	std::lock_guard lock(_report->mutex);
	report_memory();
	BackendStatistics &statistics = _report->statistics;
	statistics.drawn_plants = statistics.drawn_impostors = statistics.left_out_plants = 0;
}

bool GpuField::bind_plants(const ViewRecords &p_records) {
	_plants.set_reach(p_records.plant_reach);
	return !_plants.is_empty() &&
			_plants.bind({ _view.rid(), _cameras.rid(), _table.rid(), _cover.rid(), _patch, _sampler }, p_records.painted);
}

void GpuField::draw(const ViewRecords &p_records, const FieldMultiMeshes &p_multimeshes, bool p_measure) {
	if (!_has_kept) {
		keep_pool();
	}
	_has_kept = false;
	if (!_cull.is_ready()) {
		return;
	}
	int64_t uploaded = _view.upload(std::span<const GrassView>(&p_records.view, 1));
	uploaded += _cameras.upload(std::span<const GrassCamera>(p_records.cameras));
	if (!bind_cull(p_multimeshes)) {
		return;
	}
	if (p_measure) {
		report_times();
	}
	const bool has_plants = bind_plants(p_records);
	if (uploaded == 0 && !_table_changed && !_cull.has_changed() && !(has_plants && _plants.has_changed())) {
		if (has_plants || _plants.is_empty()) {
			_report->settled = p_records.number;
		}
		return; // the same view of the same tiles: the MultiMeshes are up to date
	}
	_table_changed = false;
	{
		Stopwatch watch(p_measure, Stopwatch::CULL, this);
		RenderingDevice *device = main_device();
		device->buffer_clear(_counts.rid(), 0, uint32_t(_counts.size()));
		if (has_plants) {
			_plants.clear_counts();
		}
		const int64_t list = device->compute_list_begin();
		dispatch_cull(list, p_multimeshes);
		if (has_plants) {
			_plants.dispatch(list, int(p_records.cameras.size()), p_records.painted);
		}
		device->compute_list_end();
	}
	report_counts(uploaded);
}

void GpuField::dispatch_cull(int64_t p_list, const FieldMultiMeshes &p_multimeshes) {
	const uint32_t capacity = p_multimeshes.picture_capacity, shadow_capacity = p_multimeshes.shadow_capacity;
	const auto dispatch = [&](uint32_t p_phase, uint32_t p_threads, uint32_t p_groups) {
		const uvec4 constants{ p_phase, p_threads, capacity, shadow_capacity };
		_cull.dispatch(p_list, constants, p_groups);
	};
	if (std::exchange(_begun, _instances) != _instances) {
		const uint32_t instances = std::max(capacity, shadow_capacity);
		dispatch(GRASS_CULL_BEGIN, instances, groups_of(instances, GRASS_CULL_GROUP));
		main_device()->compute_list_add_barrier(p_list);
	}
	const bool have_room = _tiles <= std::min(capacity, shadow_capacity); // for all tiles together
	for (uint32_t phase = GRASS_CULL_COUNT; phase <= GRASS_CULL_WRITE; phase++) {
		if (have_room && phase > GRASS_CULL_COUNT && phase < GRASS_CULL_WRITE) {
			continue;
		}
		dispatch(phase, uint32_t(_tiles), phase == GRASS_CULL_FIT ? 1 : groups_of(_tiles, GRASS_CULL_GROUP));
		main_device()->compute_list_add_barrier(p_list);
	}
}

void GpuField::report_counts(int64_t p_uploaded) {
	{
		std::lock_guard lock(_report->mutex);
		_report->statistics.culls++;
		report_memory();
		_report->statistics.uploaded_bytes += p_uploaded;
	}
	const auto receive = [report = _report](const PackedByteArray &p_data) {
		if (p_data.size() < COUNTS_TOLD * 4) {
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
	if (!RenderQueue::get_singleton()->read_later(_counts.rid(), COUNTS_TOLD * 4, receive)) {
		_table_changed = true; // the next frame counts again
	}
	if (!_plants.is_empty()) {
		const auto receive_plants = [report = _report, targets = _plants.get_targets()](const PackedByteArray &p_data) {
			if (p_data.size() >= GRASS_MAX_SPECIES * 4) {
				std::lock_guard lock(report->mutex);
				PlantPasses::tell(targets, p_data, report->statistics);
			}
		};
		RenderQueue::get_singleton()->read_later(_plants.counts(), PlantPasses::COUNT_BYTES, receive_plants);
	}
}

} // namespace grass
