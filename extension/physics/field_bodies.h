// SPDX-License-Identifier: MIT
// Collects everything that bends a field's grass as the colliders of a tick: bodies of the physics server, and nodes that a game
// registered. Also finds which of them are in the grass.
#pragma once

#include "core/field/canopy.h"
#include "core/field/field.h"
#include "core/field/field_statistics.h"
#include "core/field/visitors.h"
#include "physics/body_tracker.h"
#include "physics/bone_colliders.h"
#include "physics/node_colliders.h"
#include "physics/soft_bodies.h"
#include "physics/vehicle_wheels.h"

#include <span>
#include <vector>

namespace grass {

class FieldBodies {
public:
	BodyTracker &get_tracker() { return _tracker; }
	NodeColliders &get_registered() { return _registered; }
	VehicleWheels &get_wheels() { return _wheels; }

	// Watches the space around the grass of p_field, which is at p_transform (orthonormal), in ticks of p_delta seconds.
	void watch(const Field &p_field, const godot::Transform3D &p_transform, double p_delta);
	// Poses every collider for a tick of p_delta seconds of p_field, which is in p_world at p_transform. Must be called after watch().
	void collect(const Field &p_field, const godot::Ref<godot::World3D> &p_world, const godot::Transform3D &p_transform,
			double p_teleport_speed, double p_delta);
	// Returns whether watch() and what calls stir() report everything that may move; see BodyTracker::find_resting().
	bool find_resting(std::vector<RestingBody> &r_bodies) const;
	const Eigen::AlignedBox3d &get_watched() const { return _watched; } // a box around the watched space, global
	// Adds the colliders that wake tiles for the forces of the tick. Must be called after collect().
	void add_forces(std::span<const Force> p_forces);
	std::span<ColliderShape> get_colliders() { return _colliders; }
	// Returns the threads that the rest of the tick runs on: many if a crowd moves.
	ParallelFor get_parallel_for() const;
	// Must be called when time has passed without collect(): the way from the bodies' last positions is not motion then.
	void forget_motion();

	// Returns the nodes that entered grass in this tick, and those that left it. Must be called after the tick.
	Visitors::Change update_visitors(const TileManager &p_tiles) { return _visitors.update(p_tiles, _colliders); }
	// Must be called when the field is removed. Returns the bodies that were in its grass.
	std::vector<uint64_t> leave() { return _visitors.leave(); }

	// Returns how many blades a second a node's bodies moved over in the last tick, where they touch grass. It is 0 in ticks that the field
	// leaves out.
	double find_rustle(const Field &p_field, const LayersAt &p_layers, uint64_t p_node) const;

	int64_t get_count() const { return _tracker.body_count(); } // of the physics server
	void add_to(FieldStatistics &r_statistics) const;

private:
	BodyTracker _tracker;
	NodeColliders _registered;
	VehicleWheels _wheels;
	BoneColliders _bones;
	SoftBodies _soft_bodies;
	std::vector<ColliderShape> _colliders; // of this tick
	Visitors _visitors;
	godot::Vector3 _half_extents; // of the box around the grass, in field space
	Eigen::AlignedBox3d _watched;
	uint64_t _collected_in = 0; // the physics tick
	double _delta = 0.0; // seconds of it
};

} // namespace grass
