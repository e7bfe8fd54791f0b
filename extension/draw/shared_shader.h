// SPDX-License-Identifier: MIT
// The renderer's shaders, each a single resource for all fields: making one takes up to seconds, and a change of a property that a field is
// built from makes the field again.
#pragma once

#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <functional>

namespace grass {

// Features of a field that a shader is compiled for: each is a define in its code.
enum ShaderFeature {
	SHADER_MAP = 1, // GRASS_MAP
	SHADER_SPECIES = 2, // GRASS_SPECIES
	SHADER_CARDS = 4, // GRASS_CARDS; with SHADER_SPECIES only
	SHADER_PLANTS = 8, // GRASS_PLANTS; with SHADER_SPECIES only
	SHADER_TERRAIN = 16, // GRASS_TERRAIN
	SHADER_LEDGES = 32, // GRASS_LEDGES; with SHADER_MAP only
	SHADER_IMPOSTOR = 64, // GRASS_IMPOSTOR; of plants only
};

// The vertex data of a mesh: none, for blades; position and normal; or these, UV and three numbers.
enum class VertexKind { BLADE, GROUND, PLANT };

// The variant of a field's shaders.
struct Look {
	int features = 0; // ShaderFeature
	godot::String hook; // SurfaceHook::text

	bool operator==(const Look &) const = default;
};

// Sets a uniform of shaders by its name.
using SetUniform = std::function<void(const godot::StringName &p_name, const godot::Variant &p_value)>;

struct ShaderText {
	const char *code; // UTF-8, a string literal
	VertexKind vertices; // of the meshes that it draws
	Look look = {};
};

// Returns the shader. The first call makes it, and it is kept.
godot::Ref<godot::Shader> shared_shader(const ShaderText &p_text);
// Returns the code that the engine compiles.
godot::String make_shader_code(const char *p_code, const Look &p_look);
// Returns whether worker threads make shaders; otherwise shared_shader() makes them when it is called.
bool has_shader_workers();
// Returns whether the shader and everything that drawing with it needs are ready. If not, a worker thread makes
// them, or this call does if the frame has time left.
bool prepare_shader(const ShaderText &p_text);
// Drops shaders with a hook that nothing uses any more: hooks change often, the field's own features do not. Call it when a field gets
// another hook. Shaders prepared for other fields are then made again.
void drop_hooked_shaders();
// Lets no shader be made until the next frame is drawn. Call it before a frame that may need other variants of all shaders than earlier
// frames: the renderer then compiles them for every shader that it knows, and breaks one that another thread is making at that moment
// (Godot 4.6).
void hold_shader_jobs();
// Does the same before the first frame with motion vectors. Call it before each frame that may have them.
void expect_motion_vectors();
// Drops the jobs of prepare_shader() that have not begun. Call it when no field is left, since the game may end now: the engine then waits
// for the jobs' task, and a job that begins so late waits for others that no longer run (Godot 4.6).
void forget_shader_jobs();
// Must be called when the library is unloaded.
void free_shared_shaders();

} // namespace grass
