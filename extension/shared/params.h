// SPDX-License-Identifier: MIT
// Turns a Tunable of the core into a property: its hint, clamping and warning. And adds settings of the project.
#pragma once

#include "core/base/tunable.h"
#include "shared/text.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include <span>

namespace grass {

godot::PropertyInfo property_of(const Tunable &p_tunable);
// Adds the properties of p_table from p_first to p_last to a class that has _set_param() and _get_param().
void add_params(const godot::StringName &p_class, std::span<const Tunable> p_table, int p_first, int p_last);

// Returns the value for the property's getter: an int if the property is a whole number.
godot::Variant property_value(const Tunable &p_tunable, double p_value);

// Returns the nearest allowed value. If that differs from p_value, prints a warning that names p_owner and the property.
double checked(const Tunable &p_tunable, double p_value, const godot::String &p_owner);

// Returns the inspector's hint for a whole number within limits.
godot::String range_hint(int64_t p_min, int64_t p_max, const godot::String &p_unit = godot::String());
// Returns the nearest whole number within limits, and warns as checked() does.
int64_t checked_int(const char *p_property, int64_t p_value, int64_t p_min, int64_t p_max, const godot::String &p_owner);

// Adds a warning for p_who if a minimum is above its maximum. p_so: the consequence, for the message.
void warn_if_reversed(const godot::String &p_who, const Tunable &p_min, double p_least, const Tunable &p_max, double p_most,
		const char *p_so, godot::PackedStringArray &r_warnings);

// Adds a setting to the project's, with its default value, unless the project has it.
void add_project_setting(
		const char *p_path, const godot::Variant &p_initial, godot::PropertyHint p_hint, const godot::String &p_hint_string);

} // namespace grass
