// SPDX-License-Identifier: MIT
// A name: text kept once in the engine, compared by identity.
#pragma once

#include <godot_cpp/variant/string.hpp>

#include <functional>

namespace godot {

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
	bool operator==(const char *p_other) const { return *this == StringName(p_other); }
	bool operator!=(const char *p_other) const { return !(*this == p_other); }
	String operator+(const String &p_other) const { return String(*this) + p_other; }
	String operator+(const char *p_other) const { return String(*this) + p_other; }

	// The identity itself.
	const void *data_unique_pointer() const { return _storage[0]; }

#include <godot_cpp/variant/gen/string_name.inc>
};

inline bool operator==(const char *p_a, const StringName &p_b) {
	return p_b == p_a;
}
inline String operator+(const char *p_a, const StringName &p_b) {
	return String(p_a) + String(p_b);
}

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
	size_t operator()(const StringName &p_name) const { return std::hash<const void *>()(p_name.data_unique_pointer()); }
};

} // namespace internal

} // namespace godot
