// SPDX-License-Identifier: MIT
// The materials of a field's blades, and of those that cast its shadows, at all levels of detail.
#pragma once

#include "draw/shared_shader.h"

#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/string_name.hpp>

namespace grass {

class BladeMaterials {
public:
	BladeMaterials(); // without shaders, until set_look()

	// Return the shaders of the blades with p_look, and of their shadows.
	static ShaderText blade_text(const Look &p_look);
	static ShaderText shadow_text(const Look &p_look);
	void set_look(const Look &p_look);
	const godot::Ref<godot::ShaderMaterial> &picture() const { return _picture; }
	const godot::Ref<godot::ShaderMaterial> &shadows() const { return _shadows; }
	// Sets a uniform in both materials; a shader ignores a uniform that it does not have.
	void set(const godot::StringName &p_uniform, const godot::Variant &p_value);

private:
	godot::Ref<godot::ShaderMaterial> _picture, _shadows;
};

} // namespace grass
