// SPDX-License-Identifier: MIT
#include "editor/field_owner.h"

#include "nodes/field_monitors.h"

#include <godot_cpp/classes/editor_interface.hpp>

using namespace godot;

namespace grass {

bool has_own_file(const Resource &p_resource) {
	return !p_resource.get_path().is_empty() && !p_resource.get_path().contains("::");
}

String find_foreign_file(const Ref<Resource> &p_resource, const Node &p_root) {
	const String path = p_resource.is_valid() ? p_resource->get_path() : String();
	const String file = path.contains("::") ? path.get_slice("::", 0) : String();
	return file == p_root.get_scene_file_path() ? String() : file;
}

bool is_saved_by(const Node &p_root, const Node &p_node) {
	Node *owner = p_node.get_owner(); // the root of the scene that the node is from
	if (&p_node == &p_root || owner == &p_root) {
		return true;
	}
	return owner != nullptr && p_root.is_ancestor_of(owner) && p_root.is_editable_instance(owner) && is_saved_by(p_root, *owner);
}

std::optional<ForeignField> find_foreign(const GrassField &p_field, bool p_of_map) {
	const Node *root = EditorInterface::get_singleton()->get_edited_scene_root();
	const Ref<GrassMap> map = p_of_map ? p_field.get_map() : Ref<GrassMap>();
	if (root == nullptr || (map.is_valid() && has_own_file(**map))) {
		return {};
	}
	if (!is_saved_by(*root, p_field)) {
		const Node *owner = p_field.get_owner();
		return ForeignField{ owner != nullptr ? owner->get_scene_file_path() : String(), false };
	}
	const String file = find_foreign_file(map, *root);
	return file.is_empty() ? std::nullopt : std::optional<ForeignField>({ file, true });
}

std::vector<const GrassField *> find_sharing(const GrassField &p_field) {
	std::vector<const GrassField *> found;
	const Node *root = EditorInterface::get_singleton()->get_edited_scene_root();
	for (GrassField *field : FieldMonitors::get_fields()) {
		const bool is_in_scene = root != nullptr && (field == root || root->is_ancestor_of(field));
		if (field != &p_field && is_in_scene && p_field.get_map().is_valid() && field->get_map() == p_field.get_map()) {
			found.push_back(field);
		}
	}
	return found;
}

Ref<Resource> own_copy(const Ref<Resource> &p_resource) {
	if (p_resource.is_null()) {
		return p_resource;
	}
	Ref<Resource> copy = p_resource->duplicate(true);
	copy->set_local_to_scene(false);
	return copy;
}

Ref<Resource> own_if_inside(const Ref<Resource> &p_resource) {
	return p_resource.is_null() || has_own_file(**p_resource) ? p_resource : own_copy(p_resource);
}

} // namespace grass
