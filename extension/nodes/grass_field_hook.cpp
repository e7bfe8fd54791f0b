// SPDX-License-Identifier: MIT
// GrassField's surface hook: setting, compiling and showing it, and setting its uniforms.
#include "nodes/grass_field.h"

#include "shared/main_thread.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

void GrassField::set_surface_hook(const Ref<ShaderInclude> &p_include) {
	GRASS_MAIN_THREAD_ONLY();
	if (get_surface_hook() == p_include) {
		return;
	}
	_properties.hook.set_include(p_include, callable_mp(this, &GrassField::_hook_changed));
	compile_hook();
}

// Deferred until the engine has processed the change, since its own shaders depend on the include too.
void GrassField::_hook_changed() {
	callable_mp(this, &GrassField::compile_hook).call_deferred();
}

void GrassField::compile_hook() {
	stir();
	_properties.hook.compile();
	if (is_inside_tree()) { // else when the field is made
		report_warnings();
	}
	notify_property_list_changed();
}

String GrassField::no_uniform(const char *p_call, const StringName &p_name) const {
	const PackedStringArray uniforms = _properties.hook.get_uniforms();
	return message(vformat("%s: there is no uniform `%s`. %s", p_call, p_name,
			uniforms.is_empty() ? String("Set a `surface_hook` that has it first.")
								: vformat("The uniforms of `surface_hook` are: %s.", String(", ").join(uniforms))));
}

void GrassField::set_hook_parameter(const StringName &p_name, const Variant &p_value) {
	GRASS_MAIN_THREAD_ONLY();
	ERR_FAIL_COND_MSG(!_properties.hook.has(p_name), no_uniform("set_hook_parameter()", p_name));
	_properties.hook.set_value(p_name, p_value);
	_standing.set_uniform(p_name, p_value);
}

Variant GrassField::get_hook_parameter(const StringName &p_name) const {
	GRASS_MAIN_THREAD_ONLY_V(Variant());
	ERR_FAIL_COND_V_MSG(!_properties.hook.has(p_name), Variant(), no_uniform("get_hook_parameter()", p_name));
	return _properties.hook.get_value(p_name);
}

void GrassField::_get_property_list(List<PropertyInfo> *r_list) const {
	_properties.hook.list(r_list);
}

} // namespace grass
