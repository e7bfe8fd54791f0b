// SPDX-License-Identifier: MIT
// Calls that may run a script: a signal, a method of a user's node, a change that others hear of. A script may do anything meanwhile: free
// the object that calls, or its parent, take it out of the tree, give its properties other values. So whoever calls
// - makes its own state whole before,
// - holds by value what it goes on with: no reference or pointer to what a setter replaces,
// - does not touch itself afterwards unless outlives() says that it is still there, and then looks at its state again.
// Nodes tick from the engine's message queue, where the engine lets a node die: docs/decisions/0055-scripts-may-do-anything.md.
#pragma once

#include <godot_cpp/core/object.hpp>

namespace grass {

// Runs p_call. False: a script freed p_object meanwhile.
template <typename F> [[nodiscard]] bool outlives(const godot::Object &p_object, F &&p_call) {
	const uint64_t id = p_object.get_instance_id();
	p_call();
	return godot::ObjectDB::get_instance(id) != nullptr;
}

} // namespace grass
