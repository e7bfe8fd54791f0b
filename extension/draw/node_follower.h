// SPDX-License-Identifier: MIT
// Lets an instance of the renderer follow a node. Reads the node in every frame and passes on only what changed: whenever its world is set,
// even to the same one, an instance leaves the renderer's scene and enters it again.
#pragma once

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/variant/rid.hpp>

namespace grass {

class NodeFollower {
public:
	// Takes world, layers, transparency and gi_mode of the node, and p_transform. The instance is visible if the node is and if
	// p_is_wanted. Must always get the same instance until reset().
	void follow(const godot::RID &p_instance, godot::GeometryInstance3D *p_node, const godot::Transform3D &p_transform, bool p_is_wanted);
	// Shows or hides the instance at once, after follow().
	void show(const godot::RID &p_instance, bool p_is_wanted);
	void reset() { _is_known = false; }
	int64_t get_updates() const { return _updates; } // changes that were passed to the renderer

private:
	struct State {
		godot::RID scenario;
		godot::Transform3D transform;
		bool is_visible = false;
		uint32_t layers = 0;
		double transparency = 0.0;
		bool takes_probes = false; // of a LightmapGI
		uint64_t node_id = 0;
		bool operator==(const State &) const = default;
	};

	State _told;
	bool _is_known = false, _is_node_visible = false;
	int64_t _updates = 0;
};

} // namespace grass
