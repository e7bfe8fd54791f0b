// SPDX-License-Identifier: MIT
// Templates, each made for one type, and the macros, each used once.
#include "surface.h"

#include <godot_cpp/classes/editor_plugin.hpp>
#include <godot_cpp/classes/editor_plugin_registration.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/core/class_db.hpp>

using namespace godot;

TYPE(real_t, float)
TYPE(GodotObject, void)

class SurfaceNode;

// classes/ref.hpp
using ImageRef = Ref<Image>;
CONSTRUCTOR(Ref<Image>)
CONSTRUCTOR(Ref<Image>, Ref<Image>)
CONSTRUCTOR(Ref<Image>, Image *)
CONSTRUCTOR(Ref<Image>, const Variant &)
static_assert(std::is_constructible_v<Ref<Image>, const Ref<Resource> &>);
// By their use: the template would do for a lost overload.
CALL(Ref, operator=, void, a<Ref<Image>>() = a<const Ref<Image>>())
CALL(Ref, operator=, void, a<Ref<Image>>() = Ref<Image>())
CALL(Ref, operator=, void, a<Ref<Image>>() = a<Image *>())
CALL(Ref, operator=, void, a<Ref<Image>>() = a<Variant>())
CALL(Ref, operator=, void, a<Ref<Image>>() = a<Ref<Resource>>())
METHOD(ImageRef, ptr, Image *() const)
METHOD(ImageRef, operator->, Image *() const)
METHOD(ImageRef, operator*, Image *() const)
METHOD(ImageRef, is_valid, bool() const)
METHOD(ImageRef, is_null, bool() const)
METHOD(ImageRef, operator==, bool(const Image *) const)
METHOD(ImageRef, operator==, bool(const Ref<Image> &) const)
METHOD(ImageRef, operator!=, bool(const Image *) const)
METHOD(ImageRef, operator!=, bool(const Ref<Image> &) const)
METHOD(ImageRef, operator<, bool(const Ref<Image> &) const)
METHOD(ImageRef, operator Variant, Variant() const)
METHOD(ImageRef, unref, void())
CALL(Ref, instantiate, void, a<Ref<Image>>().instantiate())
STATIC(ImageRef, get_class_static, String())

// variant/typed_array.hpp
using Plans = TypedArray<Dictionary>;
CONSTRUCTOR(TypedArray<Dictionary>)
CONSTRUCTOR(TypedArray<Dictionary>, const Array &)
CONSTRUCTOR(TypedArray<Dictionary>, const Variant &)
CONSTRUCTOR(TypedArray<Dictionary>, std::initializer_list<Variant>)
METHOD(Plans, operator=, void(const Array &))

// templates/list.hpp
using Numbers = List<int>;
METHOD(Numbers, clear, void())
METHOD(Numbers, size, int() const)
METHOD(Numbers, is_empty, bool() const)
EXPLICIT_CONSTRUCTOR(List<int>)
USE(List, push_back, a<List<int>>().push_back(0)) // upstream returns the element
CALL(List, begin, int &, *a<List<int>>().begin())
CALL(List, begin, const int &, *a<const List<int>>().begin())
CALL(List, end, bool, a<List<int>>().begin() != a<List<int>>().end())
CALL(List, end, bool, a<const List<int>>().begin() != a<const List<int>>().end())

// templates/local_vector.hpp
using Row = LocalVector<int>;
CONSTRUCTOR(LocalVector<int>, std::initializer_list<int>)
EXPLICIT_CONSTRUCTOR(LocalVector<int>)
METHOD(Row, push_back, void(int))
METHOD(Row, resize, void(uint32_t))
METHOD(Row, reserve, void(uint32_t))
METHOD(Row, clear, void())
METHOD(Row, size, uint32_t() const)
METHOD(Row, is_empty, bool() const)
METHOD(Row, ptr, int *())
METHOD(Row, ptr, const int *() const)
METHOD(Row, operator[], int &(uint32_t))
METHOD(Row, operator[], const int &(uint32_t) const)
CALL(LocalVector, begin, int &, *a<LocalVector<int>>().begin())
CALL(LocalVector, begin, const int &, *a<const LocalVector<int>>().begin())
CALL(LocalVector, end, bool, a<LocalVector<int>>().begin() != a<LocalVector<int>>().end())
CALL(LocalVector, end, bool, a<const LocalVector<int>>().begin() != a<const LocalVector<int>>().end())

// variant/char_string.hpp
using Text = CharStringT<char>;
CONSTRUCTOR(CharStringT<char>)
METHOD(Text, get_data, const char *() const)
METHOD(Text, ptr, const char *() const)
METHOD(Text, ptrw, char *())
METHOD(Text, length, int() const)
METHOD(Text, size, int() const)
METHOD(Text, operator[], const char &(int) const)
METHOD(Text, operator==, bool(const CharString &) const)
TYPE(CharString, CharStringT<char>)

// core/type_info.hpp
using Flags = BitField<PropertyUsageFlags>;
CONSTRUCTOR(BitField<PropertyUsageFlags>, int64_t)
METHOD(Flags, has_flag, bool(PropertyUsageFlags) const)
METHOD(Flags, operator int64_t, int64_t() const)
METHOD(Flags, operator Variant, Variant() const)

// Function templates.
CALL(EditorPlugins, add_by_type, void, EditorPlugins::add_by_type<EditorPlugin>())
CALL(ClassDB, register_class, void, ClassDB::register_class<SurfaceNode>())
CALL(ClassDB, register_internal_class, void, ClassDB::register_internal_class<SurfaceNode>())
CALL(, MIN, float, MIN(1.0f, 2.0f))
CALL(, MAX, float, MAX(1.0f, 2.0f))
CALL(, CLAMP, float, CLAMP(1.0f, 2.0f, 3.0f))
CALL(, SIGN, float, SIGN(1.0f))
CALL(, vformat, String, vformat(String(), 1, String()))
CALL(, memdelete, void, memdelete(a<Object *>()))
CALL(Array, make, Array, Array::make(1, String()))
CALL(Array, begin, Variant &, *a<Array>().begin())
CALL(Array, begin, const Variant &, *a<const Array>().begin())
CALL(Array, end, bool, a<Array>().begin() != a<Array>().end())
CALL(Array, end, bool, a<const Array>().begin() != a<const Array>().end())
CALL(Variant, call, Variant, a<Variant>().call(StringName(), 1, String()))
CALL(Object, cast_to, Image *, Object::cast_to<Image>(a<Object *>()))
CALL(Object, cast_to, const Image *, Object::cast_to<Image>(a<const Object *>()))
CALL(Node, get_node, Node3D *, a<Node>().get_node<Node3D>(NodePath()))
CALL(MethodInfo, MethodInfo, MethodInfo, MethodInfo(StringName(), PropertyInfo(), PropertyInfo()))
CALL(MethodInfo, MethodInfo, MethodInfo, MethodInfo(Variant::INT, StringName(), PropertyInfo()))
CALL(MethodInfo, MethodInfo, MethodInfo, MethodInfo(PropertyInfo(), StringName(), PropertyInfo()))
CALL(, D_METHOD, MethodDefinition, D_METHOD("name", "first", "second"))
USE(ClassDB, bind_method, ClassDB::bind_method(D_METHOD("name"), &Image::get_width, 1)) // upstream returns the method
USE(ClassDB, bind_method, ClassDB::bind_method("name", &Image::get_width))
USE(ClassDB, bind_static_method, ClassDB::bind_static_method("Image", D_METHOD("name"), &Image::create_empty)) // likewise

// A class of our own, with all that GDCLASS and the registration offer.
class SurfaceNode : public RefCounted {
	GDCLASS(SurfaceNode, RefCounted)

public:
	int get_number() const { return 0; }
	void set_number(int) {}
	double get_share(int) const { return 0; }
	void set_share(int, double) {}
	enum Kind : int64_t { KIND_ONE };
	void set_kind(Kind) {}

protected:
	static void _bind_methods();
	void _notification(int) {}
};
VARIANT_ENUM_CAST(SurfaceNode::Kind);
enum SurfaceFlags : int64_t { SURFACE_FLAG = 1 };
VARIANT_BITFIELD_CAST(SurfaceFlags);

void SurfaceNode::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_number", "number"), &SurfaceNode::set_number, DEFVAL(1));
	ClassDB::bind_method(D_METHOD("get_number"), &SurfaceNode::get_number);
	ADD_GROUP("Group", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "number"), "set_number", "get_number");
	ADD_PROPERTYI(PropertyInfo(Variant::INT, "share"), "set_share", "get_share", 1);
	ADD_SIGNAL(MethodInfo("changed"));
	BIND_ENUM_CONSTANT(KIND_ONE);
}

// Each macro once, in the place it is meant for.
void leave(int p_number, Object *p_object) {
	ERR_FAIL_COND_MSG(p_number == 1, String());
	ERR_FAIL_NULL_MSG(p_object, "text");
	ERR_FAIL_INDEX(p_number, 3);
	ERR_FAIL_INDEX_MSG(p_number, 3, "text");
	CRASH_COND(p_number == 1);
	CRASH_COND_MSG(p_number == 1, "text");
	CRASH_BAD_INDEX(p_number, 3);
	DEV_ASSERT(p_number != 1);
	ERR_PRINT("text");
	ERR_PRINT_ED("text");
	WARN_PRINT(String());
	WARN_PRINT_ED("text");
	WARN_PRINT_ONCE("text");
	ERR_PRINT_ONCE("text");
	if (likely(p_number == 2) && unlikely(p_number == 3)) {
		GENERATE_TRAP();
	}
	ERR_FAIL_MSG("text");
}

int leave_with(int p_number, Object *p_object) {
	ERR_FAIL_COND_V(p_number == 1, 0);
	ERR_FAIL_COND_V_MSG(p_number == 1, 0, "text");
	ERR_FAIL_NULL_V(p_object, 0);
	ERR_FAIL_NULL_V_MSG(p_object, 0, "text");
	ERR_FAIL_INDEX_V(p_number, 3, 0);
	ERR_FAIL_INDEX_V_MSG(p_number, 3, 0, "text");
	return 0;
}

GDE_EXPORT _ALWAYS_INLINE_ Callable make(SurfaceNode *p_node) {
	return callable_mp(p_node ? p_node : memnew(SurfaceNode), &SurfaceNode::get_number);
}
Callable make_static() {
	return callable_mp_static(&leave_with);
}
_NO_INLINE_ void register_all() {
	GDREGISTER_CLASS(SurfaceNode);
	GDREGISTER_INTERNAL_CLASS(SurfaceNode);
	ClassDB::register_class<SurfaceNode>();
	ClassDB::register_internal_class<SurfaceNode>();
	make(nullptr);
	make_static();
}
