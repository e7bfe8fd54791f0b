// SPDX-License-Identifier: MIT
// The renderer's shaders, one resource each for all fields: compiling one takes up to seconds, and fields are made anew
// whenever a property changes that they are built from.
#pragma once

#include <godot_cpp/classes/shader.hpp>

namespace grass {

// What a field has that a shader must know of: each is a define in its code.
enum ShaderFeature {
	SHADER_MAP = 1, // GRASS_MAP
	SHADER_SPECIES = 2, // GRASS_SPECIES
	SHADER_CARDS = 4, // GRASS_CARDS; with SHADER_SPECIES only
};

// The shader of p_code (UTF-8, a string literal) with p_features, made when it is first asked for and kept.
godot::Ref<godot::Shader> shared_shader(const char *p_code, int p_features = 0);
// Makes it if it is not there and this frame has time for it; the engine takes some 20 ms. Whether it was there.
bool prepare_shader(const char *p_code, int p_features = 0);
// For when the library is unloaded.
void free_shared_shaders();

} // namespace grass
