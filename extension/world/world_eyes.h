// SPDX-License-Identifier: MIT
// The points around which a world keeps its plots: the cameras that see it, and the bodies in it that are awake. Places are x, z in metres
// in the world's space, so that a shift of the origin changes nothing.
#pragma once

#include "core/world/world_plan.h"
#include "shared/watched_box.h"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <map>
#include <vector>

namespace grass {

class WorldEyes {
public:
	~WorldEyes() { stop(); }

	// Starts to watch bodies. p_changed: gets the arguments of PhysicsServer3D.area_set_monitor_callback, and must pass the first three to
	// body_changed().
	void start(const godot::RID &p_space, const godot::Callable &p_changed, uint32_t p_mask);
	void stop();
	void body_changed(int64_t p_status, const godot::RID &p_body, int64_t p_instance_id);
	// Runs a tick: checks some of the bodies, in turn.
	void tick(const godot::Transform3D &p_world, const godot::Vector3 &p_half_extents);

	// Returns the places of the cameras. p_layers: the layers of the grass.
	std::vector<Eigen::Vector2d> find_cameras(const godot::Node3D &p_world, uint32_t p_layers) const;
	std::vector<Eigen::Vector2d> find_bodies() const; // awake ones
	int64_t get_body_count() const { return int64_t(_bodies.size()); }

private:
	struct Body {
		uint64_t instance_id = 0;
		int64_t overlaps = 0; // number of its shapes in the world
		godot::Vector3 place; // in the world's space, at the last check
		bool has_place = false;
		bool is_awake = false;
		int64_t awake_until = 0; // tick, if moved by script
	};
	void look(Body &r_body, const godot::Transform3D &p_to_world_space);

	WatchedBox _box;
	std::map<uint64_t, Body> _bodies; // by the RID's id
	uint64_t _next = 0; // the next body to check
	int64_t _ticks = 0;
};

} // namespace grass
