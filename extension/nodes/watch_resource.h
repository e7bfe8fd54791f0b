// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/callable.hpp>

namespace grass {

// Puts p_new, which may be null, into r_held: from now on p_changed runs when p_new emits p_signal, and no longer when the old one does.
template <typename T>
void watch_instead(godot::Ref<T> &r_held, const godot::Ref<T> &p_new, const godot::Callable &p_changed, const char *p_signal = "changed") {
	if (r_held.is_valid()) {
		r_held->disconnect(p_signal, p_changed);
	}
	r_held = p_new;
	if (r_held.is_valid()) {
		r_held->connect(p_signal, p_changed);
	}
}

} // namespace grass
