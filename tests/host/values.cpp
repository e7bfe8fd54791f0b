// SPDX-License-Identifier: MIT
// Values and variants.
#include "host.h"

#include <charconv>
#include <cstring>
#include <utility>

namespace host {

constexpr size_t REAL = sizeof(real_t), POINTER = sizeof(void *), LIST = 2 * POINTER;
const size_t TYPE_SIZES[TYPES] = { 0, 1, 8, 8, POINTER, 2 * REAL, 8, 4 * REAL, 16, 3 * REAL, 12, 6 * REAL, 4 * REAL, 16, 4 * REAL, 4 * REAL,
	6 * REAL, 9 * REAL, 12 * REAL, 16 * REAL, 16, POINTER, POINTER, 8, POINTER, 16, 16, POINTER, POINTER, LIST, LIST, LIST, LIST, LIST,
	LIST, LIST, LIST, LIST, LIST };
const char *const TYPE_NAMES[TYPES] = { "null", "bool", "int", "float", "String", "Vector2", "Vector2i", "Rect2", "Rect2i", "Vector3",
	"Vector3i", "Transform2D", "Vector4", "Vector4i", "Plane", "Quaternion", "AABB", "Basis", "Transform3D", "Projection", "Color",
	"StringName", "NodePath", "RID", "Object", "Callable", "Signal", "Dictionary", "Array", "PackedByteArray", "PackedInt32Array",
	"PackedInt64Array", "PackedFloat32Array", "PackedFloat64Array", "PackedStringArray", "PackedVector2Array", "PackedVector3Array",
	"PackedColorArray", "PackedVector4Array" };

const void *value_of(const Variant &p_variant) {
	const void *value = p_variant.bytes;
	if (TYPE_SIZES[p_variant.type] > sizeof(p_variant.bytes)) {
		std::memcpy(&value, p_variant.bytes, sizeof(value));
	}
	return value;
}

void set_value(Variant &r_variant, int p_type, const void *p_value) {
	r_variant = { p_type, 0, {} };
	const size_t size = TYPE_SIZES[p_type];
	if (size <= sizeof(r_variant.bytes)) {
		std::memcpy(r_variant.bytes, p_value, size);
		return;
	}
	void *copy = new uint8_t[size];
	std::memcpy(copy, p_value, size);
	std::memcpy(r_variant.bytes, &copy, sizeof(copy));
}

namespace {

template <class T> std::string number(T p_value) {
	char text[64];
	return std::string(text, std::to_chars(text, text + sizeof(text), p_value).ptr);
}

template <class T> std::string numbers(const void *p_value, size_t p_bytes) {
	std::string text;
	for (size_t at = 0; at < p_bytes; at += sizeof(T)) {
		T value;
		std::memcpy(&value, static_cast<const uint8_t *>(p_value) + at, sizeof(T));
		text += (at ? ", " : "") + number(value);
	}
	return text;
}

std::string with_point(const std::string &p_number) {
	return p_number.find_first_of(".en") == std::string::npos ? p_number + ".0" : p_number;
}

bool is_of_integers(int p_type) {
	return p_type == GDEXTENSION_VARIANT_TYPE_VECTOR2I || p_type == GDEXTENSION_VARIANT_TYPE_RECT2I ||
			p_type == GDEXTENSION_VARIANT_TYPE_VECTOR3I || p_type == GDEXTENSION_VARIANT_TYPE_VECTOR4I;
}

} // namespace

std::string print(const Variant &p_variant) {
	const void *value = value_of(p_variant);
	const int type = p_variant.type;
	const std::string name = TYPE_NAMES[type];
	switch (type) {
		case GDEXTENSION_VARIANT_TYPE_NIL:
			return name;
		case GDEXTENSION_VARIANT_TYPE_BOOL:
			return *static_cast<const uint8_t *>(value) ? "true" : "false";
		case GDEXTENSION_VARIANT_TYPE_INT:
			return numbers<int64_t>(value, 8);
		case GDEXTENSION_VARIANT_TYPE_FLOAT:
			return with_point(numbers<double>(value, 8));
		case GDEXTENSION_VARIANT_TYPE_STRING:
		case GDEXTENSION_VARIANT_TYPE_NODE_PATH:
			return name + " \"" + string_text(value) + "\"";
		case GDEXTENSION_VARIANT_TYPE_STRING_NAME:
			return name + " \"" + name_text(value) + "\"";
		default:
			break;
	}
	if (type < GDEXTENSION_VARIANT_TYPE_STRING_NAME) {
		const size_t size = TYPE_SIZES[type];
		const bool is_color = type == GDEXTENSION_VARIANT_TYPE_COLOR;
		const std::string all = is_of_integers(type) ? numbers<int32_t>(value, size)
				: is_color                           ? numbers<float>(value, size)
													 : numbers<real_t>(value, size);
		return name + "(" + all + ")";
	}
	void *first; // of what is larger than a pointer, the first part says whether there is anything
	std::memcpy(&first, value, sizeof(first));
	return name + (first ? " (something)" : " (nothing)");
}

namespace {

template <int TYPE> void to_variant(GDExtensionUninitializedVariantPtr r_variant, GDExtensionTypePtr p_value) {
	set_value(*static_cast<Variant *>(r_variant), TYPE, p_value);
}

// A value of another type becomes one of this type that says nothing, but for numbers.
template <int TYPE> void from_variant(GDExtensionUninitializedTypePtr r_value, GDExtensionVariantPtr p_variant) {
	const Variant &variant = *static_cast<const Variant *>(p_variant);
	std::memset(r_value, 0, TYPE_SIZES[TYPE]);
	if (variant.type == TYPE) {
		std::memcpy(r_value, value_of(variant), TYPE_SIZES[TYPE]);
	} else if (TYPE == GDEXTENSION_VARIANT_TYPE_FLOAT && variant.type == GDEXTENSION_VARIANT_TYPE_INT) {
		int64_t whole;
		std::memcpy(&whole, variant.bytes, sizeof(whole));
		const double value = double(whole);
		std::memcpy(r_value, &value, sizeof(value));
	}
}

// The first constructors of every type: empty, and a copy. Of the others only text of a name and a name of text.
template <int TYPE, int INDEX> void make(GDExtensionUninitializedTypePtr r_value, const GDExtensionConstTypePtr *p_arguments) {
	constexpr bool IS_OTHER = INDEX == 2;
	if (INDEX == 0) {
		std::memset(r_value, 0, TYPE_SIZES[TYPE]);
	} else if (INDEX == 1) {
		std::memcpy(r_value, p_arguments[0], TYPE_SIZES[TYPE]);
	} else if (IS_OTHER && TYPE == GDEXTENSION_VARIANT_TYPE_STRING) {
		*static_cast<Text *>(r_value) = make_text(utf32(name_text(p_arguments[0])));
	} else if (IS_OTHER && TYPE == GDEXTENSION_VARIANT_TYPE_STRING_NAME) {
		*static_cast<Name *>(r_value) = make_name(string_text(p_arguments[0]));
	} else if (IS_OTHER && TYPE == GDEXTENSION_VARIANT_TYPE_NODE_PATH) {
		std::memcpy(r_value, p_arguments[0], TYPE_SIZES[TYPE]);
	} else if (INDEX == 3 && TYPE == GDEXTENSION_VARIANT_TYPE_VECTOR3) { // numbers cross as doubles in any engine
		const auto number = [&](int p_axis) { return real_t(*static_cast<const double *>(p_arguments[p_axis])); };
		*static_cast<Vector3 *>(r_value) = { number(0), number(1), number(2) };
	} else if (IS_OTHER && TYPE == GDEXTENSION_VARIANT_TYPE_CALLABLE) {
		std::memset(r_value, 0, TYPE_SIZES[TYPE]);
	} else {
		lack("constructor " + std::to_string(INDEX) + " of " + TYPE_NAMES[TYPE]);
	}
}

// One of each for every type.
constexpr int CONSTRUCTORS = 13;
struct TypeFunctions {
	GDExtensionVariantFromTypeConstructorFunc to_variant;
	GDExtensionTypeFromVariantConstructorFunc from_variant;
	GDExtensionPtrConstructor constructors[CONSTRUCTORS];
};
template <int TYPE, int... INDICES> TypeFunctions functions_of(std::integer_sequence<int, INDICES...>) {
	return { &to_variant<TYPE>, &from_variant<TYPE>, { &make<TYPE, INDICES>... } };
}
template <int... ALL> const TypeFunctions &type_functions(int p_type, std::integer_sequence<int, ALL...>) {
	static const TypeFunctions functions[] = { functions_of<ALL>(std::make_integer_sequence<int, CONSTRUCTORS>())... };
	return functions[p_type];
}
const TypeFunctions &type_functions(int p_type) {
	return type_functions(p_type, std::make_integer_sequence<int, TYPES>());
}

bool same(const Variant &p_a, const Variant &p_b) {
	return p_a.type == p_b.type && std::memcmp(value_of(p_a), value_of(p_b), TYPE_SIZES[p_a.type]) == 0;
}

} // namespace

void offer_values(Functions &r_functions) {
	offer(
			r_functions, "get_variant_from_type_constructor",
			+[](GDExtensionVariantType p_type) { return type_functions(p_type).to_variant; });
	offer(
			r_functions, "get_variant_to_type_constructor",
			+[](GDExtensionVariantType p_type) { return type_functions(p_type).from_variant; });
	offer(
			r_functions, "variant_get_ptr_constructor",
			+[](GDExtensionVariantType p_type, int32_t p_index) { return type_functions(p_type).constructors[p_index]; });
	offer(
			r_functions, "variant_get_ptr_destructor", +[](GDExtensionVariantType) { return +[](GDExtensionTypePtr) {}; });
	offer(
			r_functions, "variant_get_type_name", +[](GDExtensionVariantType p_type, GDExtensionUninitializedStringPtr r_name) {
				*static_cast<Text *>(r_name) = make_text(utf32(TYPE_NAMES[p_type]));
			});
	offer(
			r_functions, "variant_new_nil", +[](GDExtensionUninitializedVariantPtr r_new) { *static_cast<Variant *>(r_new) = {}; });
	offer(
			r_functions, "variant_new_copy", +[](GDExtensionUninitializedVariantPtr r_new, GDExtensionConstVariantPtr p_from) {
				*static_cast<Variant *>(r_new) = *static_cast<const Variant *>(p_from);
			});
	offer(
			r_functions, "variant_destroy", +[](GDExtensionVariantPtr) {});
	offer(
			r_functions, "variant_get_type",
			+[](GDExtensionConstVariantPtr p_self) { return GDExtensionVariantType(static_cast<const Variant *>(p_self)->type); });
	offer(
			r_functions, "variant_hash_compare", +[](GDExtensionConstVariantPtr p_a, GDExtensionConstVariantPtr p_b) {
				return GDExtensionBool(same(*static_cast<const Variant *>(p_a), *static_cast<const Variant *>(p_b)));
			});
	offer(
			r_functions, "variant_can_convert_strict",
			+[](GDExtensionVariantType p_a, GDExtensionVariantType p_b) { return GDExtensionBool(p_a == p_b); });
}

} // namespace host
