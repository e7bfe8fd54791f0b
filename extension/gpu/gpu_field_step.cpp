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

int64_t count_blades(const GrassSlot &p_slot) {
	return p_slot.list.w & GRASS_SLOT_RETIRED ? 0 : GRASS_BLADES_PER_TILE - int64_t(p_slot.blend.y);
}

// Returns whether the tile can share a workgroup.
bool is_thinned(const GrassSlot &p_slot) {
	return 2 * int(p_slot.blend.y) >= GRASS_BLADES_PER_TILE;
}

uint32_t count_groups(const SlotPasses &p_passes) {
	uint32_t count = 0;
	for (const PassGroups &pass : p_passes) {
		count += pass.single.count + pass.many.count;
	}
	return count;
}

} // namespace

StepRecords::StepRecords(const StepInput &p_input, std::span<const float> p_energies, const PassKind &p_kind) :
		number(p_input.number), step(p_input.step) {
	CpuClock clock;
	slots.resize(p_input.slots.size());
	const bool may_share = std::ranges::any_of(p_input.slots, is_thinned) && can_share(p_kind);
	const bool wants_strains = std::ranges::any_of(p_input.slots, [&](const GrassSlot &p_slot) { return takes_strains(p_slot, p_input); });
	const bool may_use_strains = wants_strains && has_strains(p_kind);
	passes = choose_passes(p_input, p_energies, { uint32_t(count_working_tiles(device_limits())), may_share, may_use_strains }, slots);
	colliders.assign(p_input.colliders.begin(), p_input.colliders.end());
	collider_list.assign(p_input.collider_list.begin(), p_input.collider_list.end());
	planes.assign(p_input.planes.begin(), p_input.planes.end());
	growth.assign(p_input.growth.begin(), p_input.growth.end());
	forces.assign(p_input.forces.begin(), p_input.forces.end());
	species.assign(p_input.species.begin(), p_input.species.end());
	followers.assign(p_input.followers.begin(), p_input.followers.end());
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
	for (auto &passes : _simulate) {
		for (GpuPass &pass : passes) {
			bind_pool(pass);
			pass.bind_buffer(GRASS_BINDING_ENERGY, _energy.rid());
			pass.bind_buffer(GRASS_BINDING_TILE_TABLE, _table.rid());
			if (_kind.species) {
				pass.bind_buffer(GRASS_BINDING_SPECIES_STEPS, _species_steps.rid());
			}
		}
	}
	bind_pool(_join);
	_reader.bind(_knots.rid(), _halves.rid());
}

// The GPU runs steps of two fields one after the other, since both write this buffer. Where it has no room (p_most is 0), each field has
// one of its own: steps of a few tiles take long, and would wait for each other.
void GpuField::make_room_to_work(uint32_t p_groups, uint32_t p_most) {
	if (p_most == 0) {
		if (!_work) {
			_work = std::make_shared<GpuBuffer>();
			_work->allocate(0);
		}
		return;
	}
	static std::weak_ptr<GpuBuffer> of_all_fields;
	_work = of_all_fields.lock();
	if (!_work) {
		of_all_fields = _work = std::make_shared<GpuBuffer>();
	}
	const int64_t bytes = int64_t(std::min(std::bit_ceil(p_groups), p_most)) * WORK_BYTES;
	if (!_work->rid().is_valid() || bytes > _work->size()) {
		_work->allocate(bytes);
	}
}

GpuPass &GpuField::find_pass(SlotPass p_pass, bool p_many) {
	const auto own = [this, p_many](SlotPass p_kind) -> GpuPass & { return _simulate[size_t(p_kind)][p_many ? 1 : 0]; };
	if (!own(p_pass).is_created()) {
		own(p_pass).create(simulate_code(_kind, p_pass, p_many), GpuPass::Compile::LATER);
		bind_simulate();
	}
	if (p_pass == SlotPass::CROWD && !own(p_pass).is_ready()) {
		return find_pass(SlotPass::EDGES, p_many);
	}
	return own(p_pass).is_ready() ? own(p_pass) : own(SlotPass::PLAIN);
}

// The passes that take longest begin first, so that little is left to do when the last one ends.
void GpuField::dispatch_simulate(const StepRecords &p_records) {
	struct Work {
		SlotGroups groups;
		GpuPass *pass;
	};
	std::vector<Work> works;
	for (int pass = 0; pass < SLOT_PASSES; pass++) {
		const PassGroups &groups = p_records.passes[size_t(pass)];
		for (const bool many : { false, true }) {
			if (const SlotGroups &some = many ? groups.many : groups.single; some.count > 0) {
				works.push_back({ some, &find_pass(SlotPass(pass), many) });
			}
		}
	}
	for (const Work &work : works) {
		work.pass->bind_buffer(GRASS_BINDING_SLOTS, _slot_records.rid());
		work.pass->bind_buffer(GRASS_BINDING_FORCES, _forces.rid());
		if (work.pass == &_simulate[size_t(SlotPass::STRAINS)][1]) {
			work.pass->bind_buffer(GRASS_BINDING_SECTIONS, _section_records.rid());
			continue;
		}
		work.pass->bind_buffer(GRASS_BINDING_WORK, _work->rid());
		work.pass->bind_buffer(GRASS_BINDING_COLLIDERS, _colliders.rid());
		work.pass->bind_buffer(GRASS_BINDING_COLLIDER_LIST, _collider_list.rid());
		work.pass->bind_buffer(GRASS_BINDING_PLANES, _planes.rid());
	}
	const uint32_t groups = count_groups(p_records.passes), room = uint32_t(count_working_tiles(device_limits()));
	const uint32_t most = room > 0 ? room : groups; // at once
	RenderingDevice *device = main_device();
	const int64_t list = device->compute_list_begin();
	GrassStep step = p_records.step;
	for (uint32_t first = 0; first < groups; first += most) {
		if (first > 0) {
			device->compute_list_add_barrier(list); // the next dispatches use the same memory
		}
		for (const Work &work : works) {
			const uint32_t begin = std::max(first, work.groups.first), end = std::min(first + most, work.groups.first + work.groups.count);
			if (begin < end) {
				step.contact.w = float(begin);
				work.pass->dispatch(list, step, end - begin);
			}
		}
	}
	device->compute_list_end();
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
	_has_moved = true;
	std::lock_guard lock(_report->mutex);
	_report->statistics.uploaded_bytes += uploaded;
}

void GpuField::step(const StepRecords &p_records, bool p_measure) {
	if (p_records.slots.empty() || !_simulate[size_t(SlotPass::PLAIN)][0].is_ready()) {
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
	uploaded += _slot_records.upload(std::span<const GrassSlot>(p_records.slots));
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
	if (p_records.passes[size_t(SlotPass::STRAINS)].tiles() > 0) {
		uploaded += _section_records.upload(_sections.find_numbers(_kind.species ? p_records.species : std::span(&p_records.step, 1)));
	}
	make_room_to_work(count_groups(p_records.passes), uint32_t(count_working_tiles(device_limits())));
	{
		Stopwatch watch(p_measure, Stopwatch::SIMULATE, this);
		dispatch_simulate(p_records);
		uploaded += dispatch_join(p_records.followers, p_records.step);
	}
	_has_kept = _has_moved = true;
	for (const GrassSlot &slot : p_records.slots) {
		_used_rows = std::max(_used_rows, slot.tile.w + 1);
	}
	const double upload_ms = clock.lap();
	_table_changed = _table_changed || std::ranges::any_of(p_records.slots, [](const GrassSlot &p_slot) {
		return (p_slot.list.w & (GRASS_SLOT_RETIRED | GRASS_SLOT_FRESH)) != 0;
	});
	const auto count_own = [&](SlotPass p_pass) { // of tiles whose own pass was ready
		return _simulate[size_t(p_pass)][0].is_ready() ? p_records.passes[size_t(p_pass)].tiles() : 0;
	};
	{
		std::lock_guard lock(_report->mutex);
		BackendStatistics &statistics = _report->statistics;
		statistics.steps++;
		statistics.workgroups += count_groups(p_records.passes);
		statistics.edge_tile_steps += count_own(SlotPass::EDGES);
		statistics.free_tile_steps += count_own(SlotPass::FREE) + p_records.passes[size_t(SlotPass::STRAINS)].tiles();
		statistics.crowd_tile_steps += count_own(SlotPass::CROWD);
		for (const GrassSlot &slot : p_records.slots) {
			statistics.simulated_blades += count_blades(slot);
		}
		statistics.strain_blades += p_records.passes[size_t(SlotPass::STRAINS)].many.blades;
		statistics.uploaded_bytes += uploaded;
		report_memory();
		statistics.upload_ms = p_records.copy_ms + upload_ms;
	}
	read_energy(p_records.number - 1);
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
	if (queue->read_later(_energy.rid(), uint32_t(_used_rows * int64_t(sizeof(vec4))), receive)) {
		_energy_batch = queue->get_batch();
		std::lock_guard lock(_report->mutex);
		_report->statistics.energy_reads++;
	}
}

} // namespace grass
