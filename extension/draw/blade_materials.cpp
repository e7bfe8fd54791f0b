// SPDX-License-Identifier: MIT
#include "draw/blade_materials.h"

#include "render_shaders.gen.h"

using namespace godot;

namespace grass {

BladeMaterials::BladeMaterials() {
	_picture.instantiate();
	_shadows.instantiate();
}

ShaderText BladeMaterials::blade_text(const Look &p_look) {
	return { shader::BLADE_GDSHADER, VertexKind::BLADE, p_look };
}

ShaderText BladeMaterials::shadow_text(const Look &p_look) { // cards cast no shadow, and hooks do not show in shadows
	return { shader::SHADOW_GDSHADER, VertexKind::BLADE, { p_look.features & ~(SHADER_CARDS | SHADER_TERRAIN), String() } };
}

void BladeMaterials::set_look(const Look &p_look) {
	_picture->set_shader(shared_shader(blade_text(p_look)));
	_shadows->set_shader(shared_shader(shadow_text(p_look)));
}

void BladeMaterials::set(const StringName &p_uniform, const Variant &p_value) {
	_picture->set_shader_parameter(p_uniform, p_value);
	_shadows->set_shader_parameter(p_uniform, p_value);
}

} // namespace grass
