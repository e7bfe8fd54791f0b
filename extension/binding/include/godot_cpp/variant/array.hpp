// SPDX-License-Identifier: MIT
// A list of Variants, shared by reference.
#pragma once

#include <godot_cpp/core/element_iterator.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <initializer_list>

namespace godot {

class Array : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_ARRAY, 1> {
public:
	Array() = default;
	Array(std::initializer_list<Variant> p_values);
	Array(const Variant *) = delete; // private upstream
	// A typed copy of another list.
	Array(const Array &p_base, int64_t p_type, const StringName &p_class_name, const Variant &p_script);
	Array(const PackedByteArray &p_from);
	Array(const PackedInt32Array &p_from);
	Array(const PackedInt64Array &p_from);
	Array(const PackedFloat32Array &p_from);
	Array(const PackedFloat64Array &p_from);
	Array(const PackedStringArray &p_from);
	Array(const PackedVector2Array &p_from);
	Array(const PackedVector3Array &p_from);
	Array(const PackedColorArray &p_from);
	Array(const PackedVector4Array &p_from);

	template <typename... Arguments> static Array make(const Arguments &...p_values);

	Variant &operator[](int64_t p_index);
	const Variant &operator[](int64_t p_index) const;
	void set_typed(uint32_t p_type, const StringName &p_class_name, const Variant &p_script);

	// For ranges; the list must not change meanwhile.
	internal::ElementIterator<Variant> begin() { return elements(); }
	internal::ElementIterator<Variant> end();
	internal::ElementIterator<const Variant> begin() const { return elements(); }
	internal::ElementIterator<const Variant> end() const;

#include <godot_cpp/variant/gen/array.inc>

private:
	Variant *elements() const; // null when empty
};

} // namespace godot
