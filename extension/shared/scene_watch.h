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

#include <algorithm>
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
	std::vector<godot::Camera3D *> get_cameras() const { return _cameras.get_all(); }
	std::vector<godot::DirectionalLight3D *> get_suns() const { return _suns.get_all(); }
	std::vector<godot::WorldEnvironment *> get_environments() const { return _environments.get_all(); }
	std::vector<godot::SoftBody3D *> get_soft_bodies() const { return _soft_bodies.get_all(); }
	size_t count_soft_bodies() const { return _soft_bodies.count(); }

protected:
	static void _bind_methods() {}

private:
	void _added(godot::Node *p_node);
	void _removed(godot::Node *p_node);

	// The nodes of a class.
	template <typename T> class Watched {
	public:
		void add(const godot::Node *p_node) {
			if (godot::Object::cast_to<T>(p_node) != nullptr && std::ranges::find(_ids, p_node->get_instance_id()) == _ids.end()) {
				_ids.push_back(p_node->get_instance_id());
			}
		}
		void remove(const godot::Node *p_node) { std::erase(_ids, p_node->get_instance_id()); }
		void clear() { _ids.clear(); }
		size_t count() const { return _ids.size(); }
		std::vector<T *> get_all() const {
			std::vector<T *> all;
			for (const uint64_t id : _ids) {
				if (T *node = godot::Object::cast_to<T>(godot::ObjectDB::get_instance(id))) {
					all.push_back(node);
				}
			}
			return all;
		}

	private:
		std::vector<uint64_t> _ids;
	};

	static SceneWatch *_singleton;
	uint64_t _tree = 0; // instance id of the watched tree
	Watched<godot::Camera3D> _cameras;
	Watched<godot::DirectionalLight3D> _suns;
	Watched<godot::WorldEnvironment> _environments;
	Watched<godot::SoftBody3D> _soft_bodies;
};

} // namespace grass
