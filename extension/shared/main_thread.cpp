// SPDX-License-Identifier: MIT
#include "shared/main_thread.h"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/typed_array.hpp>

using namespace godot;

namespace grass {

bool is_main_thread() {
	thread_local const bool is_main = OS::get_singleton()->get_thread_caller_id() == OS::get_singleton()->get_main_thread_id();
	return is_main;
}

namespace {

// Returns whether a node in the tree listens to p_resource, or to a resource that listens to it.
bool is_used(const Object &p_resource) {
	for (const char *signal : { "changed", "chunks_changed" }) {
		const TypedArray<Dictionary> connections =
				p_resource.has_signal(signal) ? p_resource.get_signal_connection_list(signal) : TypedArray<Dictionary>();
		for (int64_t i = 0; i < connections.size(); i++) {
			const Callable listener = Dictionary(connections[i])["callable"];
			const Object *object = listener.get_object();
			const Node *node = Object::cast_to<Node>(object);
			if (node != nullptr ? node->is_inside_tree() : Object::cast_to<Resource>(object) != nullptr && is_used(*object)) {
				return true;
			}
		}
	}
	return false;
}

} // namespace

bool may_change(const Resource &p_resource) {
	return is_main_thread() || !is_used(p_resource);
}

String thread_message(const String &p_owner, const String &p_what) {
	return vformat("%s: %s belongs to the main thread. From another one, use call_deferred().", p_owner, p_what);
}

} // namespace grass
