// SPDX-License-Identifier: MIT
// A field's `surface_hook`, in the form that its shaders use (shaders/draw/surface.gdshaderinc).
#pragma once

#include <godot_cpp/classes/shader_include.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/variant/string.hpp>

#include <vector>

namespace grass {

struct SurfaceHook {
	// A uniform of the include.
	struct Uniform {
		godot::PropertyInfo info;
		godot::Variant initial; // its default in the include
	};

	godot::String text; // what the shaders include; "": no hook, or it does not compile
	std::vector<Uniform> uniforms;

	const Uniform *find(const godot::StringName &p_name) const;
};

// Compiles the include alone, which takes a few ms. The engine reports errors in it.
SurfaceHook compile_hook(const godot::Ref<godot::ShaderInclude> &p_include);

} // namespace grass
