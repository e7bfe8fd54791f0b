// SPDX-License-Identifier: MIT
// The forces that blow over a field: GrassForce3D nodes of its world, winds of Area3D nodes, and pushes of scripts.
#pragma once

#include "core/blades/force.h"
#include "field/field_host.h"
#include "physics/area_winds.h"

#include <span>
#include <vector>

namespace grass {

class FieldForces {
public:
	FieldForces(FieldHost &p_host) : _host(p_host) {}

	// Begin pushes of scripts. Places and velocities are global, p_duration is in seconds: see FORCE_SPEED and others in
	// core/blades/force.h.
	void blast(const godot::Vector3 &p_place, double p_speed, double p_radius, double p_duration);
	void push(const godot::Vector3 &p_place, const godot::Vector3 &p_velocity, double p_radius, double p_duration);
	AreaWinds &get_areas() { return _areas; }
	// Returns whether the air rests until a GrassForce3D comes near. See AreaWinds.
	bool find_resting(std::vector<RestingBody> &r_areas) const { return _pushes.empty() && _areas.find_resting(r_areas); }
	// Advances pushes by a tick, and removes those that are over.
	void pass(double p_delta);
	// Finds the forces that reach a rectangle around the field's centre, p_size metres along x and z. Keeps the strongest, at most
	// GRASS_MAX_FORCES.
	void gather(const godot::Vector2 &p_size);
	std::span<const Force> get() const { return _forces; } // field space
	int get_left_out() const { return _left_out; }

private:
	void add_push(Force &r_force, double p_speed, double p_radius, double p_duration);
	void add(const Force &p_force, const godot::Transform3D &p_to_field, const godot::Vector2 &p_size);

	FieldHost &_host;
	AreaWinds _areas;
	std::vector<Force> _pushes; // global
	std::vector<Force> _forces;
	int _left_out = 0; // in the last gather()
};

} // namespace grass
