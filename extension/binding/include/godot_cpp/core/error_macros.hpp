// SPDX-License-Identifier: MIT
// Errors and warnings in the engine's log, and early returns that report why.
#pragma once

#include <godot_cpp/core/defs.hpp>

#include <atomic>

namespace godot {

class String;

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error, const char *p_message = "",
		bool p_editor_notify = false, bool p_is_warning = false);
void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error, const String &p_message,
		bool p_editor_notify = false, bool p_is_warning = false);
void _err_print_error(const char *p_function, const char *p_file, int p_line, const String &p_error, const char *p_message = "",
		bool p_editor_notify = false, bool p_is_warning = false);
void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
		const char *p_index_text, const char *p_size_text, const String &p_message);
void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
		const char *p_index_text, const char *p_size_text, const char *p_message = "");
void _err_flush_stdout();

} // namespace godot

#define GENERATE_TRAP() __builtin_trap()

// What all of the macros below come down to: report and leave if the condition holds.
#define _GODOT_LEAVE_IF(m_condition, m_text, m_message, m_editor, m_leave)                                                                 \
	if (unlikely(m_condition)) {                                                                                                           \
		::godot::_err_print_error(__FUNCTION__, __FILE__, __LINE__, m_text, m_message, m_editor);                                          \
		m_leave;                                                                                                                           \
	} else                                                                                                                                 \
		((void)0)
#define _GODOT_LEAVE_IF_INDEX(m_index, m_size, m_message, m_leave)                                                                         \
	if (unlikely(static_cast<int64_t>(m_index) < 0 || static_cast<int64_t>(m_index) >= static_cast<int64_t>(m_size))) {                    \
		::godot::_err_print_index_error(__FUNCTION__, __FILE__, __LINE__, static_cast<int64_t>(m_index), static_cast<int64_t>(m_size),     \
				#m_index, #m_size, m_message);                                                                                             \
		m_leave;                                                                                                                           \
	} else                                                                                                                                 \
		((void)0)

#define ERR_FAIL_COND_MSG(m_condition, m_message)                                                                                          \
	_GODOT_LEAVE_IF(m_condition, "Condition \"" #m_condition "\" is true.", m_message, false, return )
#define ERR_FAIL_COND_V(m_condition, m_value)                                                                                              \
	_GODOT_LEAVE_IF(m_condition, "Condition \"" #m_condition "\" is true. Returning: " #m_value, "", false, return m_value)
#define ERR_FAIL_COND_V_MSG(m_condition, m_value, m_message)                                                                               \
	_GODOT_LEAVE_IF(m_condition, "Condition \"" #m_condition "\" is true. Returning: " #m_value, m_message, false, return m_value)

#define ERR_FAIL_NULL_MSG(m_pointer, m_message)                                                                                            \
	_GODOT_LEAVE_IF((m_pointer) == nullptr, "Parameter \"" #m_pointer "\" is null.", m_message, false, return )
#define ERR_FAIL_NULL_V(m_pointer, m_value)                                                                                                \
	_GODOT_LEAVE_IF((m_pointer) == nullptr, "Parameter \"" #m_pointer "\" is null.", "", false, return m_value)
#define ERR_FAIL_NULL_V_MSG(m_pointer, m_value, m_message)                                                                                 \
	_GODOT_LEAVE_IF((m_pointer) == nullptr, "Parameter \"" #m_pointer "\" is null.", m_message, false, return m_value)

#define ERR_FAIL_INDEX(m_index, m_size) _GODOT_LEAVE_IF_INDEX(m_index, m_size, "", return )
#define ERR_FAIL_INDEX_MSG(m_index, m_size, m_message) _GODOT_LEAVE_IF_INDEX(m_index, m_size, m_message, return )
#define ERR_FAIL_INDEX_V(m_index, m_size, m_value) _GODOT_LEAVE_IF_INDEX(m_index, m_size, "", return m_value)
#define ERR_FAIL_INDEX_V_MSG(m_index, m_size, m_value, m_message) _GODOT_LEAVE_IF_INDEX(m_index, m_size, m_message, return m_value)

#define ERR_FAIL_MSG(m_message) _GODOT_LEAVE_IF(true, "Method/function failed.", m_message, false, return )

#define CRASH_COND(m_condition) _GODOT_LEAVE_IF(m_condition, "FATAL: Condition \"" #m_condition "\" is true.", "", false, GENERATE_TRAP())
#define CRASH_COND_MSG(m_condition, m_message)                                                                                             \
	_GODOT_LEAVE_IF(m_condition, "FATAL: Condition \"" #m_condition "\" is true.", m_message, false, GENERATE_TRAP())
#define CRASH_BAD_INDEX(m_index, m_size) _GODOT_LEAVE_IF_INDEX(m_index, m_size, "", GENERATE_TRAP())

#define ERR_PRINT(m_message) ::godot::_err_print_error(__FUNCTION__, __FILE__, __LINE__, m_message)
#define ERR_PRINT_ED(m_message) ::godot::_err_print_error(__FUNCTION__, __FILE__, __LINE__, m_message, "", true)
#define WARN_PRINT(m_message) ::godot::_err_print_error(__FUNCTION__, __FILE__, __LINE__, m_message, "", false, true)
#define WARN_PRINT_ED(m_message) ::godot::_err_print_error(__FUNCTION__, __FILE__, __LINE__, m_message, "", true, true)

#define _GODOT_ONCE(m_statement)                                                                                                           \
	if (true) {                                                                                                                            \
		static std::atomic<bool> said{ false };                                                                                            \
		if (!said.exchange(true)) {                                                                                                        \
			m_statement;                                                                                                                   \
		}                                                                                                                                  \
	} else                                                                                                                                 \
		((void)0)
#define ERR_PRINT_ONCE(m_message) _GODOT_ONCE(ERR_PRINT(m_message))
#define WARN_PRINT_ONCE(m_message) _GODOT_ONCE(WARN_PRINT(m_message))

#ifdef DEV_ENABLED
#define DEV_ASSERT(m_condition) CRASH_COND_MSG(!(m_condition), "DEV_ASSERT failed.")
#else
#define DEV_ASSERT(m_condition) ((void)0)
#endif
