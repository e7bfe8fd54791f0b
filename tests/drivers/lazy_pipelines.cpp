// SPDX-License-Identifier: MIT
#include "lazy_pipelines.h"

#include <cstring>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace {

// Keeps copies of what a structure points to, as long as the pipeline waits.
class Copies {
	std::vector<std::unique_ptr<char[]>> _parts;

public:
	template <class T> void keep(const T *&r_array, size_t p_count = 1) {
		if (r_array != nullptr) {
			const size_t bytes = p_count * sizeof(T);
			_parts.push_back(std::make_unique<char[]>(bytes));
			std::memcpy(_parts.back().get(), r_array, bytes);
			r_array = reinterpret_cast<const T *>(_parts.back().get());
		}
	}

	void keep_stage(PipelineStage &r_stage) {
		keep(r_stage.name, std::strlen(r_stage.name) + 1);
		keep(r_stage.specialization);
		if (r_stage.specialization != nullptr) {
			auto &specialization = const_cast<Specialization &>(*r_stage.specialization);
			auto *data = static_cast<const char *>(specialization.data);
			keep(specialization.entries, specialization.count);
			keep(data, specialization.bytes);
			specialization.data = data;
		}
	}

	// Returns whether all of the state is copied: no structure is behind it.
	template <class T> bool keep_state(const T *&r_state) {
		keep(r_state);
		return r_state == nullptr || r_state->head.next == nullptr;
	}
};

struct Waiting {
	void *device;
	GetDeviceFunction next;
	bool is_compute = false;
	GraphicsPipelineCreateInfo graphics;
	ComputePipelineCreateInfo compute;
	Copies copies;
	std::once_flag once;
	uint64_t made = 0;

	bool copy(const GraphicsPipelineCreateInfo &p_info) {
		graphics = p_info;
		GraphicsPipelineCreateInfo &info = graphics;
		info.base = 0;
		copies.keep(info.stages, info.stage_count);
		bool is_whole = info.head.next == nullptr;
		for (uint32_t i = 0; i < info.stage_count; i++) {
			auto &stage = const_cast<PipelineStage &>(info.stages[i]);
			is_whole &= stage.head.next == nullptr;
			copies.keep_stage(stage);
		}
		is_whole &= copies.keep_state(info.vertex_input) & copies.keep_state(info.input_assembly) & copies.keep_state(info.tessellation) &
				copies.keep_state(info.viewport) & copies.keep_state(info.rasterization) & copies.keep_state(info.multisample) &
				copies.keep_state(info.depth_stencil) & copies.keep_state(info.color_blend) & copies.keep_state(info.dynamic);
		if (auto *input = const_cast<VertexInputState *>(info.vertex_input)) {
			copies.keep(input->bindings, input->binding_count);
			copies.keep(input->attributes, input->attribute_count);
		}
		if (auto *viewport = const_cast<ViewportState *>(info.viewport)) {
			copies.keep(viewport->viewports, viewport->viewport_count);
			copies.keep(viewport->scissors, viewport->scissor_count);
		}
		if (auto *multisample = const_cast<MultisampleState *>(info.multisample)) {
			copies.keep(multisample->mask, multisample->samples / 32 + 1);
		}
		if (auto *blend = const_cast<ColorBlendState *>(info.color_blend)) {
			copies.keep(blend->attachments, blend->attachment_count);
		}
		if (auto *dynamic = const_cast<DynamicState *>(info.dynamic)) {
			copies.keep(dynamic->states, dynamic->count);
		}
		return is_whole;
	}

	bool copy(const ComputePipelineCreateInfo &p_info) {
		is_compute = true;
		compute = p_info;
		compute.base = 0;
		copies.keep_stage(compute.stage);
		return compute.head.next == nullptr && compute.stage.head.next == nullptr;
	}

	void make() {
		if (is_compute) {
			CreateComputePipelines(next(device, "vkCreateComputePipelines"))(device, 0, 1, &compute, nullptr, &made);
		} else {
			CreateGraphicsPipelines(next(device, "vkCreateGraphicsPipelines"))(device, 0, 1, &graphics, nullptr, &made);
		}
	}
};

std::mutex mutex;
std::map<uint64_t, std::shared_ptr<Waiting>> pipelines; // by their handles, which are addresses; guarded by `mutex`

template <class T>
bool make_all_later(void *p_device, GetDeviceFunction p_next, uint32_t p_count, const T *p_infos, uint64_t *r_pipelines) {
	std::vector<std::shared_ptr<Waiting>> all;
	for (uint32_t i = 0; i < p_count; i++) {
		all.push_back(std::make_shared<Waiting>());
		all.back()->device = p_device;
		all.back()->next = p_next;
		if (!all.back()->copy(p_infos[i])) {
			return false;
		}
	}
	std::lock_guard lock(mutex);
	for (uint32_t i = 0; i < p_count; i++) {
		r_pipelines[i] = uint64_t(all[i].get());
		pipelines[r_pipelines[i]] = all[i];
	}
	return true;
}

std::shared_ptr<Waiting> find(uint64_t p_pipeline) {
	std::lock_guard lock(mutex);
	const auto found = pipelines.find(p_pipeline);
	return found != pipelines.end() ? found->second : nullptr;
}

} // namespace

bool make_later(
		void *p_device, GetDeviceFunction p_next, uint32_t p_count, const GraphicsPipelineCreateInfo *p_infos, uint64_t *r_pipelines) {
	return make_all_later(p_device, p_next, p_count, p_infos, r_pipelines);
}

bool make_later(
		void *p_device, GetDeviceFunction p_next, uint32_t p_count, const ComputePipelineCreateInfo *p_infos, uint64_t *r_pipelines) {
	return make_all_later(p_device, p_next, p_count, p_infos, r_pipelines);
}

uint64_t made(uint64_t p_pipeline) {
	const std::shared_ptr<Waiting> waiting = find(p_pipeline);
	if (!waiting) {
		return p_pipeline;
	}
	std::call_once(waiting->once, [&waiting] { waiting->make(); });
	return waiting->made;
}

uint64_t forget(uint64_t p_pipeline) {
	const std::shared_ptr<Waiting> waiting = find(p_pipeline);
	if (!waiting) {
		return p_pipeline;
	}
	std::lock_guard lock(mutex);
	pipelines.erase(p_pipeline);
	return waiting->made;
}
