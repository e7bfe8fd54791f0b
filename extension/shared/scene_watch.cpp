// SPDX-License-Identifier: MIT
#include "shared/scene_watch.h"

#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

template <typename T> void add_node(Node *p_node, std::vector<T *> &r_list) {
	T *node = Object::cast_to<T>(p_node);
	if (node != nullptr && std::find(r_list.begin(), r_list.end(), node) == r_list.end()) {
		r_list.push_back(node);
	}
}

template <typename T> void remove_node(Node *p_node, std::vector<T *> &r_list) {
	T *node = Object::cast_to<T>(p_node);
	if (node != nullptr) {
		std::erase(r_list, node);
	}
}

} // namespace

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
	add_node(p_node, _cameras);
	add_node(p_node, _suns);
	add_node(p_node, _environments);
	add_node(p_node, _soft_bodies);
}

void SceneWatch::_removed(Node *p_node) {
	remove_node(p_node, _cameras);
	remove_node(p_node, _suns);
	remove_node(p_node, _environments);
	remove_node(p_node, _soft_bodies);
}

} // namespace grass
