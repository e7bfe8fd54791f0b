// SPDX-License-Identifier: MIT
#include "shared/label.h"

#include "shared/main_thread.h"

using namespace godot;

namespace grass {

namespace {

String with_class(const Object &p_object, const String &p_name) {
	return p_name.is_empty() ? p_object.get_class() : vformat("%s '%s'", p_object.get_class(), p_name);
}

} // namespace

String label_of(const Node &p_node) {
	const bool has_path = is_main_thread() && p_node.is_inside_tree(); // only the main thread may use the tree
	return with_class(p_node, has_path ? String(p_node.get_path()) : String(p_node.get_name()));
}

String label_of(const Resource &p_resource) {
	return with_class(p_resource, p_resource.get_path().is_empty() ? p_resource.get_name() : p_resource.get_path());
}

} // namespace grass
