// SPDX-License-Identifier: MIT
// How a core Tunable becomes a property: hint, clamp and warning are all made from it.
#pragma once

#include "core/tunable.h"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/variant/string.hpp>

namespace grass {

godot::PropertyInfo property_of(const Tunable &p_tunable);

// The nearest allowed value; says so, naming p_owner and the property, if that is another one.
double checked(const Tunable &p_tunable, double p_value, const godot::String &p_owner);

// A whole number within limits, likewise.
int64_t checked_int(const char *p_property, int64_t p_value, int64_t p_min, int64_t p_max, const godot::String &p_owner);

} // namespace grass
