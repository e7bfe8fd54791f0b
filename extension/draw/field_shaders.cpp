// SPDX-License-Identifier: MIT
#include "draw/field_shaders.h"

#include "draw/blade_materials.h"
#include "draw/ground.h"
#include "draw/plants.h"

#include <algorithm>
#include <vector>

namespace grass {

namespace {

// Returns all of the look's shaders that a hook changes.
std::vector<ShaderText> hooked_texts(const Look &p_look) {
	std::vector<ShaderText> texts{ BladeMaterials::blade_text(p_look), Ground::text(p_look) };
	if (p_look.features & SHADER_PLANTS) {
		texts.push_back(Plants::text(p_look, GRASS_PLANT_MESH));
		texts.push_back(Plants::text(p_look, GRASS_PLANT_IMPOSTOR));
	}
	return texts;
}

} // namespace

bool prepare_shaders(const Look &p_look) {
	bool are_ready = prepare_shader(BladeMaterials::shadow_text(p_look));
	for (const ShaderText &text : hooked_texts(p_look)) {
		are_ready = prepare_shader(text) && are_ready; // threads take all of them
	}
	return are_ready;
}

bool are_compiled(const Look &p_look) {
	return p_look.hook.is_empty() || std::ranges::all_of(hooked_texts(p_look), [](const ShaderText &p_text) {
		return !shared_shader(p_text)->get_shader_uniform_list().is_empty(); // the engine lists no uniforms of a shader with an error
	});
}

} // namespace grass
