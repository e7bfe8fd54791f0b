// SPDX-License-Identifier: MIT
// Finds the places around which plants have nodes: the cameras that see a field, and the bodies that move in it.
#pragma once

#include "core/field/plant_search.h"
#include "physics/body_tracker.h"

#include <godot_cpp/classes/visual_instance3d.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <vector>

namespace grass {

class PlantEyes {
public:
	// Returns the eyes. Must be called once a tick. p_node: the field, at p_transform (orthonormal). p_tracker: knows the bodies near it.
	std::vector<PlantEye> find(const godot::VisualInstance3D &p_node, const godot::Transform3D &p_transform, const BodyTracker &p_tracker);

private:
	void look_for_bodies(const BodyTracker &p_tracker);

	std::vector<uint64_t> _bodies; // instance ids, characters first
	int _next_look = 0; // ticks until they are looked for
};

} // namespace grass
