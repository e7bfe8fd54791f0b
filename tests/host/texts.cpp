// SPDX-License-Identifier: MIT
// Text and names.
#include "host.h"

#include <set>

namespace host {

Name make_name(const std::string &p_text) {
	static std::set<std::string> names;
	return p_text.empty() ? nullptr : &*names.insert(p_text).first;
}

std::string name_text(GDExtensionConstStringNamePtr p_name) {
	const Name name = p_name ? *static_cast<const Name *>(p_name) : nullptr;
	return name ? *name : "";
}

Text make_text(std::u32string p_text) {
	return p_text.empty() ? nullptr : new std::u32string(std::move(p_text));
}

std::string string_text(GDExtensionConstStringPtr p_string) {
	return p_string ? utf8(*static_cast<const Text *>(p_string)) : "";
}

std::string utf8(Text p_text) {
	std::string text;
	for (const char32_t c : p_text ? *p_text : std::u32string()) {
		if (c < 0x80) {
			text += char(c);
		} else if (c < 0x800) {
			text += { char(0xc0 | (c >> 6)), char(0x80 | (c & 0x3f)) };
		} else if (c < 0x10000) {
			text += { char(0xe0 | (c >> 12)), char(0x80 | ((c >> 6) & 0x3f)), char(0x80 | (c & 0x3f)) };
		} else {
			text += { char(0xf0 | (c >> 18)), char(0x80 | ((c >> 12) & 0x3f)), char(0x80 | ((c >> 6) & 0x3f)), char(0x80 | (c & 0x3f)) };
		}
	}
	return text;
}

std::u32string utf32(const std::string &p_text) {
	std::u32string text;
	for (size_t i = 0; i < p_text.size(); i++) {
		const unsigned char c = static_cast<unsigned char>(p_text[i]);
		if ((c & 0xc0) == 0x80) { // goes on with what is before it
			text.back() = (text.back() << 6) | (c & 0x3f);
		} else {
			text += c < 0x80 ? c : (c < 0xe0 ? c & 0x1f : (c < 0xf0 ? c & 0x0f : c & 0x07));
		}
	}
	return text;
}

namespace {

std::u32string latin1(const char *p_text) {
	std::u32string text;
	for (; *p_text; p_text++) {
		text += static_cast<unsigned char>(*p_text);
	}
	return text;
}

void set(GDExtensionUninitializedStringPtr r_new, std::u32string p_text) {
	*static_cast<Text *>(r_new) = make_text(std::move(p_text));
}

template <class T> GDExtensionInt write(const std::basic_string<T> &p_text, T *r_text, GDExtensionInt p_most) {
	for (size_t i = 0; r_text && i < p_text.size() && GDExtensionInt(i) < p_most; i++) {
		r_text[i] = p_text[i];
	}
	return GDExtensionInt(p_text.size());
}

void add(GDExtensionStringPtr r_text, const std::u32string &p_more) {
	const Text text = *static_cast<Text *>(r_text);
	set(r_text, (text ? *text : std::u32string()) + p_more);
}

} // namespace

void offer_texts(Functions &r_functions) {
	offer(
			r_functions, "string_new_with_latin1_chars",
			+[](GDExtensionUninitializedStringPtr r_new, const char *p_text) { set(r_new, latin1(p_text)); });
	offer(
			r_functions, "string_new_with_utf8_chars",
			+[](GDExtensionUninitializedStringPtr r_new, const char *p_text) { set(r_new, utf32(p_text)); });
	offer(
			r_functions, "string_new_with_utf8_chars_and_len2",
			+[](GDExtensionUninitializedStringPtr r_new, const char *p_text, GDExtensionInt p_size) {
				set(r_new, utf32(p_size < 0 ? std::string(p_text) : std::string(p_text, size_t(p_size))));
				return GDExtensionInt(0);
			});
	offer(
			r_functions, "string_new_with_utf32_chars",
			+[](GDExtensionUninitializedStringPtr r_new, const char32_t *p_text) { set(r_new, p_text); });
	offer(
			r_functions, "string_to_utf8_chars", +[](GDExtensionConstStringPtr p_text, char *r_text, GDExtensionInt p_most) {
				return write(string_text(p_text), r_text, p_most);
			});
	offer(
			r_functions, "string_operator_index_const", +[](GDExtensionConstStringPtr p_text, GDExtensionInt p_index) {
				return &(**static_cast<const Text *>(p_text))[size_t(p_index)];
			});
	offer(
			r_functions, "string_operator_plus_eq_string", +[](GDExtensionStringPtr r_text, GDExtensionConstStringPtr p_more) {
				const Text more = *static_cast<const Text *>(p_more);
				add(r_text, more ? *more : std::u32string());
			});
	offer(
			r_functions, "string_operator_plus_eq_cstr",
			+[](GDExtensionStringPtr r_text, const char *p_more) { add(r_text, latin1(p_more)); });
	offer(
			r_functions, "string_operator_plus_eq_char",
			+[](GDExtensionStringPtr r_text, char32_t p_more) { add(r_text, std::u32string(1, p_more)); });
	offer(
			r_functions, "string_name_new_with_latin1_chars",
			+[](GDExtensionUninitializedStringNamePtr r_new, const char *p_text, GDExtensionBool) {
				*static_cast<Name *>(r_new) = make_name(p_text);
			});
}

} // namespace host
