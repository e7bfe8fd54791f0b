// SPDX-License-Identifier: MIT
// The materials of blades, and of the meshes that cast their shadows: one for each number of segments (the `segments` uniform).
#pragma once

#include "core/base/layout.h"
#include "draw/shared_shader.h"

#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include <array>
#include <vector>

namespace grass {

class BladeMaterials {
public:
	BladeMaterials(); // without shaders, until set_look()

	// Return the shaders of the blades with p_look, and of their shadows.
	static ShaderText blade_text(const Look &p_look);
	static ShaderText shadow_text(const Look &p_look);
	void set_look(const Look &p_look);
	const godot::Ref<godot::ShaderMaterial> &level(int p_level) const { return _levels[size_t(p_level)]; }
	// Sets a uniform in all materials; a shader ignores a uniform that it does not have.
	void set(const godot::StringName &p_uniform, const godot::Variant &p_value);

private:
	struct Made {
		godot::Ref<godot::ShaderMaterial> material;
		bool is_seen; // otherwise it only casts shadows
	};

	std::vector<Made> _materials;
	std::array<godot::Ref<godot::ShaderMaterial>, GRASS_ALL_LEVELS> _levels; // each is one of _materials
};

} // namespace grass
