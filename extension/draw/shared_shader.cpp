// SPDX-License-Identifier: MIT
#include "draw/shared_shader.h"

#include "draw/frame_share.h"

#include <map>
#include <string>
#include <tuple>

using namespace godot;

namespace grass {

namespace {
using Key = std::tuple<const char *, int, std::string>; // address of the code, features, hook
std::map<Key, Ref<Shader>> shaders;

// Hooks come and go, as nobody's own shaders do.
void drop_unused() {
	std::erase_if(
			shaders, [](const auto &p_entry) { return !std::get<2>(p_entry.first).empty() && p_entry.second->get_reference_count() == 1; });
}
} // namespace

String make_shader_code(const char *p_code, int p_features, const String &p_hook) {
	String head = "shader_type spatial;";
	head += p_features & SHADER_MAP ? "\n#define GRASS_MAP" : "";
	head += p_features & SHADER_SPECIES ? "\n#define GRASS_SPECIES" : "";
	head += p_features & SHADER_CARDS ? "\n#define GRASS_CARDS" : "";
	head += p_features & SHADER_PLANTS ? "\n#define GRASS_PLANTS" : "";
	head += p_features & SHADER_TERRAIN ? "\n#define GRASS_TERRAIN" : "";
	head += p_hook.is_empty() ? "" : "\n#define GRASS_HOOK";
	const String code = String::utf8(p_code).replace("shader_type spatial;", head);
	return p_hook.is_empty() ? code : code.replace("GRASS_HOOK_TEXT", p_hook);
}

Ref<Shader> shared_shader(const char *p_code, int p_features, const String &p_hook) {
	const Key key{ p_code, p_features, p_hook.utf8().get_data() };
	if (!p_hook.is_empty() && !shaders.contains(key)) {
		drop_unused();
	}
	Ref<Shader> &shader = shaders[key];
	if (shader.is_null()) {
		shader.instantiate();
		shader->set_code(make_shader_code(p_code, p_features, p_hook));
	}
	return shader;
}

bool prepare_shader(const char *p_code, int p_features) {
	if (shaders.contains({ p_code, p_features, "" })) {
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
