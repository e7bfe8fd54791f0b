// SPDX-License-Identifier: MIT
#include "nodes/soft_bodies.h"

#include "convert.h"
#include "nodes/scene_watch.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

using namespace godot;

namespace grass {

namespace {

// Around the grass: a body is read some ticks before it touches a blade. Metres.
constexpr double APPROACH = 3.0;
// Frames after a node got its mesh in which the server has it.
constexpr uint64_t MESH_FRAMES = 2;

bool is_disabled(const Node *p_node) {
	while (p_node != nullptr && p_node->get_process_mode() == Node::PROCESS_MODE_INHERIT) {
		p_node = p_node->get_parent();
	}
	return p_node != nullptr && p_node->get_process_mode() == Node::PROCESS_MODE_DISABLED;
}

bool is_near(const AABB &p_bounds, const SoftBodies::Place &p_place) {
	const Eigen::Affine3d from_world = to_eigen(p_place.field).inverse(Eigen::Isometry);
	const Eigen::Vector3d half = 0.5 * to_eigen(p_bounds.size);
	const Eigen::Vector3d middle = from_world * Eigen::Vector3d(to_eigen(p_bounds.position) + half);
	const Eigen::Vector3d reach = from_world.linear().cwiseAbs() * half + to_eigen(p_place.half_extents);
	return ((middle.cwiseAbs() - reach).array() <= APPROACH).all(); // false if it is not finite
}

} // namespace

// A body that its node took out of the server has no points, and asking for them is an error there.
bool SoftBodies::is_ready(const SoftBody3D *p_node) {
	const Ref<Mesh> mesh = p_node->get_mesh();
	_reads.engine_calls += 2;
	if (mesh.is_null() ||
			(!p_node->can_process() && p_node->get_disable_mode() == SoftBody3D::DISABLE_MODE_REMOVE && is_disabled(p_node))) {
		return false;
	}
	const uint64_t frame = Engine::get_singleton()->get_process_frames();
	Shown &shown = _shown[p_node->get_instance_id()];
	if (shown.mesh != mesh->get_instance_id()) {
		shown = { mesh->get_instance_id(), frame };
	}
	return frame >= shown.frame + MESH_FRAMES;
}

void SoftBodies::read_mesh(const Ref<Mesh> &p_mesh, Body &r_body) {
	r_body = Body();
	r_body.mesh = p_mesh->get_instance_id();
	if (p_mesh->get_surface_count() == 0) {
		return;
	}
	const Array arrays = p_mesh->surface_get_arrays(0); // the server simulates no other
	const PackedVector3Array vertices = arrays[Mesh::ARRAY_VERTEX];
	const PackedInt32Array indices = arrays[Mesh::ARRAY_INDEX];
	std::vector<Eigen::Vector3d> points;
	points.reserve(size_t(vertices.size()));
	for (int64_t i = 0; i < vertices.size(); i++) {
		points.push_back(to_eigen(vertices[i]));
	}
	std::vector<int> faces;
	const int64_t count = indices.is_empty() ? vertices.size() : indices.size();
	for (int64_t i = 0; i < count; i++) {
		faces.push_back(indices.is_empty() ? int(i) : indices[i]);
	}
	r_body.parts = SoftParts(points, faces);
	r_body.motions.resize(size_t(r_body.parts.get_count()));
}

// Of a body that sleeps and lies where it lay nothing is asked.
void SoftBodies::read_points(const RID &p_body, const AABB &p_bounds, Body &r_body) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	_reads.engine_calls++;
	if (p_bounds == r_body.bounds && bool(server->soft_body_get_state(p_body, PhysicsServer3D::BODY_STATE_SLEEPING))) {
		return;
	}
	r_body.bounds = p_bounds;
	r_body.places.clear();
	for (const int point : r_body.parts.get_points()) {
		r_body.places.push_back(server->soft_body_get_point_global_position(p_body, point));
	}
	_reads.poses++;
	_reads.engine_calls += int64_t(r_body.places.size());
}

void SoftBodies::write(
		uint64_t p_owner, const Transform3D &p_field, const MotionTick &p_tick, Body &r_body, std::vector<ColliderShape> &r_colliders) {
	const Eigen::Affine3d from_world = to_eigen(p_field).inverse(Eigen::Isometry);
	std::vector<Eigen::Vector3d> places;
	places.reserve(r_body.places.size());
	for (const Vector3 &place : r_body.places) {
		places.emplace_back(from_world * to_eigen(place));
	}
	std::vector<Hull> hulls;
	r_body.parts.bound(places, hulls);
	for (size_t i = 0; i < hulls.size(); i++) {
		if (hulls[i].planes.empty()) {
			r_body.motions[i].forget();
			continue;
		}
		ColliderShape &collider = r_colliders.emplace_back();
		collider.type = GRASS_HULL;
		collider.size = hulls[i].half_extents;
		collider.planes = std::move(hulls[i].planes);
		collider.friction = NodeMotion::FRICTION;
		collider.owner = p_owner;
		Eigen::Affine3d pose = Eigen::Affine3d::Identity();
		pose.translation() = hulls[i].centre;
		r_body.motions[i].pose(pose, p_tick, collider);
	}
}

void SoftBodies::collect(const Place &p_place, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	std::map<uint64_t, Body> still_near;
	for (const SoftBody3D *node : SceneWatch::get_singleton()->get_soft_bodies()) {
		if ((node->get_collision_layer() & p_place.mask) == 0 || node->get_world_3d() != p_place.world || !is_ready(node)) {
			continue;
		}
		const AABB bounds = server->soft_body_get_bounds(node->get_physics_rid());
		_reads.engine_calls += 4;
		if (!is_near(bounds, p_place)) {
			continue;
		}
		const uint64_t id = node->get_instance_id();
		Body &body = still_near[id];
		const auto known = _bodies.find(id);
		if (known != _bodies.end()) {
			body = std::move(known->second);
		}
		const Ref<Mesh> mesh = node->get_mesh();
		if (body.mesh != mesh->get_instance_id()) {
			read_mesh(mesh, body);
		}
		read_points(node->get_physics_rid(), bounds, body);
		write(id, p_place.field, p_tick, body, r_colliders);
	}
	_bodies.swap(still_near);
	if (_shown.size() > SceneWatch::get_singleton()->get_soft_bodies().size()) {
		std::erase_if(_shown, [](const auto &p_entry) { return ObjectDB::get_instance(p_entry.first) == nullptr; });
	}
}

} // namespace grass
