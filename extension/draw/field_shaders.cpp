// SPDX-License-Identifier: MIT
#include "draw/field_shaders.h"

#include "draw/blade_materials.h"
#include "draw/ground.h"
#include "draw/plants.h"

namespace grass {

bool prepare_shaders(const Look &p_look) {
	const bool has_blades = prepare_shader(BladeMaterials::blade_text(p_look)) & prepare_shader(BladeMaterials::shadow_text(p_look));
	bool has_plants = true;
	for (const int stage : { GRASS_PLANT_MESH, GRASS_PLANT_IMPOSTOR }) {
		has_plants = ((p_look.features & SHADER_PLANTS) == 0 || prepare_shader(Plants::text(p_look, stage))) && has_plants;
	}
	return prepare_shader(Ground::text(p_look)) && has_blades && has_plants; // threads take all of them
}

bool are_compiled(const Look &p_look) {
	const auto is_compiled = [](const ShaderText &p_text) {
		return !shared_shader(p_text)->get_shader_uniform_list().is_empty(); // the engine lists no uniforms of a shader with an error
	};
	if (p_look.hook.is_empty()) {
		return true;
	}
	bool are_plants = true;
	for (const int stage : { GRASS_PLANT_MESH, GRASS_PLANT_IMPOSTOR }) {
		are_plants = are_plants && ((p_look.features & SHADER_PLANTS) == 0 || is_compiled(Plants::text(p_look, stage)));
	}
	return are_plants && is_compiled(BladeMaterials::blade_text(p_look)) && is_compiled(Ground::text(p_look));
}

} // namespace grass
