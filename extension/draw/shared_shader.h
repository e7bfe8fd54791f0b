// SPDX-License-Identifier: MIT
// The renderer's shaders, one resource each for all fields: making one takes up to seconds, and a change of a property
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
	SHADER_LEDGES = 32, // GRASS_LEDGES; with SHADER_MAP only
};

// What the vertices of a mesh hold: nothing, for blades; place and normal; these, UV and three numbers.
enum class VertexKind { BLADE, GROUND, PLANT };

// What a field's shaders are compiled for.
struct Look {
	int features = 0; // ShaderFeature
	godot::String hook; // SurfaceHook::text

	bool operator==(const Look &) const = default;
};

struct ShaderText {
	const char *code; // UTF-8, a string literal
	VertexKind vertices; // of the meshes that it draws
	Look look = {};
};

// The shader, made by the first call and kept.
godot::Ref<godot::Shader> shared_shader(const ShaderText &p_text);
// What the engine compiles.
godot::String make_shader_code(const char *p_code, const Look &p_look);
// Whether worker threads make shaders; else shared_shader() does, when it is called.
bool has_shader_workers();
// Returns whether the shader and everything that drawing with it needs are ready. If not, a worker thread makes
// them, or this call does if the frame has time left.
bool prepare_shader(const ShaderText &p_text);
// Drops shaders with a hook that nothing is drawn with: hooks come and go, as the field's own features do not. Call when a field has
// another one: what is prepared for others is made once more.
void drop_hooked_shaders();
// No shader is made until the next frame is drawn. Call before a frame that may need other variants of all shaders than those before it:
// the renderer then compiles them for every shader that it knows, and breaks one that another thread makes at that moment (Godot 4.6).
void hold_shader_jobs();
// The same for the first frame that has motion vectors. Call before each that may have them.
void expect_motion_vectors();
// Forgets what has not begun of what prepare_shader() began. Call when no field is left, since the game may end now: the engine waits for
// the jobs' task then, and a job that begins so late waits for others that no longer run (Godot 4.6).
void forget_shader_jobs();
// Call when the library is unloaded.
void free_shared_shaders();

} // namespace grass
