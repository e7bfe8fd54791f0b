// SPDX-License-Identifier: MIT
// A value of any type that the engine knows.
#pragma once

#include <godot_cpp/core/builtin_call.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/object_id.hpp>
#include <godot_cpp/variant/builtin_types.hpp>
#include <godot_cpp/variant/variant_pointers.hpp>

namespace godot {

class Variant {
public:
	enum Type {
		NIL,
		BOOL,
		INT,
		FLOAT,
		STRING,
		VECTOR2,
		VECTOR2I,
		RECT2,
		RECT2I,
		VECTOR3,
		VECTOR3I,
		TRANSFORM2D,
		VECTOR4,
		VECTOR4I,
		PLANE,
		QUATERNION,
		AABB,
		BASIS,
		TRANSFORM3D,
		PROJECTION,
		COLOR,
		STRING_NAME,
		NODE_PATH,
		RID,
		OBJECT,
		CALLABLE,
		SIGNAL,
		DICTIONARY,
		ARRAY,
		PACKED_BYTE_ARRAY,
		PACKED_INT32_ARRAY,
		PACKED_INT64_ARRAY,
		PACKED_FLOAT32_ARRAY,
		PACKED_FLOAT64_ARRAY,
		PACKED_STRING_ARRAY,
		PACKED_VECTOR2_ARRAY,
		PACKED_VECTOR3_ARRAY,
		PACKED_COLOR_ARRAY,
		PACKED_VECTOR4_ARRAY,
		VARIANT_MAX,
	};
	static_assert(int(VARIANT_MAX) == int(GDEXTENSION_VARIANT_TYPE_VARIANT_MAX));

	enum Operator {
		OP_EQUAL,
		OP_NOT_EQUAL,
		OP_LESS,
		OP_LESS_EQUAL,
		OP_GREATER,
		OP_GREATER_EQUAL,
		OP_ADD,
		OP_SUBTRACT,
		OP_MULTIPLY,
		OP_DIVIDE,
		OP_NEGATE,
		OP_POSITIVE,
		OP_MODULE,
		OP_POWER,
		OP_SHIFT_LEFT,
		OP_SHIFT_RIGHT,
		OP_BIT_AND,
		OP_BIT_OR,
		OP_BIT_XOR,
		OP_BIT_NEGATE,
		OP_AND,
		OP_OR,
		OP_XOR,
		OP_NOT,
		OP_IN,
		OP_MAX,
	};
	static_assert(int(OP_MAX) == int(GDEXTENSION_VARIANT_OP_MAX));

	Variant();
	Variant(std::nullptr_t) : Variant() {}
	Variant(const Variant &p_other);
	Variant(Variant &&p_other) noexcept;
	~Variant();
	Variant &operator=(const Variant &p_other);
	Variant &operator=(Variant &&p_other) noexcept;

	Variant(bool p_value);
	Variant(int64_t p_value);
	Variant(int32_t p_value) : Variant(int64_t(p_value)) {}
	Variant(int16_t p_value) : Variant(int64_t(p_value)) {}
	Variant(int8_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint64_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint32_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint16_t p_value) : Variant(int64_t(p_value)) {}
	Variant(uint8_t p_value) : Variant(int64_t(p_value)) {}
	Variant(double p_value);
	Variant(float p_value) : Variant(double(p_value)) {}
	Variant(const char *p_value) : Variant(String(p_value)) {}
	Variant(const wchar_t *p_value) : Variant(String(p_value)) {}
	Variant(const char16_t *p_value) : Variant(String(p_value)) {}
	Variant(const char32_t *p_value) : Variant(String(p_value)) {}
	Variant(const ObjectID &p_value) : Variant(int64_t(p_value)) {}
	Variant(const Object *p_value);

	operator bool() const;
	operator int64_t() const;
	operator int32_t() const { return int32_t(operator int64_t()); }
	operator int16_t() const { return int16_t(operator int64_t()); }
	operator int8_t() const { return int8_t(operator int64_t()); }
	operator uint64_t() const { return uint64_t(operator int64_t()); }
	operator uint32_t() const { return uint32_t(operator int64_t()); }
	operator uint16_t() const { return uint16_t(operator int64_t()); }
	operator uint8_t() const { return uint8_t(operator int64_t()); }
	operator double() const;
	operator float() const { return float(operator double()); }
	operator ObjectID() const;
	operator Object *() const { return get_validated_object(); }

#define GODOT_VARIANT_BUILTIN(m_type)                                                                                                      \
	Variant(const m_type &p_value);                                                                                                        \
	operator m_type() const;
#include <godot_cpp/variant/variant_builtins.inc>
#undef GODOT_VARIANT_BUILTIN

	// The object, or null where it no longer lives.
	Object *get_validated_object() const;
	Type get_type() const;
	static String get_type_name(Type p_type);

	bool operator==(const Variant &p_other) const;
	bool operator!=(const Variant &p_other) const {
		return !(*this == p_other);
	}
	bool operator<(const Variant &p_other) const;
	static void evaluate(const Operator &p_operator, const Variant &p_a, const Variant &p_b, Variant &r_result, bool &r_valid);

	void callp(const StringName &p_method, const Variant **p_arguments, int p_count, Variant &r_result, GDExtensionCallError &r_error);
	template <typename... Arguments> Variant call(const StringName &p_method, const Arguments &...p_arguments) {
		const Variant values[] = { Variant(p_arguments)..., Variant() };
		Variant result;
		GDExtensionCallError error;
		callp(p_method, internal::VariantPointers<sizeof...(Arguments)>(values).pointers, sizeof...(Arguments), result, error);
		return result;
	}

	// Members, elements and keys, whatever the value has.
	void set(const Variant &p_key, const Variant &p_value, bool *r_valid = nullptr);
	Variant get(const Variant &p_key, bool *r_valid = nullptr) const;
	bool has_method(const StringName &p_method) const;

	uint32_t hash() const;
	bool booleanize() const;
	String stringify() const;
	Variant duplicate(bool p_deep = false) const;
	void clear();
	void *_native_ptr() const {
		return const_cast<uint64_t *>(_storage);
	}

private:
	uint64_t _storage[1 + 4 * sizeof(real_t) / sizeof(uint64_t)]; // its type, and at most four numbers
};

template <typename... Arguments> Array Array::make(const Arguments &...p_values) {
	return Array{ Variant(p_values)... };
}

// "%s is %d years old" and so on.
template <typename... Arguments> String vformat(const String &p_text, const Arguments &...p_values) {
	return p_text % Variant(Array::make(p_values...));
}

using PackedRealArray = std::conditional_t<internal::IS_DOUBLE, PackedFloat64Array, PackedFloat32Array>;

} // namespace godot
