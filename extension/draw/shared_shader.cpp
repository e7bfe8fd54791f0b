// SPDX-License-Identifier: MIT
#include "draw/shared_shader.h"

#include <map>

using namespace godot;

namespace grass {

namespace {
std::map<std::pair<const char *, bool>, Ref<Shader>> shaders; // by the address of their code, and whether for a map
} // namespace

Ref<Shader> shared_shader(const char *p_code, bool p_mapped) {
	Ref<Shader> &shader = shaders[{ p_code, p_mapped }];
	if (shader.is_null()) {
		shader.instantiate();
		const String code = String::utf8(p_code);
		shader->set_code(p_mapped ? code.replace("shader_type spatial;", "shader_type spatial;\n#define GRASS_MAP") : code);
	}
	return shader;
}

void free_shared_shaders() {
	shaders.clear();
}

} // namespace grass
