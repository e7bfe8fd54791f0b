// SPDX-License-Identifier: MIT
// Variants, texts and lists: what the binding stores is the engine's own, so values must survive the way there and back.
#include "tests.h"

#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/builtin_types.hpp>
#include <godot_cpp/variant/variant.hpp>

using namespace godot;

namespace {

// Returns whether a value comes back from a Variant as it was, with the right type, and through a copy of that Variant, too.
template <typename T> bool survives(const T &p_value, Variant::Type p_type) {
	const Variant first = p_value;
	const Variant second = first;
	return first.get_type() == p_type && T(first) == p_value && T(second) == p_value && first == second;
}

} // namespace

TEST_CASE("a Variant keeps every kind of value") {
	CHECK((survives(true, Variant::BOOL)));
	CHECK((survives(int64_t(-1) << 40, Variant::INT)));
	CHECK((survives(0.1, Variant::FLOAT)));
	CHECK((survives(String("text"), Variant::STRING)));
	CHECK((survives(Vector2(1, 2), Variant::VECTOR2)));
	CHECK((survives(Vector2i(1, -2), Variant::VECTOR2I)));
	CHECK((survives(Rect2(1, 2, 3, 4), Variant::RECT2)));
	CHECK((survives(Vector3(1, 2, 3), Variant::VECTOR3)));
	CHECK((survives(Vector4(1, 2, 3, 4), Variant::VECTOR4)));
	CHECK((survives(Plane(0, 1, 0, 2), Variant::PLANE)));
	CHECK((survives(Quaternion(0, 1, 0, 0), Variant::QUATERNION)));
	CHECK((survives(::godot::AABB(Vector3(1, 2, 3), Vector3(4, 5, 6)), Variant::AABB)));
	CHECK((survives(Transform3D(Basis(), Vector3(1, 2, 3)), Variant::TRANSFORM3D)));
	CHECK((survives(Projection({ 1, 2, 3, 4 }, { 5, 6, 7, 8 }, { 9, 10, 11, 12 }, { 13, 14, 15, 16 }), Variant::PROJECTION)));
	CHECK((survives(Color(0.25, 0.5, 0.75, 1), Variant::COLOR)));
	CHECK((survives(StringName("name"), Variant::STRING_NAME)));
	CHECK((survives(PackedFloat32Array({ 1.5f, 2.5f }), Variant::PACKED_FLOAT32_ARRAY)));
}

TEST_CASE("numbers convert as in scripts, and what cannot convert is zero") {
	CHECK((int64_t(Variant(2.9)) == 2));
	CHECK((double(Variant(3)) == 3.0));
	CHECK((uint32_t(Variant(uint32_t(0xffffffff))) == 0xffffffff));
	CHECK((bool(Variant(7))));
	CHECK((Vector3(Variant("no vector")) == Vector3()));
	CHECK((Variant().get_type() == Variant::NIL));
	CHECK((!Variant().booleanize()));
}

TEST_CASE("a Variant calls methods of what it holds, and reads its members") {
	Variant text = String("meadow");
	CHECK((int64_t(text.call("length")) == 6));
	CHECK((String(text.call("substr", 1, 3)) == "ead"));
	bool is_valid = false;
	CHECK((double(Variant(Vector3(1, 2, 3)).get("y", &is_valid)) == 2.0));
	CHECK((is_valid));
	Variant(Vector3()).get("no_member", &is_valid);
	CHECK((!is_valid));
	Variant sum;
	Variant::evaluate(Variant::OP_ADD, 2, 3, sum, is_valid);
	CHECK((is_valid && int64_t(sum) == 5));
}

TEST_CASE("texts are Unicode, and share nothing once one of them changes") {
	const String text = String::utf8("Gräser 草");
	CHECK((text.length() == 8));
	CHECK((text[7] == U'草'));
	CHECK((String::utf8(text.utf8().get_data()) == text));
	CHECK((text.utf8().length() == 11));
	String changed = text;
	changed[0] = U'g';
	CHECK((text[0] == U'G' && changed[0] == U'g'));
	changed += "!";
	CHECK((changed.length() == text.length() + 1));
	CHECK((vformat("%s: %d", String("blades"), 64) == "blades: 64"));
	CHECK((String("a") < String("b")));
	CHECK((String(NodePath("a/b:c").get_subname(0)) == "c"));
}

TEST_CASE("names of one text are one name") {
	const StringName first("grass"), second("grass"), other("reed");
	CHECK((first == second && first != other));
	CHECK((first.hash() == second.hash()));
	CHECK((String(first) == "grass"));
}

TEST_CASE("an Array is shared, a packed array is copied when it is written") {
	Array list = Array::make(1, "two", Vector3(3, 3, 3));
	Array same = list;
	same.append(4);
	CHECK((list.size() == 4));
	CHECK((int64_t(list[3]) == 4 && String(list[1]) == "two"));
	Array copy = list.duplicate();
	copy.clear();
	CHECK((list.size() == 4));

	PackedInt32Array packed = { 1, 2, 3 };
	PackedInt32Array other = packed;
	other.ptrw()[0] = 9;
	CHECK((packed[0] == 1 && other[0] == 9));
	CHECK((packed.ptr() != other.ptr()));
	int64_t sum = 0;
	for (const int32_t value : other) {
		sum += value;
	}
	CHECK((sum == 14));
	CHECK((PackedInt32Array().ptr() == nullptr));
	CHECK((PackedInt32Array(Array::make(5, 6))[1] == 6));
}

TEST_CASE("a Dictionary keeps the order of its keys, and inserts by []") {
	Dictionary counts;
	counts["b"] = 1;
	counts["a"] = 2;
	const Dictionary same = counts;
	CHECK((String(counts.keys()[0]) == "b"));
	CHECK((int64_t(same["a"]) == 2));
	CHECK((same["none"].get_type() == Variant::NIL && counts.size() == 2));
}
