// SPDX-License-Identifier: MIT
#include "physics/field_bodies.h"

#include "shared/parallel.h"

#include <godot_cpp/classes/project_settings.hpp>

using namespace godot;

namespace grass {

namespace {

// A server that comes with a project may require the main thread.
bool is_engines_own_server() {
	static const bool is_own = [] {
		const String engine = ProjectSettings::get_singleton()->get_setting("physics/3d/physics_engine", "DEFAULT");
		return engine == String("DEFAULT") || engine == String("Jolt Physics") || engine == String("GodotPhysics3D");
	}();
	return is_own;
}

} // namespace

void FieldBodies::collect(
		const Field &p_field, const Ref<World3D> &p_world, const Transform3D &p_transform, double p_teleport_speed, double p_delta) {
	const TileGrid &grid = p_field.get_grid();
	const double height = p_field.get_setup().blade_length();
	const Vector3 half(
			real_t(0.5 * grid.get_size_x() + height), real_t(height + p_field.ground_relief()), real_t(0.5 * grid.get_size_z() + height));
	const MotionTick tick{ .delta = p_delta, .teleport_speed = p_teleport_speed };
	_tracker.set_box(p_transform, half, p_delta);
	_tracker.collect(p_transform, tick, p_field.get_tiles(), is_engines_own_server() ? run_parallel : serial_for, _colliders);
	const FieldReach reach(p_world, p_transform, half, _tracker.get_mask());
	_registered.collect(reach, tick, _colliders);
	_wheels.collect(reach, tick, _colliders);
	_bones.collect(reach, tick, _colliders);
	_soft_bodies.collect(reach, tick, _colliders);
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
	r_statistics.reads = _tracker.get_reads();
	for (const BodyReads &reads : { _registered.get_reads(), _wheels.get_reads(), _bones.get_reads(), _soft_bodies.get_reads() }) {
		r_statistics.reads.add(reads);
	}
}

} // namespace grass
