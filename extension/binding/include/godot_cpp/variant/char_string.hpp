// SPDX-License-Identifier: MIT
// Zero-terminated text in one of the encodings of C.
#pragma once

#include <godot_cpp/core/defs.hpp>

#include <string>

namespace godot {

template <typename T> class CharStringT {
public:
	CharStringT() = default;
	static CharStringT _make(std::basic_string<T> p_text) {
		CharStringT made;
		made._text = std::move(p_text);
		return made;
	}

	const T *get_data() const { return _text.c_str(); }
	const T *ptr() const { return _text.c_str(); }
	T *ptrw() { return _text.data(); }
	int length() const { return static_cast<int>(_text.size()); }
	int size() const { return _text.empty() ? 0 : length() + 1; } // with the terminating zero
	const T &operator[](int p_index) const { return _text.c_str()[p_index]; }
	bool operator==(const CharStringT &p_other) const { return _text == p_other._text; }

private:
	std::basic_string<T> _text;
};

using CharString = CharStringT<char>;

} // namespace godot
