// SPDX-License-Identifier: MIT
#include "draw/blade_materials.h"

#include "draw/blade_mesh.h"
#include "draw/shared_shader.h"
#include "draw/surface_hook.h"
#include "render_shaders.gen.h"

using namespace godot;

namespace grass {

BladeMaterials::BladeMaterials(int p_features) {
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
	set_features(p_features);
}

namespace {
int shadow_features(int p_features) {
	return p_features & ~(SHADER_CARDS | SHADER_TERRAIN); // cards throw no shadow
}
} // namespace

bool BladeMaterials::prepare(int p_features) {
	return prepare_shader(shader::BLADE_GDSHADER, p_features) && prepare_shader(shader::SHADOW_GDSHADER, shadow_features(p_features));
}

void BladeMaterials::set_features(int p_features) {
	if (_features == p_features) {
		return;
	}
	_features = p_features;
	set_shaders();
}

bool BladeMaterials::set_hook(const String &p_text) {
	if (_hook != p_text) {
		_hook = p_text;
		set_shaders();
	}
	return is_compiled(shared_shader(shader::BLADE_GDSHADER, _features, _hook), _hook);
}

void BladeMaterials::set_shaders() {
	for (const Made &made : _materials) {
		made.material->set_shader(made.is_seen ? shared_shader(shader::BLADE_GDSHADER, _features, _hook)
											   : shared_shader(shader::SHADOW_GDSHADER, shadow_features(_features)));
	}
}

void BladeMaterials::set(const StringName &p_uniform, const Variant &p_value) {
	for (const Made &made : _materials) {
		made.material->set_shader_parameter(p_uniform, p_value);
	}
}

} // namespace grass
