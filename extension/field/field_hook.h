// SPDX-License-Identifier: MIT
// The `surface_hook` of a field: the user's include, its compiled text, and the values of its uniforms.
#pragma once

#include "draw/shared_shader.h"
#include "draw/surface_hook.h"

#include <godot_cpp/templates/list.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <utility>
#include <vector>

namespace grass {

class FieldHook {
public:
	// Sets the include. p_changed runs when it changes; call compile() then.
	void set_include(const godot::Ref<godot::ShaderInclude> &p_include, const godot::Callable &p_changed);
	const godot::Ref<godot::ShaderInclude> &get_include() const { return _include; }
	void compile(); // the field is drawn without an include that does not compile
	// Marks an include that compiles alone, but not in the field's shaders.
	void reject();
	const godot::String &get_text() const { return _hook.text; } // SurfaceHook::text

	bool has(const godot::StringName &p_uniform) const { return _hook.find(p_uniform) != nullptr; }
	godot::PackedStringArray get_uniforms() const;
	void set_value(const godot::StringName &p_uniform, const godot::Variant &p_value); // null: the include's default
	godot::Variant get_value(const godot::StringName &p_uniform) const;
	void hand_on(const SetUniform &p_set) const; // all values

	// Treat the uniforms as properties, hook/NAME. A scene sets them before or after the include.
	static bool is_property(const godot::StringName &p_name);
	void set_property(const godot::StringName &p_property, const godot::Variant &p_value);
	godot::Variant get_property(const godot::StringName &p_property) const;
	void list(godot::List<godot::PropertyInfo> *r_list) const;
	void warn(godot::PackedStringArray &r_warnings) const;
	godot::String get_name() const; // of the include, for messages

private:
	godot::Ref<godot::ShaderInclude> _include;
	SurfaceHook _hook;
	bool _is_broken = false;
	std::vector<std::pair<godot::StringName, godot::Variant>> _values;
};

} // namespace grass
