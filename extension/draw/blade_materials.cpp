// SPDX-License-Identifier: MIT
#include "draw/blade_materials.h"

#include "draw/blade_mesh.h"
#include "render_shaders.gen.h"

#include <godot_cpp/classes/shader.hpp>

using namespace godot;

namespace grass {

BladeMaterials::BladeMaterials() {
	Ref<Shader> shader;
	shader.instantiate();
	shader->set_code(String::utf8(shader::BLADE_GDSHADER));
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
