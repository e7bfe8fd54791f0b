// SPDX-License-Identifier: MIT
// Unicode text, shared until changed.
#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/core/builtin_call.hpp>
#include <godot_cpp/variant/char_string.hpp>
#include <godot_cpp/variant/forward.hpp>

namespace godot {

class String : public internal::Opaque<GDEXTENSION_VARIANT_TYPE_STRING, 1> {
public:
	String() = default;
	String(const StringName &p_from);
	String(const NodePath &p_from);
	// C text: char is Latin-1, as in the engine; use utf8() for more.
	String(const char *p_text);
	String(const wchar_t *p_text);
	String(const char16_t *p_text);
	String(const char32_t *p_text);

	String(const Variant *) = delete; // private upstream

	static String utf8(const char *p_text, int64_t p_length = -1);
	Error parse_utf8(const char *p_text, int64_t p_length = -1);
	CharString utf8() const;

	const char32_t *ptr() const;
	char32_t *ptrw();
	const char32_t &operator[](int64_t p_index) const;
	char32_t &operator[](int64_t p_index);
	Error resize(int64_t p_size);

	bool operator==(const StringName &p_other) const;
	bool operator!=(const StringName &p_other) const;
	bool operator==(const char *p_other) const { return *this == String(p_other); }
	bool operator!=(const char *p_other) const { return !(*this == p_other); }
	String operator+(const char *p_other) { return *this + String(p_other); }
	String operator+(const StringName &p_other) const;
	String operator+(char32_t p_other);
	String &operator+=(const String &p_other);
	String &operator+=(const char *p_other);
	String &operator+=(char32_t p_other);
	// Fills %s, %d and so on from a value, or from the values of an Array.
	String operator%(const Variant &p_values) const;

	// Upstream's other overloads, which make calls ambiguous that would find one of the above.
	template <typename T> String operator%(const T &) const = delete;
	bool operator==(const Variant &) const = delete;
	bool operator!=(const Variant &) const = delete;
	bool operator==(const wchar_t *) const = delete;
	bool operator!=(const wchar_t *) const = delete;
	bool operator==(const char16_t *) const = delete;
	bool operator!=(const char16_t *) const = delete;
	bool operator==(const char32_t *) const = delete;
	bool operator!=(const char32_t *) const = delete;
	String operator+(const wchar_t *) = delete;
	String operator+(const char16_t *) = delete;
	String operator+(const char32_t *) = delete;
	String &operator+=(const wchar_t *) = delete;
	String &operator+=(const char32_t *) = delete;

#include <godot_cpp/variant/gen/string.inc>
};

inline String operator+(const char *p_a, const String &p_b) {
	return String(p_a) + p_b;
}
inline bool operator==(const char *p_a, const String &p_b) {
	return p_b == p_a;
}

bool operator==(const wchar_t *, const String &) = delete;
bool operator==(const char16_t *, const String &) = delete;
bool operator==(const char32_t *, const String &) = delete;
String operator+(const wchar_t *, const String &) = delete;
String operator+(const char16_t *, const String &) = delete;
String operator+(const char32_t *, const String &) = delete;

} // namespace godot
