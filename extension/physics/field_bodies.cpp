// SPDX-License-Identifier: MIT
#include "physics/field_bodies.h"

#include "core/field/grass_at.h"
#include "shared/parallel.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/project_settings.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

// Returns whether the physics server is the engine's own: one that comes with a project may require the main thread.
bool is_engines_own_server() {
	static const bool is_own = [] {
		const String engine = ProjectSettings::get_singleton()->get_setting("physics/3d/physics_engine", "DEFAULT");
		return engine == String("DEFAULT") || engine == String("Jolt Physics") || engine == String("GodotPhysics3D");
	}();
	return is_own;
}

// Returns the number of blades in the strip over which a collider moved in the tick, if it was low enough to touch them.
double blades_below(const Field &p_field, const LayersAt &p_layers, const ColliderShape &p_collider) {
	ColliderShape still = p_collider;
	still.before = still.now;
	const Bounds bounds = still.get_swept_bounds();
	const Eigen::Vector3d way = p_collider.now.position - p_collider.before.position, size = bounds.max - bounds.min;
	const Eigen::Vector2f place = Eigen::Vector2d(p_collider.now.position.x(), p_collider.now.position.z()).cast<float>();
	const MapLayers *layers = p_layers(place);
	const Canopy canopy = canopy_at(p_field, place, layers);
	const bool touches = canopy.height > 0.0 && bounds.max.y() > canopy.ground &&
			bounds.min.y() < canopy.ground + height_at(p_field, place, layers); // as high as before the collider bent it
	return touches ? canopy.blades * (std::abs(way.x()) * size.z() + std::abs(way.z()) * size.x()) : 0.0;
}

} // namespace

void FieldBodies::watch(const Field &p_field, const Transform3D &p_transform, double p_delta) {
	const TileGrid &grid = p_field.get_grid();
	const double height = p_field.get_setup().blade_length();
	_half_extents = Vector3(
			real_t(0.5 * grid.get_size_x() + height), real_t(height + p_field.ground_relief()), real_t(0.5 * grid.get_size_z() + height));
	_tracker.set_box(p_transform, _half_extents, p_delta);
	_watched = box_around(p_transform, _tracker.get_box_extents());
}

bool FieldBodies::find_resting(std::vector<RestingBody> &r_bodies) const {
	return _registered.is_empty() && _wheels.is_empty() && _bones.get_count() == 0 && _soft_bodies.get_count() == 0 &&
			_tracker.find_resting(r_bodies);
}

void FieldBodies::collect(
		const Field &p_field, const Ref<World3D> &p_world, const Transform3D &p_transform, double p_teleport_speed, double p_delta) {
	const MotionTick tick{ .delta = p_delta, .teleport_speed = p_teleport_speed };
	_collected_in = Engine::get_singleton()->get_physics_frames();
	_delta = p_delta;
	_tracker.collect(p_transform, tick, p_field.get_tiles(), is_engines_own_server() ? run_parallel : serial_for, _colliders);
	const FieldReach reach(p_world, p_transform, _half_extents, _tracker.get_mask());
	_registered.collect(reach, tick, _colliders);
	_wheels.collect(reach, tick, _colliders);
	_bones.collect(reach, tick, _colliders);
	_soft_bodies.collect(reach, tick, _colliders);
}

// Returns how many blades a second a node moves over. Of several shapes only the one with the most counts, since they overlap.
double FieldBodies::find_rustle(const Field &p_field, const LayersAt &p_layers, uint64_t p_node) const {
	double most = 0.0;
	if (Engine::get_singleton()->get_physics_frames() > _collected_in + 1) {
		return most;
	}
	for (const ColliderShape &collider : _colliders) {
		if (collider.owner == p_node && collider.force == ColliderShape::NO_FORCE && collider.has_moved()) {
			most = std::max(most, blades_below(p_field, p_layers, collider) / _delta);
		}
	}
	return most;
}

ParallelFor FieldBodies::get_parallel_for() const {
	return _tracker.is_crowded() ? run_parallel : serial_for;
}

void FieldBodies::add_forces(std::span<const Force> p_forces) {
	for (size_t i = 0; i < p_forces.size(); i++) {
		if (p_forces[i].reach() > 0.0) {
			_colliders.push_back(p_forces[i].make_shape(int(i)));
		}
	}
}

void FieldBodies::forget_motion() {
	_tracker.forget_motion();
	_registered.forget_motion();
	_wheels.forget_motion();
	_bones.forget_motion();
	_soft_bodies.forget_motion();
}

void FieldBodies::add_to(FieldStatistics &r_statistics) const {
	r_statistics.wheels = _wheels.get_count();
	r_statistics.bones = _bones.get_count();
	r_statistics.soft_bodies = _soft_bodies.get_count();
	r_statistics.mesh_pieces = _tracker.get_mesh_pieces() + _registered.get_mesh_pieces();
	r_statistics.areas = SharedArea::get_count();
	r_statistics.reads = _tracker.get_reads();
	for (const BodyReads &reads : { _registered.get_reads(), _wheels.get_reads(), _bones.get_reads(), _soft_bodies.get_reads() }) {
		r_statistics.reads.add(reads);
	}
}

} // namespace grass
