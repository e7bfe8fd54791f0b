// SPDX-License-Identifier: MIT
#include "field/field_hook.h"

#include "shared/watch_resource.h"

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

const char *const PREFIX = "hook/"; // of the uniforms' properties

} // namespace

void FieldHook::set_include(const Ref<ShaderInclude> &p_include, const Callable &p_changed) {
	(void)watch_instead(_include, p_include, p_changed); // the field compared them
}

void FieldHook::compile() {
	_hook = compile_hook(_include);
	_is_broken = _include.is_valid() && _hook.text.is_empty();
}

void FieldHook::reject() {
	_hook = SurfaceHook();
	_is_broken = true;
}

PackedStringArray FieldHook::get_uniforms() const {
	PackedStringArray names;
	for (const SurfaceHook::Uniform &uniform : _hook.uniforms) {
		names.push_back(uniform.info.name);
	}
	return names;
}

void FieldHook::set_value(const StringName &p_uniform, const Variant &p_value) {
	const auto found = std::ranges::find(_values, p_uniform, &std::pair<StringName, Variant>::first);
	if (found == _values.end()) {
		_values.emplace_back(p_uniform, p_value);
	} else {
		found->second = p_value;
	}
}

Variant FieldHook::get_value(const StringName &p_uniform) const {
	const auto found = std::ranges::find(_values, p_uniform, &std::pair<StringName, Variant>::first);
	if (found != _values.end() && found->second.get_type() != Variant::NIL) {
		return found->second;
	}
	const SurfaceHook::Uniform *uniform = _hook.find(p_uniform);
	return uniform != nullptr ? uniform->initial : Variant();
}

// Hands on only the include's own values: those with a name of ours must not reach the shaders.
void FieldHook::hand_on(const SetUniform &p_set) const {
	for (const auto &[name, value] : _values) {
		if (has(name)) {
			p_set(name, value);
		}
	}
}

bool FieldHook::is_property(const StringName &p_name) {
	return String(p_name).begins_with(PREFIX);
}

void FieldHook::set_property(const StringName &p_property, const Variant &p_value) {
	set_value(String(p_property).trim_prefix(PREFIX), p_value);
}

Variant FieldHook::get_property(const StringName &p_property) const {
	return get_value(String(p_property).trim_prefix(PREFIX));
}

void FieldHook::list(List<PropertyInfo> *r_list) const {
	if (_hook.uniforms.empty()) {
		return;
	}
	r_list->push_back(PropertyInfo(Variant::NIL, "Surface Hook", PROPERTY_HINT_NONE, PREFIX, PROPERTY_USAGE_GROUP));
	for (const SurfaceHook::Uniform &uniform : _hook.uniforms) {
		PropertyInfo info = uniform.info;
		info.name = String(PREFIX) + String(info.name);
		r_list->push_back(info);
	}
}

String FieldHook::get_name() const {
	const String path = _include.is_valid() ? _include->get_path() : String();
	return path.is_empty() ? String("the include") : path;
}

void FieldHook::warn(PackedStringArray &r_warnings) const {
	if (_is_broken) {
		r_warnings.push_back(vformat(
				"`surface_hook`: %s does not compile, so the field is drawn without it. The output shows the shader error. The include "
				"must define `void grass_surface(in GrassSurface s, inout vec3 albedo, inout float roughness, inout vec3 emission)`; the "
				"field's shaders already use some names, so begin those of your functions and uniforms with a prefix of your own.",
				get_name()));
	}
}

} // namespace grass
