// SPDX-License-Identifier: MIT
#include "gpu/gpu_field.h"

#include "compute_shaders.gen.h"
#include "core/cpu_clock.h"
#include "gpu/render_queue.h"

#include <godot_cpp/classes/rd_sampler_state.hpp>
#include <godot_cpp/classes/rd_texture_format.hpp>
#include <godot_cpp/classes/rd_texture_view.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <bit>
#include <cstring>

using namespace godot;

namespace grass {

namespace {

constexpr int POOL_TEXTURE_WIDTH = GRASS_KNOTS * GRASS_POOL_BLADES_PER_ROW;
constexpr int64_t KNOT_FLOATS_PER_SLOT = 3 * GRASS_FREE_KNOTS * GRASS_BLADES_PER_TILE;

template <typename T> PackedByteArray record_bytes(const T &p_record) {
	PackedByteArray bytes;
	bytes.resize(sizeof(T));
	std::memcpy(bytes.ptrw(), &p_record, sizeof(T));
	return bytes;
}

uint32_t groups_of(int64_t p_threads, int64_t p_group) {
	return uint32_t((p_threads + p_group - 1) / p_group);
}

// Brackets work between two GPU timestamps, named so that read_times() finds them.
class Stopwatch {
public:
	Stopwatch(bool p_measure, const char *p_end) : _end(p_measure ? p_end : nullptr) {
		if (_end != nullptr) {
			main_device()->capture_timestamp("GrassField");
		}
	}
	~Stopwatch() {
		if (_end != nullptr) {
			main_device()->capture_timestamp(_end);
		}
	}

private:
	const char *_end;
};

} // namespace

StepRecords::StepRecords(const StepInput &p_input) : number(p_input.number), step(p_input.step) {
	CpuClock clock;
	slots.assign(p_input.slots.begin(), p_input.slots.end());
	colliders.assign(p_input.colliders.begin(), p_input.colliders.end());
	collider_list.assign(p_input.collider_list.begin(), p_input.collider_list.end());
	planes.assign(p_input.planes.begin(), p_input.planes.end());
	copy_ms = clock.lap();
}

void GpuField::create(const FieldSetup &p_setup, const RID &p_patch, const Ref<Texture2DRD> &p_pool) {
	RenderingDevice *device = main_device();
	_tiles = p_setup.grid.get_tile_count();
	_instances = p_setup.instance_capacity();
	_slots = p_setup.pool_tiles;
	_knots.allocate(_slots * KNOT_FLOATS_PER_SLOT * 4);
	_knots_before.allocate(_slots * KNOT_FLOATS_PER_SLOT * 4);
	_energy.allocate(_slots * 4);
	set_tiles(_tiles);
	_counts.allocate(2 * GRASS_LOD_LEVELS * 4);

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

	_simulate.create(shader::SIMULATE_SPIRV, "GrassField simulate");
	_cull.create(shader::CULL_SPIRV, "GrassField cull");
	bind_simulate(RenderingServer::get_singleton()->texture_get_rd_texture(p_patch));
	std::lock_guard lock(_report->mutex);
	report_memory();
}

void GpuField::set_tiles(int64_t p_tiles) {
	_tiles = p_tiles;
	_table_changed = true;
	if (_tiles * 4 <= _table.size()) {
		_table.clear();
		return;
	}
	_table.allocate(int64_t(std::bit_ceil(uint64_t(_tiles))) * 4);
	_simulate.bind_buffer(GRASS_BINDING_TILE_TABLE, _table.rid());
}

void GpuField::bind_simulate(const RID &p_patch) {
	_simulate.bind_buffer(GRASS_BINDING_KNOTS, _knots.rid());
	_simulate.bind_buffer(GRASS_BINDING_KNOTS_BEFORE, _knots_before.rid());
	_simulate.bind_sampled(GRASS_BINDING_PATCH, _sampler, p_patch);
	_simulate.bind_image(GRASS_BINDING_POOL_TEXTURE, _pool_texture);
	_simulate.bind_buffer(GRASS_BINDING_ENERGY, _energy.rid());
	_simulate.bind_buffer(GRASS_BINDING_TILE_TABLE, _table.rid());
}

void GpuField::step(const StepRecords &p_records, bool p_measure) {
	if (p_records.slots.empty() || !_simulate.is_ready()) {
		return;
	}
	CpuClock clock;
	if (p_measure) {
		read_times();
	}
	int64_t uploaded = 0;
	uploaded += _slot_records.upload(std::span<const GrassSlot>(p_records.slots));
	uploaded += _colliders.upload(std::span<const GrassCollider>(p_records.colliders));
	uploaded += _collider_list.upload(std::span<const uint32_t>(p_records.collider_list));
	uploaded += _planes.upload(std::span<const Eigen::Vector4f>(p_records.planes));
	_simulate.bind_buffer(GRASS_BINDING_SLOTS, _slot_records.rid());
	_simulate.bind_buffer(GRASS_BINDING_COLLIDERS, _colliders.rid());
	_simulate.bind_buffer(GRASS_BINDING_COLLIDER_LIST, _collider_list.rid());
	_simulate.bind_buffer(GRASS_BINDING_PLANES, _planes.rid());
	{
		Stopwatch watch(p_measure, "GrassField simulate");
		RenderingDevice *device = main_device();
		const int64_t list = device->compute_list_begin();
		_simulate.dispatch(list, record_bytes(p_records.step), uint32_t(p_records.slots.size()));
		device->compute_list_end();
	}
	const double upload_ms = clock.lap();
	int64_t live = 0;
	for (const GrassSlot &slot : p_records.slots) {
		live += (slot.list.w & GRASS_SLOT_RETIRED) == 0 ? 1 : 0;
		_table_changed = _table_changed || (slot.list.w & (GRASS_SLOT_FRESH | GRASS_SLOT_RETIRED)) != 0;
	}
	{
		std::lock_guard lock(_report->mutex);
		BackendStatistics &statistics = _report->statistics;
		statistics.steps++;
		statistics.simulated_blades += live * GRASS_BLADES_PER_TILE;
		statistics.uploaded_bytes += uploaded;
		report_memory();
		statistics.upload_ms = p_records.copy_ms + upload_ms;
	}
	// The device copies it between this step's dispatch and the next one's, so it is this step's.
	const auto receive = [report = _report, number = p_records.number](const PackedByteArray &p_data) {
		std::lock_guard lock(report->mutex);
		report->energy_step = number;
		report->energy.resize(size_t(p_data.size()) / 4);
		std::memcpy(report->energy.data(), p_data.ptr(), report->energy.size() * 4);
	};
	RenderQueue::get_singleton()->read_later(_energy.rid(), uint32_t(_slots * 4), receive);
}

void GpuField::draw(const GrassView &p_view, const RID &p_multimesh, bool p_measure) {
	RenderingServer *server = RenderingServer::get_singleton();
	const RID instances = server->multimesh_get_buffer_rd_rid(p_multimesh);
	const RID commands = server->multimesh_get_command_buffer_rd_rid(p_multimesh);
	if (!_cull.is_ready() || !instances.is_valid() || !commands.is_valid()) {
		return;
	}
	const int64_t uploaded = _view.upload(std::span<const GrassView>(&p_view, 1));
	if (p_measure) {
		read_times();
	}
	if (uploaded == 0 && !_table_changed && instances == _culled_into) {
		return; // the same view of the same tiles: what is in the MultiMesh still holds
	}
	_table_changed = false;
	_culled_into = instances;
	_cull.bind_buffer(GRASS_CULL_VIEW, _view.rid());
	_cull.bind_buffer(GRASS_CULL_TABLE, _table.rid());
	_cull.bind_buffer(GRASS_CULL_COUNTS, _counts.rid());
	_cull.bind_buffer(GRASS_CULL_INSTANCES, instances);
	_cull.bind_buffer(GRASS_CULL_COMMANDS, commands);
	{
		Stopwatch watch(p_measure, "GrassField cull");
		RenderingDevice *device = main_device();
		device->buffer_clear(_counts.rid(), 0, uint32_t(_counts.size()));
		const uint32_t groups = groups_of(_tiles, GRASS_CULL_GROUP);
		const int64_t list = device->compute_list_begin();
		for (uint32_t phase = 0; phase < 2; phase++) {
			_cull.dispatch(list, record_bytes(uvec4{ phase, uint32_t(_tiles), uint32_t(_instances), 0 }), groups);
			device->compute_list_add_barrier(list);
		}
		device->compute_list_end();
	}
	{
		std::lock_guard lock(_report->mutex);
		_report->statistics.culls++;
		report_memory();
		_report->statistics.uploaded_bytes += uploaded;
	}
	RenderQueue::get_singleton()->read_later(_counts.rid(), GRASS_LOD_LEVELS * 4, [report = _report](const PackedByteArray &p_data) {
		std::lock_guard lock(report->mutex);
		for (int level = 0; level < GRASS_LOD_LEVELS && level < p_data.size() / 4; level++) {
			report->statistics.drawn_tiles[size_t(level)] = p_data.decode_u32(level * 4);
		}
	});
}

// Timestamps of a frame that the GPU has finished: each of ours ends a stretch that began at the one before it.
void GpuField::read_times() {
	RenderingDevice *device = main_device();
	double simulate = 0.0, cull = 0.0;
	int steps = 0; // a slow frame holds several
	const uint32_t count = device->get_captured_timestamps_count();
	for (uint32_t i = 1; i < count; i++) {
		const String name = device->get_captured_timestamp_name(i);
		if (!name.begins_with("GrassField ") || device->get_captured_timestamp_name(i - 1) != String("GrassField")) {
			continue;
		}
		const double ms = double(device->get_captured_timestamp_gpu_time(i) - device->get_captured_timestamp_gpu_time(i - 1)) * 1e-6;
		if (name == String("GrassField cull")) {
			cull = ms;
		} else {
			simulate += ms;
			steps++;
		}
	}
	std::lock_guard lock(_report->mutex);
	if (steps > 0) { // else that frame had no such pass: the last known time stands
		_report->statistics.simulate_ms = simulate / steps;
	}
	if (cull > 0.0) {
		_report->statistics.cull_ms = cull;
	}
}

std::vector<Eigen::Vector3f> GpuField::read_knots(int p_slot, int p_blade) {
	std::vector<Eigen::Vector3f> knots(GRASS_KNOTS, Eigen::Vector3f::Zero());
	const PackedByteArray data =
			main_device()->buffer_get_data(_knots.rid(), uint32_t(p_slot * KNOT_FLOATS_PER_SLOT * 4), uint32_t(KNOT_FLOATS_PER_SLOT * 4));
	for (int component = 0; component < 3 && !data.is_empty(); component++) {
		for (int knot = GRASS_CLAMPED_KNOTS; knot < GRASS_KNOTS; knot++) {
			const int at = (component * GRASS_FREE_KNOTS + knot - GRASS_CLAMPED_KNOTS) * GRASS_BLADES_PER_TILE + p_blade;
			knots[size_t(knot)][component] = float(data.decode_float(at * 4));
		}
	}
	return knots;
}

void GpuField::free(const RID &p_multimesh) {
	RenderingServer *server = RenderingServer::get_singleton();
	RenderingDevice *device = main_device();
	if (_pool.is_valid()) { // the texture resource first: it holds a view of what is freed next
		_pool->set_texture_rd_rid(RID());
		_pool.unref();
	}
	for (const RID &rid : { _pool_texture, _sampler, server->multimesh_get_command_buffer_rd_rid(p_multimesh) }) {
		if (rid.is_valid()) {
			device->free_rid(rid);
		}
	}
	_pool_texture = _sampler = RID();
	_simulate.free();
	_cull.free();
	for (GpuBuffer *buffer :
			{ &_slot_records, &_colliders, &_collider_list, &_planes, &_knots, &_knots_before, &_energy, &_table, &_view, &_counts }) {
		buffer->free();
	}
}

// The report's mutex is held.
void GpuField::report_memory() {
	int64_t bytes = _slots * POOL_TEXTURE_WIDTH * 8;
	for (const GpuBuffer *buffer :
			{ &_slot_records, &_colliders, &_collider_list, &_planes, &_knots, &_knots_before, &_energy, &_table, &_view, &_counts }) {
		bytes += buffer->size();
	}
	_report->statistics.buffer_bytes = bytes;
}

} // namespace grass
