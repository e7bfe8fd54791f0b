// SPDX-License-Identifier: MIT
// Pipelines that are made when a command first binds them. The engine makes many in advance, of which a test draws with few. Software
// Vulkan keeps machine code for the next start of the engine, but not what it makes of SPIR-V before, which takes as long.
#pragma once

#include "vulkan_interface.h"

// Creates pipelines for later. False: one of them needs what a copy would lose; nothing was created.
bool make_later(
		void *p_device, GetDeviceFunction p_next, uint32_t p_count, const GraphicsPipelineCreateInfo *p_infos, uint64_t *r_pipelines);
bool make_later(
		void *p_device, GetDeviceFunction p_next, uint32_t p_count, const ComputePipelineCreateInfo *p_infos, uint64_t *r_pipelines);

// Returns the driver's pipeline for a handle, which is made now if it waited. A handle that the driver gave is returned as it is.
uint64_t made(uint64_t p_pipeline);
// Forgets a handle. The driver's pipeline, which the caller destroys; 0: it was never made.
uint64_t forget(uint64_t p_pipeline);
