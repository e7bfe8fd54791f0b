// SPDX-License-Identifier: MIT
#include "shared/same_data.h"

#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

using namespace godot;

namespace grass {

namespace {

template <typename T> bool is_same_array(const Variant &p_a, const Variant &p_b) {
	const T a = p_a, b = p_b;
	return a.size() == b.size() && (a.ptr() == b.ptr() || a == b);
}

bool is_same_dictionary(const Dictionary &p_a, const Dictionary &p_b) {
	if (p_a.size() != p_b.size()) {
		return false;
	}
	const Array keys = p_a.keys();
	for (int64_t i = 0; i < keys.size(); i++) {
		if (!p_b.has(keys[i]) || !is_same_data(p_a[keys[i]], p_b[keys[i]])) {
			return false;
		}
	}
	return true;
}

} // namespace

bool is_same_data(const Variant &p_a, const Variant &p_b) {
	if (p_a.get_type() != p_b.get_type()) {
		return false;
	}
	switch (p_a.get_type()) {
		case Variant::DICTIONARY:
			return is_same_dictionary(p_a, p_b);
		case Variant::PACKED_FLOAT32_ARRAY:
			return is_same_array<PackedFloat32Array>(p_a, p_b);
		case Variant::PACKED_FLOAT64_ARRAY: // heights, in an engine in double precision
			return is_same_array<PackedFloat64Array>(p_a, p_b);
		case Variant::PACKED_VECTOR2_ARRAY:
			return is_same_array<PackedVector2Array>(p_a, p_b);
		case Variant::PACKED_VECTOR3_ARRAY:
			return is_same_array<PackedVector3Array>(p_a, p_b);
		default:
			return p_a == p_b;
	}
}

} // namespace grass
