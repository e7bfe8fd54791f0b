// SPDX-License-Identifier: MIT
// The renderer's shaders, one resource each for all fields: compiling one takes up to seconds, and a change of a property
// that a field is built from makes the field anew.
#pragma once

#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/variant/string.hpp>

namespace grass {

// Features of a field that a shader is compiled for: each is a define in its code.
enum ShaderFeature {
	SHADER_MAP = 1, // GRASS_MAP
	SHADER_SPECIES = 2, // GRASS_SPECIES
	SHADER_CARDS = 4, // GRASS_CARDS; with SHADER_SPECIES only
	SHADER_PLANTS = 8, // GRASS_PLANTS; likewise
	SHADER_TERRAIN = 16, // GRASS_TERRAIN
};

// The shader of p_code (UTF-8, a string literal) with p_features, made by the first call and kept. p_hook: SurfaceHook::text.
godot::Ref<godot::Shader> shared_shader(const char *p_code, int p_features = 0, const godot::String &p_hook = godot::String());
// Its text.
godot::String make_shader_code(const char *p_code, int p_features, const godot::String &p_hook);
// Makes it if it does not exist and this frame has time: some 20 ms in the engine. Returns whether it existed before.
bool prepare_shader(const char *p_code, int p_features = 0);
// Call when the library is unloaded.
void free_shared_shaders();

} // namespace grass
