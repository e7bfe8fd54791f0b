// SPDX-License-Identifier: MIT
// Calls that may run a script: a signal, a method of a user's node, a change with listeners. A script may do anything then: free the
// calling object or its parent, remove it from the tree, set its properties. So the caller must
// - complete its own state before the call,
// - hold by value what it uses afterwards: no reference or pointer to anything that a setter replaces,
// - not touch itself afterwards unless outlives() says that it still exists, and then read its state again.
// Nodes tick from the engine's message queue, where the engine lets a node die: docs/history/0055-scripts-may-do-anything.md.
#pragma once

#include <godot_cpp/core/object.hpp>

namespace grass {

// Runs p_call. Returns false if a script freed p_object meanwhile.
template <typename F> [[nodiscard]] bool outlives(const godot::Object &p_object, F &&p_call) {
	const uint64_t id = p_object.get_instance_id();
	p_call();
	return godot::ObjectDB::get_instance(id) != nullptr;
}

} // namespace grass
