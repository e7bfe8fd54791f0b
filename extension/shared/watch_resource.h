// SPDX-License-Identifier: MIT
#pragma once

#include "shared/property_value.h"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/callable.hpp>

namespace grass {

// Replaces the value of a property of r_resource. If it was another, the resource emits `changed`.
template <typename T> void replace_in(godot::Resource &r_resource, T &r_held, const std::type_identity_t<T> &p_new) {
	if (replace(r_held, p_new)) {
		r_resource.emit_changed();
	}
}

// Replaces r_held by p_new, which may be null: from now on p_changed is called when p_new emits p_signal, and no longer for the old
// resource. Returns false if r_held was p_new already.
template <typename T>
[[nodiscard]] bool watch_instead(
		godot::Ref<T> &r_held, const godot::Ref<T> &p_new, const godot::Callable &p_changed, const char *p_signal = "changed") {
	const godot::Ref<T> before = r_held, now = p_new;
	if (!replace(r_held, now)) {
		return false;
	}
	if (before.is_valid()) {
		before.ptr()->disconnect(p_signal, p_changed);
	}
	if (now.is_valid()) {
		now.ptr()->connect(p_signal, p_changed);
	}
	return true;
}

} // namespace grass
