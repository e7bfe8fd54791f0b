// SPDX-License-Identifier: MIT
// Lines in the engine's output.
#pragma once

#include <godot_cpp/variant/utility_functions.hpp>

namespace godot {

template <typename... Arguments> void print_line(const Variant &p_first, const Arguments &...p_more) {
	UtilityFunctions::print(p_first, p_more...);
}
template <typename... Arguments> void print_line_rich(const Variant &p_first, const Arguments &...p_more) {
	UtilityFunctions::print_rich(p_first, p_more...);
}
template <typename... Arguments> void print_error(const Variant &p_first, const Arguments &...p_more) {
	UtilityFunctions::printerr(p_first, p_more...);
}
template <typename... Arguments> void print_verbose(const Variant &p_first, const Arguments &...p_more) {
	UtilityFunctions::print_verbose(p_first, p_more...);
}

} // namespace godot
