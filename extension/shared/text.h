// SPDX-License-Identifier: MIT
// Texts of the core, which are UTF-8, as the engine's. A String of a `const char *` would read them as Latin-1 (tools/test/encodings.py).
#pragma once

#include "core/base/tunable.h"

#include <godot_cpp/variant/string.hpp>

#include <string>

namespace grass {

inline godot::String text_of(const std::string &p_text) {
	return godot::String::utf8(p_text.c_str(), int64_t(p_text.size()));
}

inline godot::String unit_of(const Tunable &p_tunable) {
	return godot::String::utf8(p_tunable.unit);
}

} // namespace grass
