// SPDX-License-Identifier: MIT
// The cameras, directional lights, environments and soft bodies in the scene tree. The tree's signals update the lists, once for all
// fields: the cost of a search in every frame would grow with the number of nodes.
#pragma once

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/directional_light3d.hpp>
#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/classes/soft_body3d.hpp>
#include <godot_cpp/classes/world_environment.hpp>

#include <cstdint>
#include <vector>

namespace grass {

class SceneWatch : public godot::Object {
	GDCLASS(SceneWatch, godot::Object)

public:
	// Returns the only instance, which is made on first use and freed when the extension is unloaded.
	static SceneWatch *get_singleton();
	static void free_singleton();

	// Starts the lists with the nodes that are already in p_inside's tree. Cheap after the first call.
	void start(godot::Node *p_inside);

	// Return all in the tree, in the order in which they entered.
	const std::vector<godot::Camera3D *> &get_cameras() const { return _cameras; }
	const std::vector<godot::DirectionalLight3D *> &get_suns() const { return _suns; }
	const std::vector<godot::WorldEnvironment *> &get_environments() const { return _environments; }
	const std::vector<godot::SoftBody3D *> &get_soft_bodies() const { return _soft_bodies; }

protected:
	static void _bind_methods() {}

private:
	void _added(godot::Node *p_node);
	void _removed(godot::Node *p_node);

	static SceneWatch *_singleton;
	uint64_t _tree = 0; // instance id of the watched tree
	std::vector<godot::Camera3D *> _cameras;
	std::vector<godot::DirectionalLight3D *> _suns;
	std::vector<godot::WorldEnvironment *> _environments;
	std::vector<godot::SoftBody3D *> _soft_bodies;
};

} // namespace grass
