// SPDX-License-Identifier: MIT
// Decides which thread may call. A field's ticks and frames read, on the main thread, what its methods change. Like the engine's own nodes,
// a field in the tree rejects calls from other threads; so does a resource that a field uses.
#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/string.hpp>

namespace grass {

bool is_main_thread();

// Returns whether nothing else can read p_resource during a change: this is the main thread, or no node in the tree uses it.
bool may_change(const godot::Resource &p_resource);

// Returns the error message "p_owner: p_what belongs to the main thread...".
godot::String thread_message(const godot::String &p_owner, const godot::String &p_what);
inline godot::String call_of(const char *p_function) {
	return godot::String(p_function) + "()";
}

} // namespace grass

// Put this first in a method of a node with label(): on another thread, while the node is in the tree, it prints an error and returns
// m_return.
#define GRASS_MAIN_THREAD_ONLY_V(m_return)                                                                                                 \
	ERR_FAIL_COND_V_MSG(is_inside_tree() && !grass::is_main_thread(), m_return, grass::thread_message(label(), grass::call_of(__func__)))
#define GRASS_MAIN_THREAD_ONLY()                                                                                                           \
	ERR_FAIL_COND_MSG(is_inside_tree() && !grass::is_main_thread(), grass::thread_message(label(), grass::call_of(__func__)))

// Does the same for a method of a resource, while a node in the tree uses it. m_label: label of the resource.
#define GRASS_CHANGE_GUARD(m_label) ERR_FAIL_COND_MSG(!grass::may_change(*this), grass::thread_message(m_label, grass::call_of(__func__)))

// Put this first in a method of an object that a signal may call on any thread: on another one it returns, and has the main thread call the
// method with these arguments later.
#define GRASS_LATER_ON_MAIN_THREAD(m_method, ...)                                                                                          \
	if (!grass::is_main_thread()) {                                                                                                        \
		callable_mp(this, m_method).call_deferred(__VA_ARGS__);                                                                            \
		return;                                                                                                                            \
	} else                                                                                                                                 \
		((void)0)
