// SPDX-License-Identifier: MIT
#include "draw/shared_shader.h"

#include <map>

using namespace godot;

namespace grass {

namespace {
std::map<const char *, Ref<Shader>> shaders; // by the address of their code
} // namespace

Ref<Shader> shared_shader(const char *p_code) {
	Ref<Shader> &shader = shaders[p_code];
	if (shader.is_null()) {
		shader.instantiate();
		shader->set_code(String::utf8(p_code));
	}
	return shader;
}

void free_shared_shaders() {
	shaders.clear();
}

} // namespace grass
