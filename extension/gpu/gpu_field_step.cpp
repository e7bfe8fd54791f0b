// SPDX-License-Identifier: MIT
// A tick of GpuField: uploads, the simulation pass, and the readback of energies.
#include "core/base/cpu_clock.h"
#include "gpu/gpu_field.h"
#include "gpu/gpu_times.h"
#include "gpu/obstacles.h"
#include "gpu/render_queue.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>

using namespace godot;

namespace grass {

namespace {

int64_t count_blades(std::span<const GrassSlot> p_slots) {
	int64_t blades = 0;
	for (const GrassSlot &slot : p_slots) {
		blades += GRASS_BLADES_PER_TILE - int64_t(slot.blend.y);
	}
	return blades;
}

} // namespace

StepRecords::StepRecords(const StepInput &p_input, std::span<const float> p_energies) : number(p_input.number), step(p_input.step) {
	CpuClock clock;
	slots.resize(p_input.slots.size());
	passes = choose_passes(p_input, p_energies, slots);
	colliders.assign(p_input.colliders.begin(), p_input.colliders.end());
	collider_list.assign(p_input.collider_list.begin(), p_input.collider_list.end());
	planes.assign(p_input.planes.begin(), p_input.planes.end());
	growth.assign(p_input.growth.begin(), p_input.growth.end());
	forces.assign(p_input.forces.begin(), p_input.forces.end());
	species.assign(p_input.species.begin(), p_input.species.end());
	copy_ms = clock.lap();
}

// Binds the pool, and what its blades grow from.
void GpuField::bind_pool(GpuPass &r_pass) {
	r_pass.bind_buffer(GRASS_BINDING_KNOTS, _knots.rid());
	r_pass.bind_buffer(GRASS_BINDING_HALVES, _halves.rid());
	r_pass.bind_buffer(GRASS_BINDING_TWISTS, _twists.rid());
	r_pass.bind_sampled(GRASS_BINDING_PATCH, _sampler, _patch);
	r_pass.bind_image(GRASS_BINDING_POOL_TEXTURE, _pool_texture);
	r_pass.bind_buffer(GRASS_BINDING_GROWTH, _growth.rid());
	if (_kind.species) {
		r_pass.bind_buffer(GRASS_BINDING_BLADE_SPECIES, _blade_species.rid());
	}
}

void GpuField::bind_simulate() {
	for (GpuPass *pass : simulate_passes()) {
		bind_pool(*pass);
		pass->bind_buffer(GRASS_BINDING_ENERGY, _energy.rid());
		pass->bind_buffer(GRASS_BINDING_TILE_TABLE, _table.rid());
		if (_kind.species) {
			pass->bind_buffer(GRASS_BINDING_SPECIES_STEPS, _species_steps.rid());
		}
	}
	bind_pool(_join);
	_reader.bind(_knots.rid(), _halves.rid());
}

// The GPU runs steps of two fields one after the other, since both write this buffer.
void GpuField::make_room_to_work(uint32_t p_slots, uint32_t p_most) {
	static std::weak_ptr<GpuBuffer> of_all_fields;
	_work = of_all_fields.lock();
	if (!_work) {
		of_all_fields = _work = std::make_shared<GpuBuffer>();
	}
	const int64_t bytes = int64_t(std::min(std::bit_ceil(p_slots), p_most)) * WORK_BYTES;
	if (!_work->rid().is_valid() || bytes > _work->size()) {
		_work->allocate(bytes);
	}
}

int64_t GpuField::upload_slots(const StepRecords &p_records, uint32_t p_left) {
	if (p_left == 0) {
		return _slot_records.upload(std::span<const GrassSlot>(p_records.slots));
	}
	std::vector<GrassSlot> slots = p_records.slots;
	for (GrassSlot &slot : slots) {
		slot.list.w &= ~p_left;
	}
	return _slot_records.upload(std::span<const GrassSlot>(slots));
}

void GpuField::join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) {
	if (!_join.is_ready()) {
		return;
	}
	const int64_t uploaded = _join_records.upload(p_slots);
	_join.bind_buffer(GRASS_BINDING_SLOTS, _join_records.rid());
	RenderingDevice *device = main_device();
	const int64_t list = device->compute_list_begin();
	_join.dispatch(list, to_bytes(std::span<const GrassStep>(&p_step, 1)), uint32_t(p_slots.size()));
	device->compute_list_end();
	_has_moved = true;
	std::lock_guard lock(_report->mutex);
	_report->statistics.uploaded_bytes += uploaded;
}

void GpuField::step(const StepRecords &p_records, bool p_measure) {
	if (p_records.slots.empty() || !_simulate.is_ready()) {
		return;
	}
	CpuClock clock;
	if (p_measure) {
		report_times();
	}
	if (!_has_kept) {
		keep_pool();
	}
	if (_mix.is_created()) {
		_mix.keep(_pool_texture, _used_rows);
	}
	rest_before(p_records.slots);
	int64_t uploaded = 0;
	const uint32_t slots = uint32_t(p_records.slots.size()); // each belongs to one of the passes; the others return at once
	const uint32_t sharp = p_records.passes.edges > 0 && _simulate_edges.is_ready() ? uint32_t(p_records.passes.edges) : 0;
	const uint32_t free = p_records.passes.free > 0 && _simulate_free.is_ready() ? uint32_t(p_records.passes.free) : 0;
	const uint32_t crowds = p_records.passes.crowds > 0 && can_simulate_crowds() ? uint32_t(p_records.passes.crowds) : 0;
	const uint32_t crowds_left = p_records.passes.crowds > 0 && crowds == 0 ? GRASS_SLOT_CROWD : 0;
	const uint32_t sharp_left = p_records.passes.edges > 0 && sharp == 0 ? GRASS_SLOT_EDGES : 0;
	const uint32_t free_left = p_records.passes.free > 0 && free == 0 ? GRASS_SLOT_FREE : 0;
	uploaded += upload_slots(p_records, crowds_left | sharp_left | free_left);
	uploaded += _colliders.upload(std::span<const GrassCollider>(p_records.colliders));
	uploaded += _collider_list.upload(std::span<const uint32_t>(p_records.collider_list));
	uploaded += _planes.upload(std::span<const Eigen::Vector4f>(p_records.planes));
	uploaded += _forces.upload(std::span<const GrassForce>(p_records.forces));
	for (const SlotGrowth &growth : p_records.growth) {
		uploaded += _growth.write(growth.slot * int64_t(sizeof(growth.blades)), std::span<const vec4>(growth.blades));
		if (_kind.species) {
			uploaded += _blade_species.write(growth.slot * int64_t(sizeof(growth.species)), std::span<const uint8_t>(growth.species));
		}
	}
	if (_kind.species) {
		uploaded += _species_steps.upload(std::span<const GrassStep>(p_records.species));
	}
	const uint32_t room = uint32_t(count_working_tiles(device_limits()));
	const uint32_t most = room > 0 ? room : slots; // for one dispatch
	make_room_to_work(slots, room);
	for (GpuPass *pass : simulate_passes()) {
		pass->bind_buffer(GRASS_BINDING_WORK, _work->rid());
		pass->bind_buffer(GRASS_BINDING_SLOTS, _slot_records.rid());
		pass->bind_buffer(GRASS_BINDING_COLLIDERS, _colliders.rid());
		pass->bind_buffer(GRASS_BINDING_COLLIDER_LIST, _collider_list.rid());
		pass->bind_buffer(GRASS_BINDING_PLANES, _planes.rid());
		pass->bind_buffer(GRASS_BINDING_FORCES, _forces.rid());
	}
	{
		Stopwatch watch(p_measure, Stopwatch::SIMULATE);
		RenderingDevice *device = main_device();
		const int64_t list = device->compute_list_begin();
		GrassStep step = p_records.step;
		for (uint32_t first = 0; first < slots; first += most) {
			if (first > 0) {
				device->compute_list_add_barrier(list); // the next dispatch uses the same memory
			}
			step.contact.w = float(first);
			const PackedByteArray constants = to_bytes(std::span<const GrassStep>(&step, 1));
			const uint32_t count = std::min(slots - first, most);
			// The pass that takes longest begins first, so that little is left to do when its end comes.
			if (crowds > 0) {
				_simulate_crowds.dispatch(list, constants, count);
			}
			if (sharp > 0) {
				_simulate_edges.dispatch(list, constants, count);
			}
			if (crowds + sharp + free < slots) {
				_simulate.dispatch(list, constants, count);
			}
			if (free > 0) {
				_simulate_free.dispatch(list, constants, count);
			}
		}
		device->compute_list_end();
	}
	_has_kept = _has_moved = true;
	for (const GrassSlot &slot : p_records.slots) {
		_used_rows = std::max(_used_rows, slot.tile.w + 1);
	}
	const double upload_ms = clock.lap();
	const auto is_retired = [](const GrassSlot &p_slot) { return (p_slot.list.w & GRASS_SLOT_RETIRED) != 0; };
	const auto is_fresh = [](const GrassSlot &p_slot) { return (p_slot.list.w & GRASS_SLOT_FRESH) != 0; };
	const auto end = p_records.slots.end(), live = std::find_if_not(p_records.slots.begin(), end, is_retired);
	_table_changed = _table_changed || live != p_records.slots.begin() || std::any_of(live, end, is_fresh);
	{
		std::lock_guard lock(_report->mutex);
		BackendStatistics &statistics = _report->statistics;
		statistics.steps++;
		statistics.edge_tile_steps += sharp;
		statistics.free_tile_steps += free;
		statistics.crowd_tile_steps += crowds;
		statistics.simulated_blades += count_blades({ live, end });
		statistics.uploaded_bytes += uploaded;
		report_memory();
		statistics.upload_ms = p_records.copy_ms + upload_ms;
	}
	// The device makes the copy between the dispatches of this step and the next one, so it has this step's energies, which are those at
	// its start.
	const auto receive = [report = _report, number = p_records.number - 1](const PackedByteArray &p_data) {
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
	RenderQueue::get_singleton()->read_later(_energy.rid(), uint32_t(_pool_size * int64_t(sizeof(vec4))), receive);
}

} // namespace grass
