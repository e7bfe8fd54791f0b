// SPDX-License-Identifier: MIT
#include "draw/blade_materials.h"

#include "draw/blade_mesh.h"
#include "render_shaders.gen.h"

using namespace godot;

namespace grass {

BladeMaterials::BladeMaterials() {
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const bool first = level == 0 || level == GRASS_LOD_LEVELS;
		if (first || lod_segments(level) != lod_segments(level - 1)) {
			Ref<ShaderMaterial> material;
			material.instantiate();
			material->set_shader_parameter("segments", lod_segments(level));
			_materials.push_back({ material, level < GRASS_LOD_LEVELS });
		}
		_levels[size_t(level)] = _materials.back().material;
	}
}

ShaderText BladeMaterials::blade_text(const Look &p_look) {
	return { shader::BLADE_GDSHADER, VertexKind::BLADE, p_look };
}

ShaderText BladeMaterials::shadow_text(const Look &p_look) { // cards cast no shadow, and hooks do not show in shadows
	return { shader::SHADOW_GDSHADER, VertexKind::BLADE, { p_look.features & ~(SHADER_CARDS | SHADER_TERRAIN), String() } };
}

void BladeMaterials::set_look(const Look &p_look) {
	for (const Made &made : _materials) {
		made.material->set_shader(shared_shader(made.is_seen ? blade_text(p_look) : shadow_text(p_look)));
	}
}

void BladeMaterials::set(const StringName &p_uniform, const Variant &p_value) {
	for (const Made &made : _materials) {
		made.material->set_shader_parameter(p_uniform, p_value);
	}
}

} // namespace grass
