// SPDX-License-Identifier: MIT
#include "editor/new_nodes.h"

#include "resources/grass_exclusion_3d.h"
#include "resources/grass_path_3d.h"

#include <godot_cpp/classes/box_shape3d.hpp>
#include <godot_cpp/classes/editor_interface.hpp>

using namespace godot;

namespace grass {

namespace {

const Vector3 FIRST_BOX(2, 2, 2); // metres

// Returns whether a node is new. Nodes of a file have an owner when they enter the tree; the editor gives one to new nodes afterwards.
bool is_new(const Node &p_node) {
	const GrassExclusion3D *exclusion = Object::cast_to<GrassExclusion3D>(&p_node);
	const GrassPath3D *path = Object::cast_to<GrassPath3D>(&p_node);
	const bool is_empty = (exclusion != nullptr && exclusion->get_shape().is_null() && exclusion->get_outline().is_empty()) ||
			(path != nullptr && path->get_curve().is_null());
	return is_empty && p_node.get_owner() == nullptr;
}

} // namespace

bool NewNodes::see(const Node &p_node) {
	return is_new(p_node) && _seen.insert(p_node.get_instance_id()).second;
}

void NewNodes::furnish(uint64_t p_id) const {
	Node *node = Object::cast_to<Node>(ObjectDB::get_instance(p_id));
	const Node *root = EditorInterface::get_singleton()->get_edited_scene_root();
	if (node == nullptr || root == nullptr || (node != root && node->get_owner() != root)) {
		return;
	}
	GrassExclusion3D *exclusion = Object::cast_to<GrassExclusion3D>(node);
	if (exclusion != nullptr && exclusion->get_shape().is_null() && exclusion->get_outline().is_empty()) {
		Ref<BoxShape3D> box;
		box.instantiate();
		box->set_size(FIRST_BOX);
		exclusion->set_shape(box);
	}
	GrassPath3D *path = Object::cast_to<GrassPath3D>(node);
	if (path != nullptr && path->get_curve().is_null()) {
		Ref<Curve3D> curve;
		curve.instantiate();
		path->set_curve(curve);
	}
	node->notify_property_list_changed(); // the inspector may show it already
}

} // namespace grass
