// SPDX-License-Identifier: MIT
#include "gpu/step_passes.h"

#include "core/field/device_fit.h"
#include "gpu/obstacles.h"

#include <algorithm>
#include <bit>

using namespace godot;

namespace grass {

namespace {

// Returns the most workgroups that the shared buffer has room for; 0: threads need none.
uint32_t count_working() {
	return uint32_t(count_working_tiles(device_limits()));
}

} // namespace

void StepPasses::create(const PassKind &p_kind) {
	free();
	_kind = p_kind;
	for (const SlotPass pass : { SlotPass::PLAIN, SlotPass::FREE, SlotPass::EDGES }) {
		own(pass).create(simulate_code(_kind, pass), GpuPass::Compile::LATER);
	}
	if (_kind.method == Method::DIRECT) {
		own(SlotPass::STRAINS, true).create(simulate_code(_kind, SlotPass::STRAINS, true), GpuPass::Compile::LATER);
	}
}

void StepPasses::free() {
	for (auto &passes : _passes) {
		for (GpuPass &pass : passes) {
			pass.free();
		}
	}
}

void StepPasses::bind() {
	for (auto &passes : _passes) {
		std::ranges::for_each(passes, _bind);
	}
}

int64_t StepPasses::count_tiles(const StepRecords &p_records, SlotPass p_pass) {
	return own(p_pass).is_ready() ? p_records.passes[size_t(p_pass)].tiles() : 0;
}

// The GPU runs steps of two fields one after the other, since both write this buffer. Where it has no room, each field has one of its own:
// steps of a few tiles take long, and would wait for each other.
void StepPasses::make_room(const StepRecords &p_records) {
	const uint32_t most = count_working();
	if (most == 0) {
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
	const int64_t bytes = int64_t(std::min(std::bit_ceil(p_records.count_groups()), most)) * WORK_BYTES;
	if (!_work->rid().is_valid() || bytes > _work->size()) {
		_work->allocate(bytes);
	}
}

GpuPass &StepPasses::find(SlotPass p_pass, bool p_many) {
	GpuPass &pass = own(p_pass, p_many);
	if (!pass.is_created()) {
		pass.create(simulate_code(_kind, p_pass, p_many), GpuPass::Compile::LATER);
		_bind(pass);
	}
	if (p_pass == SlotPass::CROWD && !pass.is_ready()) {
		return find(SlotPass::EDGES, p_many);
	}
	return pass.is_ready() ? pass : own(SlotPass::PLAIN);
}

// Dispatches the passes of a step. Those that take longest begin first, so that little is left to do when the last one ends.
void StepPasses::dispatch(const StepRecords &p_records, const Uploaded &p_uploaded) {
	struct Work {
		SlotGroups groups;
		GpuPass *pass;
	};
	std::vector<Work> works;
	for (int pass = 0; pass < SLOT_PASSES; pass++) {
		const PassGroups &groups = p_records.passes[size_t(pass)];
		for (const bool many : { false, true }) {
			if (const SlotGroups &some = many ? groups.many : groups.single; some.count > 0) {
				works.push_back({ some, &find(SlotPass(pass), many) });
			}
		}
	}
	for (const Work &work : works) {
		work.pass->bind_buffer(GRASS_BINDING_SLOTS, p_uploaded.slots);
		work.pass->bind_buffer(GRASS_BINDING_FORCES, p_uploaded.forces);
		if (work.pass == &own(SlotPass::STRAINS, true)) {
			work.pass->bind_buffer(GRASS_BINDING_SECTIONS, p_uploaded.sections);
			continue;
		}
		work.pass->bind_buffer(GRASS_BINDING_WORK, _work->rid());
		work.pass->bind_buffer(GRASS_BINDING_COLLIDERS, p_uploaded.colliders);
		work.pass->bind_buffer(GRASS_BINDING_COLLIDER_LIST, p_uploaded.collider_list);
		work.pass->bind_buffer(GRASS_BINDING_PLANES, p_uploaded.planes);
	}
	const uint32_t groups = p_records.count_groups(), most = count_working() > 0 ? count_working() : groups; // at once
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

} // namespace grass
