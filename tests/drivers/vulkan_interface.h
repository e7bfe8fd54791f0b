// SPDX-License-Identifier: MIT
// What the layer reads of Vulkan's interface, laid out as its specification says: the machine needs no headers of Vulkan.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

enum VkResult : int32_t { VK_SUCCESS = 0, VK_ERROR_INITIALIZATION_FAILED = -3 };

// Of what `next` chains.
enum : int32_t {
	STRUCTURE_LAYER_INSTANCE = 47,
	STRUCTURE_LAYER_DEVICE = 48,
	STRUCTURE_FEATURES_1_1 = 49,
	STRUCTURE_FEATURES_DRAW_PARAMETERS = 1000063000,
};

using Function = void (*)(void);
using GetInstanceFunction = Function (*)(void *p_instance, const char *p_name);
using GetDeviceFunction = Function (*)(void *p_device, const char *p_name);

// How every structure begins.
struct Structure {
	int32_t type;
	const Structure *next;
};

// The loader's: who is next in the chain of layers.
struct LayerLink {
	LayerLink *next;
	GetInstanceFunction get_instance_function;
	union {
		GetInstanceFunction get_physical_device_function; // of instances
		GetDeviceFunction get_device_function; // of devices
	};
};

struct LayerCreateInfo {
	Structure head;
	int32_t function; // 0: `link` is meant
	LayerLink *link;
};

struct LayerNegotiation {
	int32_t type;
	void *next;
	uint32_t version;
	GetInstanceFunction get_instance_function;
	GetDeviceFunction get_device_function;
	GetInstanceFunction get_physical_device_function;
};

struct Features11 {
	Structure head;
	uint32_t others[11];
	uint32_t has_draw_parameters;
};

struct DrawParametersFeatures {
	Structure head;
	uint32_t has_draw_parameters;
};

struct DeviceProperties { // more follows
	uint32_t api_version, driver_version, vendor;
};

struct ShaderModuleCreateInfo {
	Structure head;
	uint32_t flags;
	size_t bytes;
	const uint32_t *code;
};

struct SpecializationEntry {
	uint32_t constant, offset;
	size_t bytes;
};

struct Specialization {
	uint32_t count;
	const SpecializationEntry *entries;
	size_t bytes;
	const void *data;
};

struct PipelineStage {
	Structure head;
	uint32_t flags, stage;
	uint64_t module;
	const char *name;
	const Specialization *specialization;
};

struct ComputePipelineCreateInfo {
	Structure head;
	uint32_t flags;
	PipelineStage stage;
	uint64_t layout, base;
	int32_t base_index;
};

struct VertexInputState {
	Structure head;
	uint32_t flags, binding_count;
	const std::array<uint32_t, 3> *bindings;
	uint32_t attribute_count;
	const std::array<uint32_t, 4> *attributes;
};

struct InputAssemblyState {
	Structure head;
	uint32_t others[3];
};

struct TessellationState {
	Structure head;
	uint32_t others[2];
};

struct ViewportState {
	Structure head;
	uint32_t flags, viewport_count;
	const std::array<float, 6> *viewports;
	uint32_t scissor_count;
	const std::array<int32_t, 4> *scissors;
};

struct RasterizationState {
	Structure head;
	uint32_t others[11];
};

struct MultisampleState {
	Structure head;
	uint32_t flags, samples, others[2];
	const uint32_t *mask; // a word for 32 samples
	uint32_t alpha[2];
};

struct DepthStencilState {
	Structure head;
	uint32_t others[22];
};

struct ColorBlendState {
	Structure head;
	uint32_t flags, logic[2], attachment_count;
	const std::array<uint32_t, 8> *attachments;
	float constants[4];
};

struct DynamicState {
	Structure head;
	uint32_t flags, count;
	const uint32_t *states;
};

struct GraphicsPipelineCreateInfo {
	Structure head;
	uint32_t flags, stage_count;
	const PipelineStage *stages;
	const VertexInputState *vertex_input;
	const InputAssemblyState *input_assembly;
	const TessellationState *tessellation;
	const ViewportState *viewport;
	const RasterizationState *rasterization;
	const MultisampleState *multisample;
	const DepthStencilState *depth_stencil;
	const ColorBlendState *color_blend;
	const DynamicState *dynamic;
	uint64_t layout, render_pass;
	uint32_t subpass;
	uint64_t base;
	int32_t base_index;
};

using CreateInstance = VkResult (*)(const Structure *p_info, const void *p_allocator, void **r_instance);
using GetDeviceProperties = void (*)(void *p_physical, DeviceProperties *r_properties);
using CreateDevice = VkResult (*)(void *p_physical, const Structure *p_info, const void *p_allocator, void **r_device);
using CreateShaderModule = VkResult (*)(void *p_device, const ShaderModuleCreateInfo *p_info, const void *p_allocator, uint64_t *r_module);
using CreateComputePipelines = VkResult (*)(void *p_device, uint64_t p_cache, uint32_t p_count, const ComputePipelineCreateInfo *p_infos,
		const void *p_allocator, uint64_t *r_pipelines);
using CreateGraphicsPipelines = VkResult (*)(void *p_device, uint64_t p_cache, uint32_t p_count, const GraphicsPipelineCreateInfo *p_infos,
		const void *p_allocator, uint64_t *r_pipelines);
using BindPipeline = void (*)(void *p_commands, int32_t p_kind, uint64_t p_pipeline);
using Destroy = void (*)(void *p_device, uint64_t p_handle, const void *p_allocator);
