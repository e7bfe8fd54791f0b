// SPDX-License-Identifier: MIT
// How setters and getters treat a value. A setter does nothing where the value is the same: scripts set properties in every frame, and what
// follows from a change is dear. Values that share memory are swapped and copied under a lock: a thread may read, or save, what the main
// thread sets.
#pragma once

#include <godot_cpp/variant/variant.hpp>

#include <mutex>
#include <type_traits>
#include <utility>

namespace grass {

// Held for moments only, and never while anything else is called.
inline std::mutex property_values;

template <typename T> bool is_same_value(const T &p_a, const T &p_b) {
	if constexpr (requires { p_a == p_b; }) {
		return p_a == p_b;
	} else {
		return godot::Variant(p_a) == godot::Variant(p_b); // the engine's arrays and paths
	}
}

// A copy of a property's value, on any thread.
template <typename T> T value_of(const T &p_held) {
	std::lock_guard lock(property_values);
	return p_held;
}

// Puts p_new in the place of r_held. False where that is the same, and nothing follows.
template <typename T> [[nodiscard]] bool replace(T &r_held, const std::type_identity_t<T> &p_new) {
	if (is_same_value(r_held, p_new)) {
		return false;
	}
	T value = p_new; // afterwards the old one, which ends when the lock is open again
	{
		std::lock_guard lock(property_values);
		std::swap(r_held, value);
	}
	return true;
}

} // namespace grass
