// SPDX-License-Identifier: MIT
#include "draw/blade_materials.h"

#include "draw/blade_mesh.h"
#include "draw/shared_shader.h"
#include "render_shaders.gen.h"

using namespace godot;

namespace grass {

BladeMaterials::BladeMaterials(int p_features) {
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const bool first = level == 0 || level == GRASS_LOD_LEVELS;
		if (first || lod_segments(level) != lod_segments(level - 1)) {
			Ref<ShaderMaterial> material;
			material.instantiate();
			const bool is_seen = level < GRASS_LOD_LEVELS; // cards throw no shadow
			material->set_shader(is_seen ? shared_shader(shader::BLADE_GDSHADER, p_features)
										 : shared_shader(shader::SHADOW_GDSHADER, p_features & ~SHADER_CARDS));
			material->set_shader_parameter("segments", lod_segments(level));
			_materials.push_back(material);
		}
		_levels[size_t(level)] = _materials.back();
	}
}

void BladeMaterials::set(const StringName &p_uniform, const Variant &p_value) {
	for (Ref<ShaderMaterial> &material : _materials) {
		material->set_shader_parameter(p_uniform, p_value);
	}
}

} // namespace grass
