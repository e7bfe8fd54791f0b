// SPDX-License-Identifier: MIT
// How a core Tunable becomes a property: hint, clamp and warning all follow from it.
#pragma once

#include "core/base/tunable.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/string.hpp>

namespace grass {

godot::PropertyInfo property_of(const Tunable &p_tunable);

// What the getter of such a property returns: an int where it is a whole number.
godot::Variant property_value(const Tunable &p_tunable, double p_value);

// The nearest allowed value; warns, naming p_owner and the property, if it differs from the given one.
double checked(const Tunable &p_tunable, double p_value, const godot::String &p_owner);

// The inspector's hint of a whole number within limits.
godot::String range_hint(int64_t p_min, int64_t p_max, const char *p_unit = "");
// The nearest whole number within limits, as checked() does.
int64_t checked_int(const char *p_property, int64_t p_value, int64_t p_min, int64_t p_max, const godot::String &p_owner);

// Warns for p_who where a minimum is above its maximum. p_so: the consequence, for the message.
void warn_if_reversed(const godot::String &p_who, const Tunable &p_min, double p_least, const Tunable &p_max, double p_most,
		const char *p_so, godot::PackedStringArray &r_warnings);

} // namespace grass
