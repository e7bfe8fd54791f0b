// SPDX-License-Identifier: MIT
#include <godot_cpp/variant/variant.hpp>

namespace godot {

namespace engine = gdextension_interface;

// The C interface makes new text in raw storage.
String::String(const char *p_text) : Opaque(UNINITIALIZED) {
	engine::string_new_with_latin1_chars(_storage, p_text);
}
String::String(const wchar_t *p_text) : Opaque(UNINITIALIZED) {
	engine::string_new_with_wide_chars(_storage, p_text);
}
String::String(const char16_t *p_text) : Opaque(UNINITIALIZED) {
	engine::string_new_with_utf16_chars(_storage, p_text);
}
String::String(const char32_t *p_text) : Opaque(UNINITIALIZED) {
	engine::string_new_with_utf32_chars(_storage, p_text);
}

String String::utf8(const char *p_text, int64_t p_length) {
	String text;
	text.parse_utf8(p_text, p_length);
	return text;
}

Error String::parse_utf8(const char *p_text, int64_t p_length) {
	internal::builtin_types[GDEXTENSION_VARIANT_TYPE_STRING].destructor(_storage);
	return static_cast<Error>(engine::string_new_with_utf8_chars_and_len2(_storage, p_text, p_length));
}

CharString String::utf8() const {
	const GDExtensionInt length = engine::string_to_utf8_chars(_storage, nullptr, 0);
	std::string text(length, '\0');
	engine::string_to_utf8_chars(_storage, text.data(), length);
	return CharString::_make(std::move(text));
}

const char32_t *String::ptr() const {
	return is_empty() ? nullptr : &(*this)[0];
}
char32_t *String::ptrw() {
	return is_empty() ? nullptr : &(*this)[0];
}
const char32_t &String::operator[](int64_t p_index) const {
	return *engine::string_operator_index_const(_storage, p_index);
}
char32_t &String::operator[](int64_t p_index) {
	return *engine::string_operator_index(_storage, p_index);
}
Error String::resize(int64_t p_size) {
	return static_cast<Error>(engine::string_resize(_storage, p_size));
}

String String::operator+(char32_t p_other) {
	String text = *this;
	return text += p_other;
}
String &String::operator+=(const String &p_other) {
	engine::string_operator_plus_eq_string(_storage, p_other._storage);
	return *this;
}
String &String::operator+=(const char *p_other) {
	engine::string_operator_plus_eq_cstr(_storage, p_other);
	return *this;
}
String &String::operator+=(char32_t p_other) {
	engine::string_operator_plus_eq_char(_storage, p_other);
	return *this;
}

String String::operator%(const Variant &p_values) const {
	Variant result;
	bool valid = false;
	Variant::evaluate(Variant::OP_MODULE, *this, p_values, result, valid);
	return result;
}

StringName::StringName(const char *p_text, bool p_static) : Opaque(UNINITIALIZED) {
	engine::string_name_new_with_latin1_chars(_storage, p_text, p_static);
}

} // namespace godot
