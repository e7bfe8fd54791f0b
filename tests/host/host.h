// SPDX-License-Identifier: MIT
// A host that speaks the C interface of GDExtension far enough to initialise the library, and to hear what it registers. It is no engine:
// calls of engine methods do nothing and answer nothing, and a value is never freed (the program lives for a second). Built with
// `precision=double`, its vectors are as large as those of an engine that is built so.
#pragma once

#include <gdextension_interface.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace host {

#ifdef REAL_T_IS_DOUBLE
using real_t = double;
#else
using real_t = float;
#endif

// The interface's functions by name, as the host's parts offer them.
using Functions = std::map<std::string, GDExtensionInterfaceFunctionPtr>;
template <class Function> void offer(Functions &r_functions, const char *p_name, Function p_function) {
	r_functions[p_name] = reinterpret_cast<GDExtensionInterfaceFunctionPtr>(p_function);
}
void offer_values(Functions &r_functions);
void offer_lists(Functions &r_functions);
void offer_texts(Functions &r_functions);
void offer_objects(Functions &r_functions);
void offer_registry(Functions &r_functions);

// Ends the program: the library needs what this host does not have.
[[noreturn]] void lack(const std::string &p_what);

// Values. Each type's storage is as large as the engine's and is copied byte by byte: text and lists are pointers to what is never changed
// once it is made.
constexpr int TYPES = GDEXTENSION_VARIANT_TYPE_VARIANT_MAX;
extern const size_t TYPE_SIZES[TYPES];
extern const char *const TYPE_NAMES[TYPES];
struct Variant {
	int32_t type;
	int32_t unused;
	uint8_t bytes[4 * sizeof(real_t)]; // the value, or a pointer to it where it is larger
};
static_assert(sizeof(Variant) == 8 + 4 * sizeof(real_t));
const void *value_of(const Variant &p_variant);
void set_value(Variant &r_variant, int p_type, const void *p_value);
std::string print(const Variant &p_variant); // the same on every platform

// Text: a pointer to a string, null for none. A name: the same, but one pointer for each text.
using Text = const std::u32string *;
using Name = const std::string *;
Name make_name(const std::string &p_text);
std::string name_text(GDExtensionConstStringNamePtr p_name);
std::string utf8(Text p_text);
std::u32string utf32(const std::string &p_text);
Text make_text(std::u32string p_text);
std::string string_text(GDExtensionConstStringPtr p_string);

struct Vector3 {
	real_t x, y, z;
};
// A list of vectors: a pointer to them, null for none.
using Vectors = std::vector<Vector3> *;

// Objects. The engine would answer where a node is.
struct Transform3D {
	Vector3 rows[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
	Vector3 origin = {};
};
struct Object {
	Name class_name = nullptr;
	void *instance = nullptr; // the library's, of a class of its own
	void *binding = nullptr;
	GDExtensionInstanceBindingCallbacks callbacks = {};
	int references = 1;
	const Transform3D *place = nullptr; // of a node that is in a scene
};
Object *construct(Name p_class);

// What the library registers, line by line.
void print_registry();
bool is_registry_empty(); // whether all classes are gone again
bool construct_registered(Name p_class, Object *&r_object); // false: the class is not the library's
const GDExtensionClassMethodInfo *find_registered(const std::string &p_class, const std::string &p_method); // null: there is none

// Calls what the library registers with vectors far from the origin, and prints what does not come out as near it.
int check_far();

} // namespace host
