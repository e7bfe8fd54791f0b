// SPDX-License-Identifier: MIT
#include "draw/shared_shader.h"

#include "draw/frame_share.h"

#include <map>

using namespace godot;

namespace grass {

namespace {
std::map<std::pair<const char *, int>, Ref<Shader>> shaders; // by the address of their code, and their features
} // namespace

Ref<Shader> shared_shader(const char *p_code, int p_features) {
	Ref<Shader> &shader = shaders[{ p_code, p_features }];
	if (shader.is_null()) {
		shader.instantiate();
		String head = "shader_type spatial;";
		head += p_features & SHADER_MAP ? "\n#define GRASS_MAP" : "";
		head += p_features & SHADER_SPECIES ? "\n#define GRASS_SPECIES" : "";
		head += p_features & SHADER_CARDS ? "\n#define GRASS_CARDS" : "";
		head += p_features & SHADER_PLANTS ? "\n#define GRASS_PLANTS" : "";
		shader->set_code(String::utf8(p_code).replace("shader_type spatial;", head));
	}
	return shader;
}

bool prepare_shader(const char *p_code, int p_features) {
	if (shaders.contains({ p_code, p_features })) {
		return true;
	}
	if (FrameShare::has_time()) {
		shared_shader(p_code, p_features)->get_rid(); // this makes the engine compile it
	}
	return false;
}

void free_shared_shaders() {
	shaders.clear();
}

} // namespace grass
