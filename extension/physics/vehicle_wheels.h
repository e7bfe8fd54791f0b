// SPDX-License-Identifier: MIT
// Makes cylinders that press the grass from the wheels of vehicles, which are rays in the physics server. Also finds where they slip.
#pragma once

#include "physics/node_colliders.h"

#include <godot_cpp/classes/vehicle_wheel3d.hpp>

#include <map>
#include <vector>

namespace grass {

class VehicleWheels {
public:
	// A place where a wheel slips on the ground.
	struct Slip {
		godot::Vector3 place; // global
		double radius; // of the track, metres
		double share; // 1: it slips completely
	};

	// Must be called when a shape of a body enters or leaves the field's box, see BodyTracker::body_changed().
	void body_changed(int64_t p_status, int64_t p_instance_id);
	void clear();
	bool is_empty() const { return _vehicles.empty(); }
	// Appends every wheel, posed in the field's space.
	void collect(const FieldReach &p_reach, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders);
	void forget_motion() { _colliders.forget_motion(); }
	int64_t get_count() const { return _colliders.get_count(); } // wheels near the grass
	const BodyReads &get_reads() const { return _colliders.get_reads(); }
	std::vector<Slip> find_slips() const;

private:
	struct Vehicle {
		int overlaps = 0;
		std::vector<uint64_t> wheels; // ids of VehicleWheel3D nodes
	};
	void add_wheels(Vehicle &r_vehicle, uint64_t p_vehicle);
	void drop_left();

	std::map<uint64_t, Vehicle> _vehicles; // by id, so that the order of colliders is the same in every run
	NodeColliders _colliders;
};

} // namespace grass
