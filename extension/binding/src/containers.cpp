// SPDX-License-Identifier: MIT
// Array, Dictionary, the packed arrays' elements, and the callables and signals of objects.
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot {

namespace engine = gdextension_interface;

Array::Array(std::initializer_list<Variant> p_values) {
	resize(static_cast<int64_t>(p_values.size()));
	int64_t index = 0;
	for (const Variant &value : p_values) {
		(*this)[index++] = value;
	}
}

Array::Array(const Array &p_base, int64_t p_type, const StringName &p_class_name, const Variant &p_script) :
		Opaque(2, static_cast<const void *>(&p_base), static_cast<const void *>(&p_type), static_cast<const void *>(&p_class_name),
				static_cast<const void *>(&p_script)) {}

// The order of the engine's constructors.
Array::Array(const PackedByteArray &p_from) : Opaque(3, &p_from) {}
Array::Array(const PackedInt32Array &p_from) : Opaque(4, &p_from) {}
Array::Array(const PackedInt64Array &p_from) : Opaque(5, &p_from) {}
Array::Array(const PackedFloat32Array &p_from) : Opaque(6, &p_from) {}
Array::Array(const PackedFloat64Array &p_from) : Opaque(7, &p_from) {}
Array::Array(const PackedStringArray &p_from) : Opaque(8, &p_from) {}
Array::Array(const PackedVector2Array &p_from) : Opaque(9, &p_from) {}
Array::Array(const PackedVector3Array &p_from) : Opaque(10, &p_from) {}
Array::Array(const PackedColorArray &p_from) : Opaque(11, &p_from) {}
Array::Array(const PackedVector4Array &p_from) : Opaque(12, &p_from) {}

Variant &Array::operator[](int64_t p_index) {
	return *static_cast<Variant *>(engine::array_operator_index(_storage, p_index));
}
const Variant &Array::operator[](int64_t p_index) const {
	return *static_cast<const Variant *>(engine::array_operator_index_const(_storage, p_index));
}
void Array::set_typed(uint32_t p_type, const StringName &p_class_name, const Variant &p_script) {
	engine::array_set_typed(_storage, static_cast<GDExtensionVariantType>(p_type), p_class_name._native_ptr(), p_script._native_ptr());
}
Variant *Array::elements() const {
	return is_empty() ? nullptr : static_cast<Variant *>(engine::array_operator_index_const(_storage, 0));
}
internal::ElementIterator<Variant> Array::end() {
	return elements() + size();
}
internal::ElementIterator<const Variant> Array::end() const {
	return elements() + size();
}

Variant &Dictionary::operator[](const Variant &p_key) {
	return *static_cast<Variant *>(engine::dictionary_operator_index(_storage, p_key._native_ptr()));
}
const Variant &Dictionary::operator[](const Variant &p_key) const {
	return *static_cast<const Variant *>(engine::dictionary_operator_index_const(_storage, p_key._native_ptr()));
}

Callable::Callable(Object *p_object, const StringName &p_method) : Opaque(UNINITIALIZED) {
	GodotObject *const owner = internal::owner_of(p_object);
	const GDExtensionConstTypePtr arguments[] = { &owner, &p_method };
	internal::builtin_types[GDEXTENSION_VARIANT_TYPE_CALLABLE].constructors[2](_storage, arguments);
}

Signal::Signal(Object *p_object, const StringName &p_signal) : Opaque(UNINITIALIZED) {
	GodotObject *const owner = internal::owner_of(p_object);
	const GDExtensionConstTypePtr arguments[] = { &owner, &p_signal };
	internal::builtin_types[GDEXTENSION_VARIANT_TYPE_SIGNAL].constructors[2](_storage, arguments);
}

namespace internal {

const void *packed_read(GDExtensionVariantType p_type, const void *p_array) {
	switch (p_type) {
		case GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY:
			return engine::packed_byte_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_INT32_ARRAY:
			return engine::packed_int32_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_INT64_ARRAY:
			return engine::packed_int64_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY:
			return engine::packed_float32_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT64_ARRAY:
			return engine::packed_float64_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_STRING_ARRAY:
			return engine::packed_string_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR2_ARRAY:
			return engine::packed_vector2_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY:
			return engine::packed_vector3_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_COLOR_ARRAY:
			return engine::packed_color_array_operator_index_const(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR4_ARRAY:
			return engine::packed_vector4_array_operator_index_const(p_array, 0);
		default:
			return nullptr;
	}
}

void *packed_write(GDExtensionVariantType p_type, void *p_array) {
	switch (p_type) {
		case GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY:
			return engine::packed_byte_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_INT32_ARRAY:
			return engine::packed_int32_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_INT64_ARRAY:
			return engine::packed_int64_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY:
			return engine::packed_float32_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT64_ARRAY:
			return engine::packed_float64_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_STRING_ARRAY:
			return engine::packed_string_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR2_ARRAY:
			return engine::packed_vector2_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR3_ARRAY:
			return engine::packed_vector3_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_COLOR_ARRAY:
			return engine::packed_color_array_operator_index(p_array, 0);
		case GDEXTENSION_VARIANT_TYPE_PACKED_VECTOR4_ARRAY:
			return engine::packed_vector4_array_operator_index(p_array, 0);
		default:
			return nullptr;
	}
}

} // namespace internal

} // namespace godot
