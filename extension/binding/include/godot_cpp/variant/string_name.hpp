// SPDX-License-Identifier: MIT
// A name: text kept once in the engine, compared by identity.
#pragma once

#include <godot_cpp/variant/string.hpp>

#include <functional>

namespace godot {

namespace internal {

struct StringNameHash;

} // namespace internal

class StringName : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_STRING_NAME, 1> {
public:
	StringName() = default;
	StringName(const String &p_from) : Opaque(2, &p_from) {}
	// Latin-1. p_static: the text outlives the program, so the engine need not copy it.
	StringName(const char *p_text, bool p_static = false);
	StringName(const char32_t *p_text) : StringName(String(p_text)) {}

	bool operator==(const StringName &p_other) const { return _storage[0] == p_other._storage[0]; }
	bool operator!=(const StringName &p_other) const { return _storage[0] != p_other._storage[0]; }
	// By identity: an order for containers, not the alphabet's.
	bool operator<(const StringName &p_other) const { return std::less<>()(_storage[0], p_other._storage[0]); }
	bool operator==(const String &p_other) const { return *this == StringName(p_other); }
	bool operator!=(const String &p_other) const { return !(*this == p_other); }
	String operator+(const String &p_other) const { return String(*this) + p_other; }

	// Upstream's other overloads, which make calls ambiguous that would find one of the above.
	StringName(const Variant *) = delete;
	StringName(const wchar_t *) = delete;
	StringName(const char16_t *) = delete;
	bool operator==(const Variant &) const = delete;
	bool operator!=(const Variant &) const = delete;
	String operator+(const StringName &) const = delete;

#include <godot_cpp/variant/gen/string_name.inc>

private:
	friend struct internal::StringNameHash;
};

inline String::String(const StringName &p_from) : Opaque(2, &p_from) {}
inline bool String::operator==(const StringName &p_other) const {
	return *this == String(p_other);
}
inline bool String::operator!=(const StringName &p_other) const {
	return !(*this == p_other);
}
inline String String::operator+(const StringName &p_other) const {
	return *this + String(p_other);
}

namespace internal {

struct StringNameHash {
	size_t operator()(const StringName &p_name) const { return std::hash<const void *>()(p_name._storage[0]); }
};

} // namespace internal

} // namespace godot
