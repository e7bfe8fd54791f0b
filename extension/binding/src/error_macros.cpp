// SPDX-License-Identifier: MIT
#include <godot_cpp/core/error_macros.hpp>

#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/string.hpp>

#include <string>

namespace godot {

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error, const char *p_message,
		bool p_editor_notify, bool p_is_warning) {
	namespace engine = gdextension_interface;
	if (!p_message || !*p_message) {
		(p_is_warning ? engine::print_warning : engine::print_error)(p_error, p_function, p_file, p_line, p_editor_notify);
	} else {
		(p_is_warning ? engine::print_warning_with_message : engine::print_error_with_message)(
				p_error, p_message, p_function, p_file, p_line, p_editor_notify);
	}
}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error, const String &p_message,
		bool p_editor_notify, bool p_is_warning) {
	_err_print_error(p_function, p_file, p_line, p_error, p_message.utf8().get_data(), p_editor_notify, p_is_warning);
}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const String &p_error, const char *p_message,
		bool p_editor_notify, bool p_is_warning) {
	_err_print_error(p_function, p_file, p_line, p_error.utf8().get_data(), p_message, p_editor_notify, p_is_warning);
}

void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
		const char *p_index_text, const char *p_size_text, const char *p_message) {
	const std::string text = std::string("Index ") + p_index_text + " = " + std::to_string(p_index) + " is out of bounds (" + p_size_text +
			" = " + std::to_string(p_size) + ").";
	_err_print_error(p_function, p_file, p_line, text.c_str(), p_message);
}

void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
		const char *p_index_text, const char *p_size_text, const String &p_message) {
	_err_print_index_error(p_function, p_file, p_line, p_index, p_size, p_index_text, p_size_text, p_message.utf8().get_data());
}

void _err_flush_stdout() {
	fflush(stdout);
}

} // namespace godot
