// SPDX-License-Identifier: MIT
// The blade shader and its material for each level of detail (they differ in the `segments` uniform only).
#pragma once

#include "core/layout.h"

#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include <array>

namespace grass {

class BladeMaterials {
public:
	// p_mapped: for fields with a map.
	explicit BladeMaterials(bool p_mapped);

	const godot::Ref<godot::ShaderMaterial> &level(int p_level) const { return _levels[size_t(p_level)]; }
	// Sets a uniform of the blade shader in all levels.
	void set(const godot::StringName &p_uniform, const godot::Variant &p_value);

private:
	std::array<godot::Ref<godot::ShaderMaterial>, GRASS_LOD_LEVELS> _levels;
};

} // namespace grass
