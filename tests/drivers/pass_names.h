// SPDX-License-Identifier: MIT
// Which of the project's compute passes a shader is. The engine strips names from it and inlines some, so it is known by what it declares.
#pragma once

#include <cstdint>
#include <span>

// Of a compute shader's SPIR-V: `simulate_GRASS_EDGES` is p_folder/shaders_solver_simulate.glsl_GRASS_EDGES.spv. Null: none of the
// folder's. Holds until the program ends. From one thread at a time.
const char *pass_of(const char *p_folder, std::span<const uint32_t> p_code);
