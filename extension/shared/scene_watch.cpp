// SPDX-License-Identifier: MIT
#include "shared/scene_watch.h"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/typed_array.hpp>

using namespace godot;

namespace grass {

SceneWatch *SceneWatch::_singleton = nullptr;

SceneWatch *SceneWatch::get_singleton() {
	if (_singleton == nullptr) {
		_singleton = memnew(SceneWatch);
	}
	return _singleton;
}

void SceneWatch::free_singleton() {
	if (_singleton != nullptr) {
		memdelete(_singleton);
		_singleton = nullptr;
	}
}

void SceneWatch::start(Node *p_inside) {
	SceneTree *tree = p_inside->get_tree();
	if (tree->get_instance_id() == _tree) {
		return;
	}
	_tree = tree->get_instance_id();
	_cameras.clear();
	_suns.clear();
	_environments.clear();
	_soft_bodies.clear();
	tree->connect("node_added", callable_mp(this, &SceneWatch::_added));
	tree->connect("node_removed", callable_mp(this, &SceneWatch::_removed));
	for (const char *type : { "Camera3D", "DirectionalLight3D", "WorldEnvironment", "SoftBody3D" }) {
		const TypedArray<Node> found = tree->get_root()->find_children("*", type, true, false);
		for (int64_t i = 0; i < found.size(); i++) {
			_added(Object::cast_to<Node>(found[i]));
		}
	}
}

void SceneWatch::_added(Node *p_node) {
	_cameras.add(p_node);
	_suns.add(p_node);
	_environments.add(p_node);
	_soft_bodies.add(p_node);
}

void SceneWatch::_removed(Node *p_node) {
	_cameras.remove(p_node);
	_suns.remove(p_node);
	_environments.remove(p_node);
	_soft_bodies.remove(p_node);
}

} // namespace grass
