// SPDX-License-Identifier: MIT
// The number that the engine gives each C++ type.
#pragma once

#include <godot_cpp/variant/forward.hpp>

#include <gdextension_interface.h>

#include <type_traits>

namespace godot {

template <typename T> class Ref;
template <typename T> class BitField;
template <typename T> class TypedArray;

namespace internal {

// Whatever is none of the below is taken for an object (or a pointer or Ref to one).
template <typename T> inline constexpr GDExtensionVariantType builtin_code = GDEXTENSION_VARIANT_TYPE_OBJECT;

template <> inline constexpr GDExtensionVariantType builtin_code<Variant> = GDEXTENSION_VARIANT_TYPE_NIL;
template <typename T> inline constexpr GDExtensionVariantType builtin_code<BitField<T>> = GDEXTENSION_VARIANT_TYPE_INT;
template <typename T> inline constexpr GDExtensionVariantType builtin_code<TypedArray<T>> = GDEXTENSION_VARIANT_TYPE_ARRAY;

#define GODOT_BUILTIN_CODE(m_type, m_code)                                                                                                 \
	template <> inline constexpr GDExtensionVariantType builtin_code<m_type> = GDEXTENSION_VARIANT_TYPE_##m_code;
GODOT_BUILTIN_CODE(String, STRING)
GODOT_BUILTIN_CODE(Vector2, VECTOR2)
GODOT_BUILTIN_CODE(Vector2i, VECTOR2I)
GODOT_BUILTIN_CODE(Rect2, RECT2)
GODOT_BUILTIN_CODE(Rect2i, RECT2I)
GODOT_BUILTIN_CODE(Vector3, VECTOR3)
GODOT_BUILTIN_CODE(Vector4, VECTOR4)
GODOT_BUILTIN_CODE(Plane, PLANE)
GODOT_BUILTIN_CODE(Quaternion, QUATERNION)
GODOT_BUILTIN_CODE(AABB, AABB)
GODOT_BUILTIN_CODE(Basis, BASIS)
GODOT_BUILTIN_CODE(Transform3D, TRANSFORM3D)
GODOT_BUILTIN_CODE(Projection, PROJECTION)
GODOT_BUILTIN_CODE(Color, COLOR)
GODOT_BUILTIN_CODE(StringName, STRING_NAME)
GODOT_BUILTIN_CODE(NodePath, NODE_PATH)
GODOT_BUILTIN_CODE(RID, RID)
GODOT_BUILTIN_CODE(Callable, CALLABLE)
GODOT_BUILTIN_CODE(Signal, SIGNAL)
GODOT_BUILTIN_CODE(Dictionary, DICTIONARY)
GODOT_BUILTIN_CODE(Array, ARRAY)
GODOT_BUILTIN_CODE(PackedByteArray, PACKED_BYTE_ARRAY)
GODOT_BUILTIN_CODE(PackedInt32Array, PACKED_INT32_ARRAY)
GODOT_BUILTIN_CODE(PackedInt64Array, PACKED_INT64_ARRAY)
GODOT_BUILTIN_CODE(PackedFloat32Array, PACKED_FLOAT32_ARRAY)
GODOT_BUILTIN_CODE(PackedFloat64Array, PACKED_FLOAT64_ARRAY)
GODOT_BUILTIN_CODE(PackedStringArray, PACKED_STRING_ARRAY)
GODOT_BUILTIN_CODE(PackedVector2Array, PACKED_VECTOR2_ARRAY)
GODOT_BUILTIN_CODE(PackedVector3Array, PACKED_VECTOR3_ARRAY)
GODOT_BUILTIN_CODE(PackedColorArray, PACKED_COLOR_ARRAY)
GODOT_BUILTIN_CODE(PackedVector4Array, PACKED_VECTOR4_ARRAY)
#undef GODOT_BUILTIN_CODE

template <typename T> constexpr GDExtensionVariantType find_type_code() {
	if constexpr (std::is_same_v<T, bool>) {
		return GDEXTENSION_VARIANT_TYPE_BOOL;
	} else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
		return GDEXTENSION_VARIANT_TYPE_INT;
	} else if constexpr (std::is_floating_point_v<T>) {
		return GDEXTENSION_VARIANT_TYPE_FLOAT;
	} else {
		return builtin_code<T>;
	}
}

// Of a parameter or result type; references and const do not matter.
template <typename T> inline constexpr GDExtensionVariantType type_code = find_type_code<std::remove_cvref_t<T>>();

} // namespace internal

} // namespace godot
