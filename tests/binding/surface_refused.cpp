// SPDX-License-Identifier: MIT
// What must not compile, since upstream refuses it: a binding that accepts more lets the extension use what a real godot-cpp does not have.
// Each line is about some type and every other one in its list.
#include "surface.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/templates/list.hpp>
#include <godot_cpp/templates/local_vector.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <iterator>
#include <ranges>
#include <span>

using namespace godot;

namespace {

// One use of two types each.
#define PAIR(m_name, ...)                                                                                                                  \
	template <typename T, typename U> struct m_name {                                                                                      \
		static constexpr bool value = requires(T & p_a, U &p_b, void (*p_take)(T)) { __VA_ARGS__; };                                       \
	};
PAIR(Converts, p_take(p_b))
PAIR(Constructs, T(p_b))
PAIR(Assigns, p_a = p_b)
PAIR(MadeOfOne, p_take({ p_b }))
PAIR(MadeOfTwo, p_take({ p_b, p_b }))
PAIR(MadeOfThree, p_take({ p_b, p_b, p_b }))
PAIR(Adds, p_a + p_b)
PAIR(Multiplies, p_a *p_b)
PAIR(Divides, p_a / p_b)
PAIR(Formats, p_a % p_b)
PAIR(Equals, p_a == p_b)
PAIR(Differs, p_a != p_b)
PAIR(AddsInPlace, p_a += p_b)
PAIR(MultipliesInPlace, p_a *= p_b)
PAIR(DividesInPlace, p_a /= p_b)
#undef PAIR

template <template <typename, typename> typename Use, typename T, typename... U> constexpr bool none = !(Use<T, U>::value || ...);

// Constant expressions of a type: upstream's functions are none.
template <typename T> constexpr bool is_constant_alone = requires {
	typename std::bool_constant<((void)T{}, true)>;
};
template <typename T, int... N> constexpr bool is_constant_of = requires {
	typename std::bool_constant<((void)T(N...), true)>;
};

template <typename T>
constexpr bool is_only_for_loops = !std::ranges::range<T> && !std::ranges::range<const T> && requires(T & p_range, const T &p_const) {
	*p_range.begin();
	++p_range.begin();
	requires !requires {
		p_range.begin()++;
	};
	requires !requires {
		p_range.begin() + 1;
	};
	requires !requires {
		p_range.end() - p_range.begin();
	};
	requires !requires {
		p_range.begin()[0];
	};
	requires !requires {
		p_range.begin() < p_range.end();
	};
	requires !std::is_pointer_v<decltype(p_range.begin())>;
	requires !std::is_pointer_v<decltype(p_const.begin())>;
	requires !requires {
		std::span(p_const.begin(), p_const.end());
	};
};

} // namespace

#define REFUSED(m_use, ...) static_assert(none<m_use, __VA_ARGS__>);
#define NUMBERS Vector2, Vector2i, Vector3, Vector4, Rect2, Rect2i, AABB, Basis, Quaternion, Transform3D, Projection, Plane, Color

// Loops go over these; algorithms, spans and arithmetic take pointers.
static_assert(is_only_for_loops<PackedByteArray> && is_only_for_loops<PackedInt32Array> && is_only_for_loops<PackedInt64Array>);
static_assert(is_only_for_loops<PackedFloat32Array> && is_only_for_loops<PackedFloat64Array> && is_only_for_loops<PackedStringArray>);
static_assert(is_only_for_loops<PackedVector2Array> && is_only_for_loops<PackedVector3Array> && is_only_for_loops<PackedColorArray>);
static_assert(is_only_for_loops<PackedVector4Array> && is_only_for_loops<Array>);
static_assert(is_only_for_loops<TypedArray<int64_t>> && is_only_for_loops<TypedArray<String>> && is_only_for_loops<TypedArray<Node>>);
static_assert(is_only_for_loops<LocalVector<int32_t>> && is_only_for_loops<List<int32_t>>);
REFUSED(Constructs, std::span<const int64_t>, PackedInt64Array)
REFUSED(Converts, std::span<const uint8_t>, PackedByteArray)

// Text.
REFUSED(Adds, std::nullptr_t, String, StringName, NodePath, Variant, NUMBERS)
REFUSED(Equals, std::nullptr_t, String, NUMBERS)
REFUSED(Formats, String, uint8_t, int32_t, uint32_t, uint64_t, char, char16_t, char32_t, ObjectID, Variant::Type, PropertyHint, Side)
REFUSED(Formats, String, BitField<PropertyUsageFlags>)
REFUSED(Adds, String, std::nullptr_t)
REFUSED(AddsInPlace, String, std::nullptr_t)
REFUSED(Equals, String, std::nullptr_t, NUMBERS)
REFUSED(Differs, String, std::nullptr_t, NUMBERS)
REFUSED(Adds, StringName, const char *, const wchar_t *, const char16_t *, const char32_t *, Variant)
REFUSED(Equals, StringName, const wchar_t *, const char16_t *, NodePath, NUMBERS)
REFUSED(Differs, StringName, const wchar_t *, const char16_t *, NodePath, NUMBERS)
REFUSED(Converts, NodePath, std::nullptr_t)
REFUSED(Constructs, NodePath, std::nullptr_t)
REFUSED(Assigns, NodePath, std::nullptr_t)
REFUSED(Equals, NodePath, StringName)

// Values of any type.
REFUSED(Equals, Variant, const wchar_t *, const char16_t *, const char32_t *)
REFUSED(Differs, Variant, const wchar_t *, const char16_t *, const char32_t *)
REFUSED(Equals, const wchar_t *, StringName, Variant)
REFUSED(Adds, const wchar_t *, Variant)
REFUSED(Adds, const char16_t *, Variant)
REFUSED(Adds, const char32_t *, Variant)
REFUSED(MultipliesInPlace, Vector2, Variant)
REFUSED(DividesInPlace, Vector2, Variant)
REFUSED(MultipliesInPlace, Vector3, Variant)
REFUSED(DividesInPlace, Vector3, Variant)
REFUSED(Multiplies, Basis, Variant)
REFUSED(Multiplies, Transform3D, Variant)
REFUSED(Divides, Color, Variant)
REFUSED(MultipliesInPlace, Color, Variant)
REFUSED(MadeOfOne, Color, Variant)
REFUSED(MadeOfTwo, Color, Variant)
REFUSED(MadeOfOne, Plane, Variant)
REFUSED(MadeOfOne, Basis, Variant)
REFUSED(MadeOfThree, Basis, Variant)

// Plain numbers.
REFUSED(Equals, Vector2, std::nullptr_t, String, StringName)
REFUSED(Equals, Vector2i, std::nullptr_t, String, StringName)
REFUSED(Equals, Vector3, std::nullptr_t, String, StringName)
REFUSED(Equals, Vector4, std::nullptr_t, String, StringName)
REFUSED(Equals, Rect2, std::nullptr_t, String, StringName)
REFUSED(Equals, Rect2i, std::nullptr_t, String, StringName)
REFUSED(Equals, AABB, std::nullptr_t, String, StringName)
REFUSED(Equals, Basis, std::nullptr_t, String, StringName)
REFUSED(Equals, Quaternion, std::nullptr_t, String, StringName)
REFUSED(Equals, Transform3D, std::nullptr_t, String, StringName)
REFUSED(Equals, Projection, std::nullptr_t, String, StringName)
REFUSED(Equals, Plane, std::nullptr_t, String, StringName)
REFUSED(Equals, Color, std::nullptr_t, String, StringName)
static_assert(!is_constant_alone<Vector2> && !is_constant_alone<Vector2i> && !is_constant_alone<Vector3> && !is_constant_alone<Vector4>);
static_assert(!is_constant_alone<Quaternion> && !is_constant_alone<Color>);
static_assert(!is_constant_of<Vector2, 1, 1> && !is_constant_of<Vector2i, 1, 1> && !is_constant_of<Vector3, 1, 1, 1>);
static_assert(!is_constant_of<Vector4, 1, 1, 1, 1> && !is_constant_of<Quaternion, 1, 1, 1, 1> && !is_constant_of<Plane, 1, 1, 1, 1>);
static_assert(!is_constant_of<Rect2, 1, 1, 1, 1> && !is_constant_of<Rect2i, 1, 1, 1, 1> && !is_constant_of<Color, 1, 1, 1>);
static_assert(!std::is_trivially_copyable_v<godot::RID> && !std::is_trivially_copyable_v<Quaternion>);

// Containers.
REFUSED(Constructs, TypedArray<int64_t>, std::nullptr_t, const Variant *)
REFUSED(Constructs, TypedArray<String>, std::nullptr_t, const Variant *)
REFUSED(Constructs, TypedArray<Node>, std::nullptr_t, const Variant *)
REFUSED(MadeOfOne, LocalVector<int32_t>, LocalVector<int32_t>)
REFUSED(MadeOfOne, List<int32_t>, List<int32_t>)

// A callable's method is of the object's very class.
template <typename T> constexpr bool takes_a_bases_method = requires(T *p_object) {
	callable_mp(p_object, &Node::queue_free);
};
static_assert(takes_a_bases_method<Node> && !takes_a_bases_method<Node3D>);
