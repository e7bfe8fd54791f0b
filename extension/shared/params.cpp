// SPDX-License-Identifier: MIT
#include "shared/params.h"

#include <godot_cpp/classes/project_settings.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/dictionary.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

PropertyInfo property_of(const Tunable &p_tunable) {
	if (p_tunable.is_whole) {
		const String hint = range_hint(int64_t(p_tunable.minimum), int64_t(p_tunable.maximum), unit_of(p_tunable));
		return PropertyInfo(Variant::INT, p_tunable.name, PROPERTY_HINT_RANGE, hint);
	}
	String hint = vformat("%s,%s,%s", p_tunable.minimum, p_tunable.maximum, p_tunable.step);
	if (!unit_of(p_tunable).is_empty()) {
		hint += vformat(",suffix:%s", unit_of(p_tunable));
	}
	return PropertyInfo(Variant::FLOAT, p_tunable.name, PROPERTY_HINT_RANGE, hint);
}

void add_params(const StringName &p_class, std::span<const Tunable> p_table, int p_first, int p_last) {
	for (int param = p_first; param <= p_last; param++) {
		ClassDB::add_property(p_class, property_of(p_table[size_t(param)]), "_set_param", "_get_param", param);
	}
}

Variant property_value(const Tunable &p_tunable, double p_value) {
	return p_tunable.is_whole ? Variant(int64_t(p_value)) : Variant(p_value);
}

double checked(const Tunable &p_tunable, double p_value, const String &p_owner) {
	const double value = p_tunable.clamp(p_value);
	if (value != p_tunable.whole(p_value)) {
		const String unit = unit_of(p_tunable);
		WARN_PRINT(vformat("%s: `%s` cannot be %s (allowed: %s to %s%s); using %s.", p_owner, p_tunable.name, p_value, p_tunable.minimum,
				p_tunable.maximum, unit.is_empty() ? unit : " " + unit, value));
	}
	return value;
}

String range_hint(int64_t p_min, int64_t p_max, const String &p_unit) {
	const String range = vformat("%d,%d,1", p_min, p_max);
	return p_unit.is_empty() ? range : range + vformat(",suffix:%s", p_unit);
}

int64_t checked_int(const char *p_property, int64_t p_value, int64_t p_min, int64_t p_max, const String &p_owner) {
	const int64_t value = std::clamp(p_value, p_min, p_max);
	if (value != p_value) {
		WARN_PRINT(vformat("%s: `%s` cannot be %d (allowed: %d to %d); using %d.", p_owner, p_property, p_value, p_min, p_max, value));
	}
	return value;
}

void warn_if_reversed(const String &p_who, const Tunable &p_min, double p_least, const Tunable &p_max, double p_most, const char *p_so,
		PackedStringArray &r_warnings) {
	if (p_least > p_most) {
		r_warnings.push_back(vformat(
				"%s has `%s` above `%s`, so %s. Bring `%s` below `%s`.", p_who, p_min.name, p_max.name, p_so, p_min.name, p_max.name));
	}
}

void add_project_setting(const char *p_path, const Variant &p_initial, PropertyHint p_hint, const String &p_hint_string) {
	ProjectSettings *settings = ProjectSettings::get_singleton();
	if (!settings->has_setting(p_path)) {
		settings->set_setting(p_path, p_initial);
	}
	settings->set_initial_value(p_path, p_initial);
	Dictionary info;
	info["name"] = p_path;
	info["type"] = p_initial.get_type();
	info["hint"] = p_hint;
	info["hint_string"] = p_hint_string;
	settings->add_property_info(info);
}

} // namespace grass
