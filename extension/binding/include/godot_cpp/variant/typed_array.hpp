// SPDX-License-Identifier: MIT
// An Array that holds one kind of value.
#pragma once

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/type_code.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

template <typename T> class TypedArray : public Array {
public:
	TypedArray() { set_element_type(); }
	TypedArray(const TypedArray &) = default;
	TypedArray(const Array &p_array) {
		set_element_type();
		if (is_same_typed(p_array)) {
			Array::operator=(p_array);
		} else {
			assign(p_array);
		}
	}
	TypedArray(const Variant &p_value) : TypedArray(Array(p_value)) {}
	TypedArray(std::initializer_list<Variant> p_values) : TypedArray(Array(p_values)) {}

	TypedArray &operator=(const TypedArray &) = default;
	void operator=(const Array &p_array) {
		ERR_FAIL_COND_MSG(!is_same_typed(p_array), "The other array holds another kind of value.");
		Array::operator=(p_array);
	}

private:
	void set_element_type() {
		if constexpr (internal::type_code<T> == GDEXTENSION_VARIANT_TYPE_OBJECT) {
			set_typed(internal::type_code<T>, T::get_class_static(), Variant());
		} else {
			set_typed(internal::type_code<T>, StringName(), Variant());
		}
	}
};

} // namespace godot
