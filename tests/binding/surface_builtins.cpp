// SPDX-License-Identifier: MIT
// Text, names, lists and what else the engine keeps for us.
#include "surface.h"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

// variant/string.hpp
CONSTRUCTOR(String)
CONSTRUCTOR(String, const StringName &)
CONSTRUCTOR(String, const NodePath &)
CONSTRUCTOR(String, const char *)
CONSTRUCTOR(String, const wchar_t *)
CONSTRUCTOR(String, const char16_t *)
CONSTRUCTOR(String, const char32_t *)
STATIC(String, utf8, String(const char *, int64_t))
METHOD(String, parse_utf8, Error(const char *, int64_t))
METHOD(String, utf8, CharStringT<char>() const)
METHOD(String, ptr, const char32_t *() const)
METHOD(String, ptrw, char32_t *())
METHOD(String, operator[], const char32_t &(int64_t) const)
METHOD(String, operator[], char32_t &(int64_t))
METHOD(String, resize, Error(int64_t))
METHOD(String, operator==, bool(const StringName &) const)
METHOD(String, operator!=, bool(const StringName &) const)
METHOD(String, operator==, bool(const char *) const)
METHOD(String, operator!=, bool(const char *) const)
METHOD(String, operator+, String(const char *))
METHOD(String, operator+, String(const StringName &) const)
METHOD(String, operator+, String(char32_t))
METHOD(String, operator+=, String &(const String &))
METHOD(String, operator+=, String &(const char *))
METHOD(String, operator+=, String &(char32_t))
METHOD(String, operator%, String(const Variant &) const)
FUNCTION(operator+, String(const char *, const String &))
FUNCTION(operator==, bool(const char *, const String &))

// variant/string_name.hpp
CONSTRUCTOR(StringName)
CONSTRUCTOR(StringName, const String &)
CONSTRUCTOR(StringName, const char *, bool)
CONSTRUCTOR(StringName, const char *)
CONSTRUCTOR(StringName, const char32_t *)
METHOD(StringName, operator==, bool(const StringName &) const)
METHOD(StringName, operator!=, bool(const StringName &) const)
METHOD(StringName, operator<, bool(const StringName &) const)
METHOD(StringName, operator==, bool(const String &) const)
METHOD(StringName, operator!=, bool(const String &) const)
METHOD(StringName, operator+, String(const String &) const)
CONSTRUCTOR(String, const StringName &)
METHOD(String, operator==, bool(const StringName &) const)
METHOD(String, operator!=, bool(const StringName &) const)
METHOD(String, operator+, String(const StringName &) const)

// variant/node_path.hpp
CONSTRUCTOR(NodePath)
CONSTRUCTOR(NodePath, const String &)
CONSTRUCTOR(NodePath, const char *)
CONSTRUCTOR(String, const NodePath &)

// variant/rid.hpp
CONSTRUCTOR(RID)
METHOD(RID, get_id, int64_t() const)
METHOD(RID, is_valid, bool() const)
METHOD(RID, operator==, bool(const RID &) const)
METHOD(RID, operator!=, bool(const RID &) const)
METHOD(RID, operator<, bool(const RID &) const)

// variant/callable.hpp
CONSTRUCTOR(Callable)
CONSTRUCTOR(Callable, Object *, const StringName &)

// variant/signal.hpp
CONSTRUCTOR(Signal)
CONSTRUCTOR(Signal, Object *, const StringName &)

// variant/array.hpp
CONSTRUCTOR(Array)
CONSTRUCTOR(Array, std::initializer_list<Variant>)
CONSTRUCTOR(Array, const Array &, int64_t, const StringName &, const Variant &)
CONSTRUCTOR(Array, const PackedByteArray &)
CONSTRUCTOR(Array, const PackedInt32Array &)
CONSTRUCTOR(Array, const PackedInt64Array &)
CONSTRUCTOR(Array, const PackedFloat32Array &)
CONSTRUCTOR(Array, const PackedFloat64Array &)
CONSTRUCTOR(Array, const PackedStringArray &)
CONSTRUCTOR(Array, const PackedVector2Array &)
CONSTRUCTOR(Array, const PackedVector3Array &)
CONSTRUCTOR(Array, const PackedColorArray &)
CONSTRUCTOR(Array, const PackedVector4Array &)
METHOD(Array, operator[], Variant &(int64_t))
METHOD(Array, operator[], const Variant &(int64_t) const)
METHOD(Array, set_typed, void(uint32_t, const StringName &, const Variant &))

// variant/dictionary.hpp
CONSTRUCTOR(Dictionary)
METHOD(Dictionary, operator[], Variant &(const Variant &))
METHOD(Dictionary, operator[], const Variant &(const Variant &) const)
