// SPDX-License-Identifier: MIT
// How a C++ parameter or result looks to the engine: its number, its exact width, and its class or enum.
#pragma once

#include <godot_cpp/core/property_info.hpp>
#include <godot_cpp/core/type_code.hpp>

namespace godot {

// A set of flags of one enum.
template <typename T> class BitField {
public:
	BitField(int64_t p_value) : _value(p_value) {}
	bool has_flag(T p_flag) const { return _value & int64_t(p_flag); }
	operator int64_t() const { return _value; }
	operator Variant() const { return _value; }

private:
	int64_t _value;
};

namespace internal {

// Says the C++ name of an enum, once VARIANT_ENUM_CAST stood after it.
template <typename T> inline constexpr const char *enum_name = nullptr;
template <typename T> inline constexpr bool is_bitfield = false;
template <typename T> inline constexpr bool is_bitfield<BitField<T>> = true;

// "grass::GrassField::Mode" is GrassField.Mode to the engine.
StringName engine_enum_name(const char *p_qualified);

template <typename T> constexpr GDExtensionClassMethodArgumentMetadata number_metadata() {
	if constexpr (std::is_same_v<T, bool>) {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	} else if constexpr (std::is_integral_v<T>) {
		constexpr bool UNSIGNED = std::is_unsigned_v<T>;
		switch (sizeof(T)) {
			case 1:
				return UNSIGNED ? GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_UINT8 : GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_INT8;
			case 2:
				return UNSIGNED ? GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_UINT16 : GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_INT16;
			case 4:
				return UNSIGNED ? GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_UINT32 : GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_INT32;
			default:
				return UNSIGNED ? GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_UINT64 : GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_INT64;
		}
	} else if constexpr (std::is_same_v<T, float>) {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_FLOAT;
	} else if constexpr (std::is_same_v<T, double>) {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_DOUBLE;
	} else {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	}
}

// The class that a pointer, Ref or TypedArray element names; void for anything else.
template <typename T> struct NamedClass { using Type = void; };
template <typename T> struct NamedClass<T *> { using Type = std::remove_const_t<T>; };
template <typename T> struct NamedClass<Ref<T>> { using Type = T; };
template <typename T> struct Element { using Type = void; };
template <typename T> struct Element<TypedArray<T>> { using Type = T; };

template <typename T> struct GetTypeInfo {
	using Bare = std::remove_cvref_t<T>;
	static constexpr GDExtensionVariantType VARIANT_TYPE = type_code<T>;
	static constexpr GDExtensionClassMethodArgumentMetadata METADATA = number_metadata<Bare>();

	static PropertyInfo get_class_info() {
		PropertyInfo info(VARIANT_TYPE, StringName());
		if constexpr (std::is_same_v<Bare, Variant>) {
			info.usage |= PROPERTY_USAGE_NIL_IS_VARIANT;
		} else if constexpr (std::is_enum_v<Bare> || is_bitfield<Bare>) {
			static_assert(enum_name<Bare> != nullptr, "VARIANT_ENUM_CAST or VARIANT_BITFIELD_CAST must stand after this enum.");
			info.usage |= is_bitfield<Bare> ? PROPERTY_USAGE_CLASS_IS_BITFIELD : PROPERTY_USAGE_CLASS_IS_ENUM;
			info.class_name = engine_enum_name(enum_name<Bare>);
		} else if constexpr (!std::is_void_v<typename NamedClass<Bare>::Type>) {
			info.class_name = NamedClass<Bare>::Type::get_class_static();
			info.hint = PROPERTY_HINT_RESOURCE_TYPE;
			info.hint_string = info.class_name;
		} else if constexpr (!std::is_void_v<typename Element<Bare>::Type>) {
			using Element = typename Element<Bare>::Type;
			info.hint = PROPERTY_HINT_ARRAY_TYPE;
			if constexpr (type_code<Element> == GDEXTENSION_VARIANT_TYPE_OBJECT) {
				info.hint_string = Element::get_class_static();
			} else {
				info.hint_string = Variant::get_type_name(static_cast<Variant::Type>(type_code<Element>));
			}
		}
		return info;
	}
};

} // namespace internal

} // namespace godot

#define VARIANT_ENUM_CAST(m_enum)                                                                                                          \
	namespace godot {                                                                                                                      \
	template <> inline constexpr const char *internal::enum_name<m_enum> = #m_enum;                                                        \
	}
#define VARIANT_BITFIELD_CAST(m_enum)                                                                                                      \
	namespace godot {                                                                                                                      \
	template <> inline constexpr const char *internal::enum_name<m_enum> = #m_enum;                                                        \
	template <> inline constexpr const char *internal::enum_name<BitField<m_enum>> = #m_enum;                                              \
	}
