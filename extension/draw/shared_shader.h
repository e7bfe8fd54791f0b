// SPDX-License-Identifier: MIT
// The renderer's shaders, one resource each for all fields: compiling one takes up to seconds, and fields are made anew
// whenever a property changes that they are built from.
#pragma once

#include <godot_cpp/classes/shader.hpp>

namespace grass {

// The shader of p_code (UTF-8, a string literal), made when it is first asked for and kept. p_mapped: with GRASS_MAP
// defined, for fields with a map.
godot::Ref<godot::Shader> shared_shader(const char *p_code, bool p_mapped = false);
// For when the library is unloaded.
void free_shared_shaders();

} // namespace grass
