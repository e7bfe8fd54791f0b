// SPDX-License-Identifier: MIT
// A Vulkan layer that makes a device behave as drivers do on which the tests cannot run. tools/test/drivers.py builds it and starts the
// engine under it. It reads the environment:
//   GRASS_LAYER_COUNTING=zero     vertices and instances count from 0 in every draw call, as in Direct3D 12
//   GRASS_LAYER_COUNTING=restored rewritten likewise, but with the number that they have in Vulkan
//   GRASS_LAYER_REFUSED=NAME,...  compute passes that it refuses from now on: the names of their files in the folder below. A name
//                                 with `+crowd` is the pipeline of that pass whose constant GRASS_CONSTANT_TILES is GRASS_TILES_CROWD
//   GRASS_LAYER_ASKED=FILE        gets a line for each pipeline of a compute pass that somebody wants: its name as above
//   GRASS_LAYER_LAZY=all          pipelines are made when a command first binds them
//   GRASS_LAYER_LAZY=drawing      likewise, but those of our passes at once: how long these take is what some tests are about
//   GRASS_LAYER_VENDOR=NUMBER     the device says that it is of this maker
//   GRASS_LAYER_PASSES=FOLDER     of the passes' SPIR-V
//   GRASS_LAYER_SHADERS=FOLDER    gets the vertex and fragment shaders that are made from now on: NUMBER.vertex.spv, NUMBER.fragment.spv
#include "base/constants.inc"
#include "lazy_pipelines.h"
#include "pass_names.h"
#include "vertex_numbers.h"
#include "vulkan_interface.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <mutex>
#include <string>

namespace {

GetInstanceFunction next_of_instance;
GetDeviceFunction next_of_device;
void *last_instance;
void *last_device;
std::mutex mutex;
std::map<uint64_t, std::string> passes; // of ours, by their modules; guarded by `mutex`

std::string environment(const char *p_name) {
	const char *value = std::getenv(p_name);
	return value != nullptr ? value : "";
}

Counting wanted_counting() {
	const std::string counting = environment("GRASS_LAYER_COUNTING");
	return counting.empty() ? Counting::FROM_BASE : counting == "zero" ? Counting::FROM_ZERO : Counting::RESTORED;
}

// Handles of destroyed modules come again.
void remember_pass(uint64_t p_module, std::span<const uint32_t> p_code) {
	std::lock_guard lock(mutex);
	passes.erase(p_module);
	if (const char *pass = pass_of(std::getenv("GRASS_LAYER_PASSES"), p_code)) {
		passes[p_module] = pass;
	}
}

// "vertex" or "fragment"; null: another stage.
const char *drawing_stage(std::span<const uint32_t> p_code) {
	constexpr size_t HEADER = 5;
	for (size_t at = HEADER; at + 1 < p_code.size() && p_code[at] >> 16 != 0; at += p_code[at] >> 16) {
		if ((p_code[at] & 0xffff) == 15) { // OpEntryPoint
			return p_code[at + 1] == 0 ? "vertex" : p_code[at + 1] == 4 ? "fragment" : nullptr;
		}
	}
	return nullptr;
}

void keep_drawing_shader(std::span<const uint32_t> p_code) {
	const std::string folder = environment("GRASS_LAYER_SHADERS");
	const char *stage = folder.empty() ? nullptr : drawing_stage(p_code);
	if (stage != nullptr) {
		uint32_t number = 2166136261u;
		for (const uint32_t word : p_code) {
			number = (number ^ word) * 16777619u;
		}
		std::ofstream file(folder + "/" + std::to_string(number) + "." + stage + ".spv", std::ios::binary);
		file.write(reinterpret_cast<const char *>(p_code.data()), std::streamsize(p_code.size_bytes()));
	}
}

VkResult create_shader_module(void *p_device, const ShaderModuleCreateInfo *p_info, const void *p_allocator, uint64_t *r_module) {
	const auto create = CreateShaderModule(next_of_device(p_device, "vkCreateShaderModule"));
	const std::span<const uint32_t> code(p_info->code, p_info->bytes / sizeof(uint32_t));
	keep_drawing_shader(code);
	const std::vector<uint32_t> counting = count_vertices(code, wanted_counting());
	ShaderModuleCreateInfo info = *p_info;
	if (!counting.empty()) {
		info.code = counting.data();
		info.bytes = counting.size() * sizeof(uint32_t);
	}
	const VkResult result = create(p_device, &info, p_allocator, r_module);
	if (result == VK_SUCCESS) {
		remember_pass(*r_module, code);
	}
	return result;
}

bool is_crowd(const Specialization *p_specialization) {
	for (uint32_t i = 0; p_specialization != nullptr && i < p_specialization->count; i++) {
		const SpecializationEntry &entry = p_specialization->entries[i];
		if (entry.constant == GRASS_CONSTANT_TILES) {
			uint32_t value = 0;
			std::memcpy(&value, static_cast<const char *>(p_specialization->data) + entry.offset, sizeof(value));
			return value == GRASS_TILES_CROWD;
		}
	}
	return false;
}

bool is_refused(const PipelineStage &p_stage) {
	std::lock_guard lock(mutex);
	const auto pass = passes.find(p_stage.module);
	if (pass == passes.end()) {
		return false;
	}
	const std::string name = pass->second + (is_crowd(p_stage.specialization) ? "+crowd" : "");
	if (const std::string asked = environment("GRASS_LAYER_ASKED"); !asked.empty()) {
		std::ofstream(asked, std::ios::app) << name << '\n';
	}
	return ("," + environment("GRASS_LAYER_REFUSED") + ",").find("," + name + ",") != std::string::npos;
}

bool is_lazy() {
	static const bool is = !environment("GRASS_LAYER_LAZY").empty();
	return is;
}

bool may_wait(uint32_t p_count, const ComputePipelineCreateInfo *p_infos) {
	static const bool may_all = environment("GRASS_LAYER_LAZY") == "all";
	std::lock_guard lock(mutex);
	return may_all || std::none_of(p_infos, p_infos + p_count, [](const ComputePipelineCreateInfo &p_info) {
		return passes.contains(p_info.stage.module);
	});
}

VkResult create_compute_pipelines(void *p_device, uint64_t p_cache, uint32_t p_count, const ComputePipelineCreateInfo *p_infos,
		const void *p_allocator, uint64_t *r_pipelines) {
	for (uint32_t i = 0; i < p_count; i++) {
		if (is_refused(p_infos[i].stage)) {
			std::memset(r_pipelines, 0, p_count * sizeof(uint64_t));
			return VK_ERROR_INITIALIZATION_FAILED;
		}
	}
	if (is_lazy() && may_wait(p_count, p_infos) && make_later(p_device, next_of_device, p_count, p_infos, r_pipelines)) {
		return VK_SUCCESS;
	}
	const auto create = CreateComputePipelines(next_of_device(p_device, "vkCreateComputePipelines"));
	return create(p_device, p_cache, p_count, p_infos, p_allocator, r_pipelines);
}

VkResult create_graphics_pipelines(void *p_device, uint64_t p_cache, uint32_t p_count, const GraphicsPipelineCreateInfo *p_infos,
		const void *p_allocator, uint64_t *r_pipelines) {
	if (is_lazy() && make_later(p_device, next_of_device, p_count, p_infos, r_pipelines)) {
		return VK_SUCCESS;
	}
	const auto create = CreateGraphicsPipelines(next_of_device(p_device, "vkCreateGraphicsPipelines"));
	return create(p_device, p_cache, p_count, p_infos, p_allocator, r_pipelines);
}

void bind_pipeline(void *p_commands, int32_t p_kind, uint64_t p_pipeline) {
	static const auto bind = BindPipeline(next_of_device(last_device, "vkCmdBindPipeline"));
	bind(p_commands, p_kind, made(p_pipeline));
}

void destroy_pipeline(void *p_device, uint64_t p_pipeline, const void *p_allocator) {
	Destroy(next_of_device(p_device, "vkDestroyPipeline"))(p_device, forget(p_pipeline), p_allocator);
}

// Pipelines that wait need their modules, which the engine thinks to be used.
void destroy_shader_module(void *p_device, uint64_t p_module, const void *p_allocator) {
	if (!is_lazy()) {
		Destroy(next_of_device(p_device, "vkDestroyShaderModule"))(p_device, p_module, p_allocator);
	}
}

// Returns the loader's link to the next layer. It goes on to the one behind that.
const LayerLink *take_link(const Structure *p_chain, int32_t p_type) {
	for (; p_chain != nullptr; p_chain = p_chain->next) {
		auto *info = reinterpret_cast<LayerCreateInfo *>(const_cast<Structure *>(p_chain));
		if (p_chain->type == p_type && info->function == 0) {
			const LayerLink *link = info->link;
			info->link = link->next;
			return link;
		}
	}
	return nullptr;
}

VkResult create_instance(const Structure *p_info, const void *p_allocator, void **r_instance) {
	const LayerLink *link = take_link(p_info->next, STRUCTURE_LAYER_INSTANCE);
	next_of_instance = link->get_instance_function;
	const auto create = CreateInstance(next_of_instance(nullptr, "vkCreateInstance"));
	const VkResult result = create(p_info, p_allocator, r_instance);
	last_instance = result == VK_SUCCESS ? *r_instance : last_instance;
	return result;
}

void get_device_properties(void *p_physical, DeviceProperties *r_properties) {
	const char *name = "vkGetPhysicalDeviceProperties";
	GetDeviceProperties(next_of_instance(last_instance, name))(p_physical, r_properties);
	if (const std::string vendor = environment("GRASS_LAYER_VENDOR"); !vendor.empty()) {
		r_properties->vendor = uint32_t(std::stoul(vendor, nullptr, 0));
	}
}

// Rewritten shaders read the bases of a draw call, which is a feature to be asked for. Returns whether the engine has a structure for it.
bool ask_for_draw_parameters(const Structure *p_chain) {
	bool has_any = false;
	for (; p_chain != nullptr; p_chain = p_chain->next) {
		Structure *at = const_cast<Structure *>(p_chain);
		if (at->type == STRUCTURE_FEATURES_1_1) {
			reinterpret_cast<Features11 *>(at)->has_draw_parameters = 1;
		} else if (at->type == STRUCTURE_FEATURES_DRAW_PARAMETERS) {
			reinterpret_cast<DrawParametersFeatures *>(at)->has_draw_parameters = 1;
		} else {
			continue;
		}
		has_any = true;
	}
	return has_any;
}

VkResult create_device(void *p_physical, const Structure *p_info, const void *p_allocator, void **r_device) {
	const LayerLink *link = take_link(p_info->next, STRUCTURE_LAYER_DEVICE);
	next_of_device = link->get_device_function;
	const auto create = CreateDevice(link->get_instance_function(last_instance, "vkCreateDevice"));
	DrawParametersFeatures features{ { STRUCTURE_FEATURES_DRAW_PARAMETERS, p_info->next }, 1 };
	if (wanted_counting() != Counting::FROM_BASE && !ask_for_draw_parameters(p_info->next)) {
		const_cast<Structure *>(p_info)->next = &features.head;
	}
	const VkResult result = create(p_physical, p_info, p_allocator, r_device);
	last_device = result == VK_SUCCESS ? *r_device : last_device;
	const_cast<Structure *>(p_info)->next = p_info->next == &features.head ? features.head.next : p_info->next;
	return result;
}

Function get_device_function(void *p_device, const char *p_name);
Function get_instance_function(void *p_instance, const char *p_name);

Function own_function(const std::string &p_name) {
	static const std::map<std::string, Function> own{
		{ "vkCreateInstance", Function(create_instance) },
		{ "vkCreateDevice", Function(create_device) },
		{ "vkGetPhysicalDeviceProperties", Function(get_device_properties) },
		{ "vkCreateShaderModule", Function(create_shader_module) },
		{ "vkCreateComputePipelines", Function(create_compute_pipelines) },
		{ "vkCreateGraphicsPipelines", Function(create_graphics_pipelines) },
		{ "vkCmdBindPipeline", Function(bind_pipeline) },
		{ "vkDestroyPipeline", Function(destroy_pipeline) },
		{ "vkDestroyShaderModule", Function(destroy_shader_module) },
		{ "vkGetInstanceProcAddr", Function(get_instance_function) },
		{ "vkGetDeviceProcAddr", Function(get_device_function) },
	};
	const auto found = own.find(p_name);
	return found != own.end() ? found->second : nullptr;
}

Function get_device_function(void *p_device, const char *p_name) {
	const Function own = own_function(p_name);
	return own != nullptr ? own : next_of_device(p_device, p_name);
}

Function get_instance_function(void *p_instance, const char *p_name) {
	const Function own = own_function(p_name);
	return own != nullptr ? own : next_of_instance(p_instance, p_name);
}

} // namespace

// What the loader asks first.
extern "C" __attribute__((visibility("default"))) VkResult vkNegotiateLoaderLayerInterfaceVersion(LayerNegotiation *r_layer) {
	r_layer->get_instance_function = get_instance_function;
	r_layer->get_device_function = get_device_function;
	r_layer->get_physical_device_function = nullptr;
	return VK_SUCCESS;
}
