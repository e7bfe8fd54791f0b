// SPDX-License-Identifier: MIT
#include "physics/soft_bodies.h"

#include "shared/convert.h"
#include "shared/scene_watch.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <limits>
#include <set>

using namespace godot;

namespace grass {

namespace {

// Frames after which the server has a node's new mesh.
constexpr uint64_t MESH_FRAMES = 2;

// Returns whether its node removed it from the server; it may have been disabled since find_handed_over() looked.
bool is_removed(const SoftBody3D *p_node) {
	if (p_node->can_process() || p_node->get_disable_mode() != SoftBody3D::DISABLE_MODE_REMOVE) {
		return false;
	}
	const Node *node = p_node;
	while (node != nullptr && node->get_process_mode() == Node::PROCESS_MODE_INHERIT) {
		node = node->get_parent();
	}
	return node != nullptr && node->get_process_mode() == Node::PROCESS_MODE_DISABLED;
}

// Returns the nodes whose mesh the server has, or gets before the next frame: those that the renderer will call then. A node that is
// enabled without a mesh is never called, whatever mesh it gets later. Ids, as of this tick.
const std::set<uint64_t> &find_handed_over(int64_t &r_calls) {
	static std::set<uint64_t> nodes;
	static uint64_t tick = std::numeric_limits<uint64_t>::max();
	const uint64_t now = Engine::get_singleton()->get_physics_frames();
	if (tick == now) {
		return nodes;
	}
	tick = now;
	r_calls++;
	nodes.clear();
	const TypedArray<Dictionary> connections = RenderingServer::get_singleton()->get_signal_connection_list("frame_pre_draw");
	for (int64_t i = 0; i < connections.size(); i++) {
		const Callable listener = Dictionary(connections[i])["callable"];
		if (const SoftBody3D *node = Object::cast_to<SoftBody3D>(listener.get_object())) {
			nodes.insert(node->get_instance_id());
		}
	}
	return nodes;
}

} // namespace

// Returns whether its points can be read. A body that its node removed from the server has no points, and reading them there is an error.
bool SoftBodies::is_ready(const SoftBody3D *p_node) {
	const Ref<Mesh> mesh = p_node->get_mesh();
	_reads.engine_calls += 2;
	if (mesh.is_null() || !find_handed_over(_reads.engine_calls).contains(p_node->get_instance_id()) || is_removed(p_node)) {
		return false;
	}
	const uint64_t frame = Engine::get_singleton()->get_process_frames();
	Shown &shown = _shown[p_node->get_instance_id()];
	const int64_t surfaces = mesh->get_surface_count();
	_reads.engine_calls++;
	if (shown.mesh != mesh->get_instance_id()) {
		shown = { mesh->get_instance_id(), frame, surfaces > 0 };
	}
	return shown.has_points && surfaces > 0 && frame >= shown.frame + MESH_FRAMES;
}

Eigen::AlignedBox3d SoftBodies::find_box(const SoftBody3D *p_node) {
	const RID body = p_node->get_physics_rid();
	if (!is_ready(p_node) || !body.is_valid()) { // an engine without soft bodies has none
		return {};
	}
	const AABB bounds = PhysicsServer3D::get_singleton()->soft_body_get_bounds(body);
	_reads.engine_calls += 2;
	return { to_eigen(bounds.position), to_eigen(bounds.get_end()) };
}

void SoftBodies::read_mesh(const Ref<Mesh> &p_mesh, Body &r_body) {
	r_body = Body();
	r_body.mesh = p_mesh->get_instance_id();
	if (p_mesh->get_surface_count() == 0) {
		return;
	}
	const Array arrays = p_mesh->surface_get_arrays(0); // the server simulates no other surface
	const PackedVector3Array vertices = arrays[Mesh::ARRAY_VERTEX];
	const PackedInt32Array indices = arrays[Mesh::ARRAY_INDEX];
	std::vector<int> faces;
	const int64_t count = indices.is_empty() ? vertices.size() : indices.size();
	for (int64_t i = 0; i < count; i++) {
		faces.push_back(indices.is_empty() ? int(i) : indices[i]);
	}
	r_body.parts = SoftParts(to_eigen(vertices), faces);
	r_body.motions.resize(size_t(r_body.parts.get_count()));
}

// Reads the points, unless the body sleeps where it was.
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
		uint64_t p_owner, const FieldReach &p_reach, const MotionTick &p_tick, Body &r_body, std::vector<ColliderShape> &r_colliders) {
	std::vector<Eigen::Vector3d> places;
	places.reserve(r_body.places.size());
	for (const Vector3 &place : r_body.places) {
		places.emplace_back(p_reach.from_world * to_eigen(place));
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

void SoftBodies::collect(const FieldReach &p_reach, const MotionTick &p_tick, std::vector<ColliderShape> &r_colliders) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	std::map<uint64_t, Body> still_near;
	for (const SoftBody3D *node : SceneWatch::get_singleton()->get_soft_bodies()) {
		_reads.engine_calls += 2;
		if ((node->get_collision_layer() & p_reach.mask) == 0 || node->get_world_3d() != p_reach.world || !is_ready(node)) {
			continue;
		}
		const AABB bounds = server->soft_body_get_bounds(node->get_physics_rid());
		_reads.engine_calls += 2;
		const Eigen::Vector3d corner = to_eigen(bounds.position);
		if (!p_reach.is_near_global({ corner, corner + to_eigen(bounds.size) })) {
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
		write(id, p_reach, p_tick, body, r_colliders);
	}
	_bodies.swap(still_near);
	if (_shown.size() > SceneWatch::get_singleton()->count_soft_bodies()) {
		std::erase_if(_shown, [](const auto &p_entry) { return ObjectDB::get_instance(p_entry.first) == nullptr; });
	}
}

} // namespace grass
