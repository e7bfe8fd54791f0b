// SPDX-License-Identifier: MIT
// How setters and getters treat a value. A setter does nothing if the value is the same, since scripts set properties in every frame and
// the consequences of a change are costly. Values that share memory are swapped and copied under a lock, since another thread may read or
// save what the main thread sets.
#pragma once

#include <godot_cpp/variant/variant.hpp>

#include <mutex>
#include <type_traits>
#include <utility>

namespace grass {

// Held only briefly, and never while other code is called.
inline std::mutex property_values;

template <typename T> bool is_same_value(const T &p_a, const T &p_b) {
	if constexpr (requires { p_a == p_b; }) {
		return p_a == p_b;
	} else {
		return godot::Variant(p_a) == godot::Variant(p_b); // compares the engine's arrays and paths
	}
}

// Returns a copy of a property's value. May be called on any thread.
template <typename T> T value_of(const T &p_held) {
	std::lock_guard lock(property_values);
	return p_held;
}

// Replaces r_held by p_new. Returns false if they are the same, so that nothing has to follow.
template <typename T> [[nodiscard]] bool replace(T &r_held, const std::type_identity_t<T> &p_new) {
	if (is_same_value(r_held, p_new)) {
		return false;
	}
	T value = p_new; // holds the old value afterwards, which is destroyed after the lock is released
	{
		std::lock_guard lock(property_values);
		std::swap(r_held, value);
	}
	return true;
}

} // namespace grass
