// SPDX-License-Identifier: MIT
// The materials of blades and of what casts their shadows: one for each number of segments (the `segments` uniform).
#pragma once

#include "core/base/layout.h"

#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/string_name.hpp>

#include <array>
#include <vector>

namespace grass {

class BladeMaterials {
public:
	explicit BladeMaterials(int p_features); // ShaderFeature

	// Makes one missing shader of the materials with p_features. Returns whether none was missing.
	static bool prepare(int p_features);
	void set_features(int p_features);
	// SurfaceHook::text of what is seen; "": none. False if the shaders do not compile with it.
	bool set_hook(const godot::String &p_text);
	const godot::Ref<godot::ShaderMaterial> &level(int p_level) const { return _levels[size_t(p_level)]; }
	// Sets a uniform in all of them; a shader ignores what it has not.
	void set(const godot::StringName &p_uniform, const godot::Variant &p_value);

private:
	void set_shaders();

	struct Made {
		godot::Ref<godot::ShaderMaterial> material;
		bool is_seen; // else it only casts shadows
	};

	std::vector<Made> _materials;
	int _features = -1; // none yet
	godot::String _hook;
	std::array<godot::Ref<godot::ShaderMaterial>, GRASS_ALL_LEVELS> _levels; // each one of _materials
};

} // namespace grass
