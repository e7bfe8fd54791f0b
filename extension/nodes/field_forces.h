// SPDX-License-Identifier: MIT
// The forces that blow over a field: GrassForce3D nodes of its world, winds of Area3D nodes, and pushes of scripts.
#pragma once

#include "core/forces/force.h"
#include "nodes/area_winds.h"
#include "nodes/field_host.h"

#include <span>
#include <vector>

namespace grass {

class FieldForces {
public:
	// p_force: global.
	void push(const Force &p_force);
	AreaWinds &get_areas() { return _areas; }
	// A tick passes: pushes get older, and go.
	void pass(double p_delta);
	// Finds those that reach a rectangle around the field's centre, p_size metres along x and z; the strongest, at most GRASS_MAX_FORCES.
	void gather(const FieldHost &p_host, const godot::Vector2 &p_size);
	std::span<const Force> get() const { return _forces; } // field space
	int get_left_out() const { return _left_out; }

private:
	void add(const Force &p_force, const godot::Transform3D &p_to_field, const godot::Vector2 &p_size);

	AreaWinds _areas;
	std::vector<Force> _pushes; // global
	std::vector<Force> _forces;
	int _left_out = 0; // in the last gather()
};

} // namespace grass
