// SPDX-License-Identifier: MIT
#include "gpu/gpu_field.h"

#include "compute_shaders.gen.h"
#include "core/collider.h"
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
// Words of CountBuffer in cull.glsl; of them, those that tell what is drawn, and where some of these stand.
constexpr int COUNTS_TOLD = 2 * GRASS_ALL_LEVELS + 4, COUNTS = COUNTS_TOLD + 2 + GRASS_ALL_LEVELS * GRASS_TURNS;
constexpr int COUNT_BLADES = 2 * GRASS_ALL_LEVELS, COUNT_LEFT_OUT = COUNT_BLADES + 2;
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

StepRecords::StepRecords(const StepInput &p_input, float p_segment) : number(p_input.number), step(p_input.step) {
	CpuClock clock;
	slots.assign(p_input.slots.begin(), p_input.slots.end());
	colliders.assign(p_input.colliders.begin(), p_input.colliders.end());
	collider_list.assign(p_input.collider_list.begin(), p_input.collider_list.end());
	planes.assign(p_input.planes.begin(), p_input.planes.end());
	growth.assign(p_input.growth.begin(), p_input.growth.end());
	species.assign(p_input.species.begin(), p_input.species.end());
	std::vector<bool> sharp;
	for (const GrassCollider &collider : colliders) {
		sharp.push_back(is_sharp(collider, p_segment));
	}
	for (GrassSlot &slot : slots) {
		const auto begin = collider_list.begin() + slot.list.y, end = begin + slot.list.z;
		if (std::any_of(begin, end, [&](uint32_t p_collider) { return p_collider >= sharp.size() || sharp[p_collider]; })) {
			slot.list.w |= GRASS_SLOT_EDGES;
			sharp_slots++;
		}
	}
	copy_ms = clock.lap();
}

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

void GpuField::bind_simulate(const RID &p_patch) {
	for (GpuPass *pass : { &_simulate, &_simulate_edges }) {
		pass->bind_buffer(GRASS_BINDING_KNOTS, _knots.rid());
		pass->bind_buffer(GRASS_BINDING_KNOTS_BEFORE, _knots_before.rid());
		pass->bind_sampled(GRASS_BINDING_PATCH, _sampler, p_patch);
		pass->bind_image(GRASS_BINDING_POOL_TEXTURE, _pool_texture);
		pass->bind_buffer(GRASS_BINDING_ENERGY, _energy.rid());
		pass->bind_buffer(GRASS_BINDING_TILE_TABLE, _table.rid());
		pass->bind_buffer(GRASS_BINDING_GROWTH, _growth.rid());
		if (_has_species) {
			pass->bind_buffer(GRASS_BINDING_BLADE_SPECIES, _blade_species.rid());
			pass->bind_buffer(GRASS_BINDING_SPECIES_STEPS, _species_steps.rid());
		}
	}
}

int64_t GpuField::upload_slots(const StepRecords &p_records, bool p_takes_edges) {
	if (p_records.sharp_slots == 0 || p_takes_edges) {
		return _slot_records.upload(std::span<const GrassSlot>(p_records.slots));
	}
	std::vector<GrassSlot> slots = p_records.slots; // the driver still compiles: the other pass takes all of them
	for (GrassSlot &slot : slots) {
		slot.list.w &= ~GRASS_SLOT_EDGES;
	}
	return _slot_records.upload(std::span<const GrassSlot>(slots));
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
	const bool takes_edges = p_records.sharp_slots > 0 && _simulate_edges.is_ready();
	uploaded += upload_slots(p_records, takes_edges);
	uploaded += _colliders.upload(std::span<const GrassCollider>(p_records.colliders));
	uploaded += _collider_list.upload(std::span<const uint32_t>(p_records.collider_list));
	uploaded += _planes.upload(std::span<const Eigen::Vector4f>(p_records.planes));
	for (const SlotGrowth &growth : p_records.growth) {
		uploaded += _growth.write(growth.slot * int64_t(sizeof(growth.blades)), std::span<const vec4>(growth.blades));
		if (_has_species) {
			uploaded += _blade_species.write(growth.slot * int64_t(sizeof(growth.species)), std::span<const uint8_t>(growth.species));
		}
	}
	if (_has_species) {
		uploaded += _species_steps.upload(std::span<const GrassStep>(p_records.species));
	}
	for (GpuPass *pass : { &_simulate, &_simulate_edges }) {
		pass->bind_buffer(GRASS_BINDING_SLOTS, _slot_records.rid());
		pass->bind_buffer(GRASS_BINDING_COLLIDERS, _colliders.rid());
		pass->bind_buffer(GRASS_BINDING_COLLIDER_LIST, _collider_list.rid());
		pass->bind_buffer(GRASS_BINDING_PLANES, _planes.rid());
	}
	{
		Stopwatch watch(p_measure, "GrassField simulate");
		RenderingDevice *device = main_device();
		const int64_t list = device->compute_list_begin();
		const uint32_t slots = uint32_t(p_records.slots.size()), sharp = takes_edges ? uint32_t(p_records.sharp_slots) : 0;
		if (sharp < slots) { // each tile is one of the passes'; the other leaves it at once
			_simulate.dispatch(list, record_bytes(p_records.step), slots);
		}
		if (sharp > 0) {
			_simulate_edges.dispatch(list, record_bytes(p_records.step), slots);
		}
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
		statistics.edge_tile_steps += takes_edges ? p_records.sharp_slots : 0;
		statistics.simulated_blades += live * GRASS_BLADES_PER_TILE;
		statistics.uploaded_bytes += uploaded;
		report_memory();
		statistics.upload_ms = p_records.copy_ms + upload_ms;
	}
	// The device copies it between this step's dispatch and the next one's, so it is this step's.
	const auto receive = [report = _report, number = p_records.number](const PackedByteArray &p_data) {
		std::lock_guard lock(report->mutex);
		report->energy_step = number;
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
	RenderQueue::get_singleton()->read_later(_energy.rid(), uint32_t(_slots * int64_t(sizeof(vec4))), receive);
}

void GpuField::set_cover(int64_t p_first, const std::vector<TileCover::Tile> &p_tiles) {
	const int64_t uploaded = _cover.write(p_first * int64_t(sizeof(TileCover::Tile)), std::span<const TileCover::Tile>(p_tiles));
	_table_changed = true; // other tiles may be drawn now
	std::lock_guard lock(_report->mutex);
	_report->statistics.uploaded_bytes += uploaded;
}

bool GpuField::bind_cull(const FieldMultiMeshes &p_multimeshes) {
	RenderingServer *server = RenderingServer::get_singleton();
	const RID instances = server->multimesh_get_buffer_rd_rid(p_multimeshes.picture);
	const RID commands = server->multimesh_get_command_buffer_rd_rid(p_multimeshes.picture);
	const RID shadow_instances = server->multimesh_get_buffer_rd_rid(p_multimeshes.shadows);
	const RID shadow_commands = server->multimesh_get_command_buffer_rd_rid(p_multimeshes.shadows);
	if (!instances.is_valid() || !commands.is_valid() || !shadow_instances.is_valid() || !shadow_commands.is_valid()) {
		return false;
	}
	_cull.bind_buffer(GRASS_CULL_VIEW, _view.rid());
	_cull.bind_buffer(GRASS_CULL_CAMERAS, _cameras.rid());
	_cull.bind_buffer(GRASS_CULL_TABLE, _table.rid());
	_cull.bind_buffer(GRASS_CULL_COVER, _cover.rid());
	_cull.bind_buffer(GRASS_CULL_COUNTS, _counts.rid());
	_cull.bind_buffer(GRASS_CULL_INSTANCES, instances);
	_cull.bind_buffer(GRASS_CULL_COMMANDS, commands);
	_cull.bind_buffer(GRASS_CULL_SHADOW_INSTANCES, shadow_instances);
	_cull.bind_buffer(GRASS_CULL_SHADOW_COMMANDS, shadow_commands);
	return true;
}

void GpuField::draw(const ViewRecords &p_records, const FieldMultiMeshes &p_multimeshes, bool p_measure) {
	if (!_cull.is_ready()) {
		return;
	}
	int64_t uploaded = _view.upload(std::span<const GrassView>(&p_records.view, 1));
	uploaded += _cameras.upload(std::span<const GrassCamera>(p_records.cameras));
	if (!bind_cull(p_multimeshes)) {
		return;
	}
	if (p_measure) {
		read_times();
	}
	if (uploaded == 0 && !_table_changed && !_cull.has_changed()) {
		return; // the same view of the same tiles: what is in the MultiMeshes still holds
	}
	_table_changed = false;
	{
		Stopwatch watch(p_measure, "GrassField cull");
		RenderingDevice *device = main_device();
		device->buffer_clear(_counts.rid(), 0, uint32_t(_counts.size()));
		const uint32_t groups = groups_of(_tiles, GRASS_CULL_GROUP);
		const bool have_room = _tiles <= _instances && _tiles <= _shadow_instances; // all at once
		const int64_t list = device->compute_list_begin();
		for (uint32_t phase = GRASS_CULL_COUNT; phase <= GRASS_CULL_WRITE; phase++) {
			if (have_room && phase > GRASS_CULL_COUNT && phase < GRASS_CULL_WRITE) {
				continue;
			}
			const uvec4 constants{ phase, uint32_t(_tiles), uint32_t(_instances), uint32_t(_shadow_instances) };
			_cull.dispatch(list, record_bytes(constants), phase == GRASS_CULL_FIT ? 1 : groups);
			device->compute_list_add_barrier(list);
		}
		device->compute_list_end();
	}
	report_counts(uploaded);
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
	RenderQueue::get_singleton()->read_later(_counts.rid(), COUNTS_TOLD * 4, receive);
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
