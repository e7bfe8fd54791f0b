// SPDX-License-Identifier: MIT
// Turns the wind of Area3D nodes, which Godot has for soft bodies, into forces.
#pragma once

#include "core/blades/force.h"
#include "physics/resting_bodies.h"

#include <godot_cpp/classes/area3d.hpp>

#include <map>
#include <vector>

namespace grass {

class AreaWinds {
public:
	// Must be called when a shape of an area enters or leaves the field's box, as PhysicsServer3D.area_set_area_monitor_callback reports
	// it.
	void area_changed(int64_t p_status, int64_t p_instance_id);
	// Advances by a tick: winds rise while they are in the box.
	void pass(double p_delta);
	void clear() { _areas.clear(); }
	bool is_empty() const { return _areas.empty(); }
	// Returns false if one of them has wind. Appends the others, which may begin to blow without notice.
	bool find_resting(std::vector<RestingBody> &r_areas) const;
	// Returns the winds that blow, in global space.
	std::vector<Force> get_forces() const;

private:
	struct Known {
		int overlaps = 0;
		double age = 0.0; // seconds since its wind began
	};
	std::map<uint64_t, Known> _areas; // by instance id
};

} // namespace grass
