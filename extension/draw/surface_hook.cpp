// SPDX-License-Identifier: MIT
#include "draw/surface_hook.h"

#include "draw/shared_shader.h"
#include "render_shaders.gen.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/dictionary.hpp>

using namespace godot;

namespace grass {

namespace {

// Returns whether a uniform belongs to our shader rather than to the include.
bool is_own(const StringName &p_name) {
	return p_name == StringName("wetness") || p_name == StringName("snow") || p_name == StringName("other_light") ||
			p_name == StringName("grass_probe");
}

// Includes a file by its path, so that errors name the file and its own includes are found relative to it.
String text_of(const Ref<ShaderInclude> &p_include) {
	const String path = p_include->get_path();
	const bool is_file = !path.is_empty() && !path.contains("::");
	return is_file ? "#include \"" + path + "\"" : p_include->get_code();
}

} // namespace

const SurfaceHook::Uniform *SurfaceHook::find(const StringName &p_name) const {
	for (const Uniform &uniform : uniforms) {
		if (uniform.info.name == p_name) {
			return &uniform;
		}
	}
	return nullptr;
}

SurfaceHook compile_hook(const Ref<ShaderInclude> &p_include) {
	SurfaceHook hook;
	if (p_include.is_null() || p_include->get_code().strip_edges().is_empty()) {
		return hook;
	}
	const String text = text_of(p_include);
	Ref<Shader> probe;
	probe.instantiate();
	probe->set_code(make_shader_code(shader::SURFACE_PROBE_GDSHADER, { 0, text }));
	const Array uniforms = probe->get_shader_uniform_list();
	for (int64_t i = 0; i < uniforms.size(); i++) {
		const Dictionary found = uniforms[i];
		const StringName name = found.get("name", StringName());
		if (!is_own(name)) {
			const PropertyInfo info(Variant::Type(int64_t(found.get("type", 0))), name, PropertyHint(int64_t(found.get("hint", 0))),
					found.get("hint_string", String()));
			hook.uniforms.push_back({ info, RenderingServer::get_singleton()->shader_get_parameter_default(probe->get_rid(), name) });
		}
	}
	hook.text = uniforms.is_empty() ? String() : text;
	return hook;
}

} // namespace grass
