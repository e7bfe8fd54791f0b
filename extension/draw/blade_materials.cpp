// SPDX-License-Identifier: MIT
#include "draw/blade_materials.h"

#include "draw/blade_mesh.h"
#include "draw/shared_shader.h"
#include "render_shaders.gen.h"

using namespace godot;

namespace grass {

BladeMaterials::BladeMaterials(bool p_mapped) {
	const Ref<Shader> shader = shared_shader(shader::BLADE_GDSHADER, p_mapped);
	for (int level = 0; level < GRASS_LOD_LEVELS; level++) {
		Ref<ShaderMaterial> &material = _levels[size_t(level)];
		material.instantiate();
		material->set_shader(shader);
		material->set_shader_parameter("segments", lod_segments(level));
	}
}

void BladeMaterials::set(const StringName &p_uniform, const Variant &p_value) {
	for (Ref<ShaderMaterial> &material : _levels) {
		material->set_shader_parameter(p_uniform, p_value);
	}
}

} // namespace grass
