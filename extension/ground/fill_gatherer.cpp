// SPDX-License-Identifier: MIT
#include "ground/fill_gatherer.h"

#include "resources/grass_exclusion_3d.h"
#include "resources/grass_path_3d.h"
#include "shared/convert.h"
#include "shared/same_data.h"

#include <godot_cpp/classes/collision_shape3d.hpp>
#include <godot_cpp/classes/curve3d.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/path3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

Eigen::Vector2d from_above(const Eigen::Affine3d &p_pose, const Vector3 &p_point) {
	const Eigen::Vector3d at = p_pose * to_eigen(p_point);
	return { at.x(), at.z() };
}

FillObstacle obstacle_of(const Ref<Shape3D> &p_shape, const Eigen::Affine3d &p_pose, double p_height) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const RID shape = p_shape->get_rid();
	if (server->shape_get_type(shape) == PhysicsServer3D::SHAPE_CONCAVE_POLYGON) {
		const PackedVector3Array faces = Dictionary(server->shape_get_data(shape))["faces"];
		std::vector<Eigen::Vector3d> corners;
		for (int64_t i = 0; i < faces.size(); i++) {
			corners.push_back(p_pose * to_eigen(faces[i]));
		}
		return FillObstacle::mesh(std::move(corners), p_height);
	}
	TrackedShape tracked;
	read_shape(shape, tracked);
	if (tracked.parts.empty()) { // ground or rays
		return FillObstacle::line({});
	}
	return FillObstacle::solid(tracked.parts[0].shape, p_pose * tracked.parts[0].offset, p_height);
}

FillObstacle outline_of(const PackedVector2Array &p_outline, const Eigen::Affine3d &p_pose) {
	std::vector<Eigen::Vector2d> corners;
	for (int64_t i = 0; i < p_outline.size(); i++) {
		corners.push_back(from_above(p_pose, Vector3(p_outline[i].x, 0, p_outline[i].y)));
	}
	return FillObstacle::outline(std::move(corners));
}

FillObstacle line_of(const PackedVector3Array &p_points, const Eigen::Affine3d &p_pose) {
	std::vector<Eigen::Vector2d> line;
	for (int64_t i = 0; i < p_points.size(); i++) {
		line.push_back(from_above(p_pose, p_points[i]));
	}
	return FillObstacle::line(std::move(line));
}

// Returns a node's origin, or the points along a Path3D.
PackedVector3Array points_of(const Node3D *p_node) {
	const Path3D *path = Object::cast_to<Path3D>(p_node);
	PackedVector3Array points;
	if (path != nullptr && path->get_curve().is_valid()) {
		points = path->get_curve()->get_baked_points();
	}
	if (points.is_empty()) {
		points.push_back(Vector3());
	}
	return points;
}

} // namespace

bool FillGatherer::Source::is_same(const Source &p_other) const {
	return pose == p_other.pose && numbers == p_other.numbers && kind == p_other.kind && is_same_data(data, p_other.data);
}

bool FillGatherer::read_meshes(const GrassFillRule &p_rule, const Node3D *p_node, const Transform3D &p_field) {
	_field = p_node;
	_field_from_world = to_eigen(p_field).inverse(Eigen::Isometry);
	MaskMesh::Parts parts;
	for (const Node3D *node : find_nodes(p_rule.get_group(GrassFillRule::GROUP_MASK))) {
		const MeshInstance3D *instance = Object::cast_to<MeshInstance3D>(node);
		if (instance != nullptr && instance->get_mesh().is_valid()) {
			parts.push_back({ instance->get_mesh(), pose_of(instance) });
		}
	}
	_field = nullptr;
	return _mask.read(*p_node, std::move(parts));
}

FillSources FillGatherer::gather(const GrassFillRule &p_rule, const Node3D *p_node, const Transform3D &p_field) {
	_field = p_node;
	_field_from_world = to_eigen(p_field).inverse(Eigen::Isometry);
	_sources = {};
	for (auto &[id, entry] : _entries) {
		entry.is_seen = false;
	}
	add_exclusions(p_rule);
	add_paths();
	add_distances(p_rule);
	std::erase_if(_entries, [](const auto &p_entry) { return !p_entry.second.is_seen; });
	_sources.has_mesh = !String(p_rule.get_group(GrassFillRule::GROUP_MASK)).is_empty();
	_sources.mesh = _sources.has_mesh ? _mask.get() : nullptr;
	_field = nullptr;
	return std::move(_sources);
}

uint64_t FillGatherer::get_node_of(const FillObstacle *p_obstacle) const {
	const auto found = std::ranges::find_if(_entries, [&](const auto &p_entry) { return p_entry.second.obstacle.get() == p_obstacle; });
	return p_obstacle == nullptr || found == _entries.end() ? 0 : found->first;
}

Eigen::Affine3d FillGatherer::pose_of(const Node3D *p_node) const {
	return _field_from_world * to_eigen(p_node->get_global_transform());
}

std::vector<Node3D *> FillGatherer::find_nodes(const StringName &p_group) const {
	std::vector<Node3D *> nodes;
	if (String(p_group).is_empty()) {
		return nodes;
	}
	const TypedArray<Node> members = _field->get_tree()->get_nodes_in_group(p_group);
	for (int64_t i = 0; i < members.size(); i++) {
		Node3D *node = Object::cast_to<Node3D>(static_cast<Object *>(members[i]));
		if (node != nullptr && node->is_inside_tree() && node->get_world_3d() == _field->get_world_3d()) {
			nodes.push_back(node);
		}
	}
	return nodes;
}

template <typename F> void FillGatherer::add(const Node3D *p_node, const Source &p_source, F &&p_make) {
	Entry &entry = _entries[p_node->get_instance_id()];
	if (entry.is_seen) {
		return; // in the group itself, and also below a node in the group
	}
	if (!entry.source.is_same(p_source) || !entry.obstacle) {
		FillObstacle made = p_make();
		made.set_clearance(p_source.numbers[0], p_source.numbers[1]);
		entry.source = p_source;
		entry.obstacle = std::make_shared<const FillObstacle>(std::move(made));
	}
	entry.is_seen = true;
	_sources.obstacles.push_back(entry.obstacle);
}

void FillGatherer::add_shape(const Node3D *p_node, const Ref<Shape3D> &p_shape, double p_fade, double p_height) {
	const Eigen::Affine3d pose = pose_of(p_node);
	const PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const Variant data = server->shape_get_data(p_shape->get_rid());
	const int64_t kind = server->shape_get_type(p_shape->get_rid());
	add(p_node, { pose.matrix(), data, { 0.0, p_fade, p_height }, kind }, [&] { return obstacle_of(p_shape, pose, p_height); });
}

void FillGatherer::add_shapes(const GrassFillRule &p_rule, const Node *p_node) {
	const CollisionShape3D *shape = Object::cast_to<CollisionShape3D>(p_node);
	if (shape != nullptr && !shape->is_disabled() && shape->get_shape().is_valid()) {
		add_shape(shape, shape->get_shape(), p_rule.get_param(FILL_EXCLUSION_FADE), p_rule.get_param(FILL_EXCLUSION_HEIGHT));
	}
	for (int32_t i = 0; i < p_node->get_child_count(); i++) {
		add_shapes(p_rule, p_node->get_child(i));
	}
}

void FillGatherer::add_exclusions(const GrassFillRule &p_rule) {
	const double height = p_rule.get_param(FILL_EXCLUSION_HEIGHT);
	for (const GrassExclusion3D *exclusion : GrassExclusion3D::get_nodes().get_all<GrassExclusion3D>()) {
		if (!exclusion->is_enabled() || exclusion->get_world_3d() != _field->get_world_3d()) {
			continue;
		}
		if (exclusion->get_shape().is_valid()) {
			add_shape(exclusion, exclusion->get_shape(), exclusion->get_fade(), height);
		} else {
			const Eigen::Affine3d pose = pose_of(exclusion);
			const PackedVector2Array outline = exclusion->get_outline();
			add(exclusion, { pose.matrix(), outline, { 0.0, exclusion->get_fade(), 0.0 } }, [&] { return outline_of(outline, pose); });
		}
	}
	for (const Node3D *node : find_nodes(p_rule.get_group(GrassFillRule::GROUP_EXCLUSION))) {
		add_shapes(p_rule, node);
	}
}

void FillGatherer::add_distances(const GrassFillRule &p_rule) {
	const double distance = p_rule.get_param(FILL_DISTANCE), fade = p_rule.get_param(FILL_DISTANCE_FADE);
	for (const Node3D *node : find_nodes(p_rule.get_group(GrassFillRule::GROUP_DISTANCE))) {
		const Eigen::Affine3d pose = pose_of(node);
		const PackedVector3Array points = points_of(node);
		add(node, { pose.matrix(), points, { distance, fade, 0.0 } }, [&] { return line_of(points, pose); });
	}
}

void FillGatherer::add_paths() {
	for (const GrassPath3D *path : GrassPath3D::get_nodes().get_all<GrassPath3D>()) {
		if (!path->is_enabled() || path->get_world_3d() != _field->get_world_3d() || !path->concerns(_field)) {
			continue;
		}
		const Eigen::Affine3d pose = pose_of(path);
		const PackedVector3Array points = path->get_points();
		add(path, { pose.matrix(), points, { 0.5 * path->get_width(), path->get_fade(), double(path->get_mode()) } }, [&] {
			FillObstacle line = line_of(points, pose);
			line.set_planting(path->get_mode() == GrassPath3D::MODE_PLANT);
			return line;
		});
	}
}

} // namespace grass
