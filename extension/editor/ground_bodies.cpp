// SPDX-License-Identifier: MIT
#include "editor/ground_bodies.h"

#include "physics/ground_rays.h"
#include "shared/convert.h"
#include "shared/same_data.h"

#include <godot_cpp/classes/csg_shape3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/classes/static_body3d.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr double ENDLESS = 1e5; // metres: the assumed extent of an infinite plane

Eigen::AlignedBox3d box_of_half(const Eigen::Vector3d &p_half) {
	return { -p_half, p_half };
}

Eigen::AlignedBox3d box_of_points(const PackedVector3Array &p_points) {
	Eigen::AlignedBox3d box;
	for (int64_t i = 0; i < p_points.size(); i++) {
		box.extend(to_eigen(p_points[i]));
	}
	return box;
}

Eigen::AlignedBox3d box_of_heights(const Dictionary &p_data) {
	const PackedRealArray heights = p_data["heights"];
	const double half_width = 0.5 * (double(p_data["width"]) - 1.0), half_depth = 0.5 * (double(p_data["depth"]) - 1.0);
	Eigen::AlignedBox3d box;
	for (int64_t i = 0; i < heights.size(); i++) {
		if (std::isfinite(heights[i])) { // otherwise a hole
			box.extend(Eigen::Vector3d(-half_width, double(heights[i]), -half_depth));
			box.extend(Eigen::Vector3d(half_width, double(heights[i]), half_depth));
		}
	}
	return box;
}

Eigen::AlignedBox3d box_of_shape(int64_t p_type, const Variant &p_data) {
	switch (p_type) {
		case PhysicsServer3D::SHAPE_SPHERE:
			return box_of_half(Eigen::Vector3d::Constant(double(p_data)));
		case PhysicsServer3D::SHAPE_BOX:
			return box_of_half(to_eigen(Vector3(p_data)));
		case PhysicsServer3D::SHAPE_CAPSULE:
		case PhysicsServer3D::SHAPE_CYLINDER: {
			const Dictionary data = p_data;
			const double radius = data["radius"], height = data["height"];
			return box_of_half({ radius, 0.5 * height, radius });
		}
		case PhysicsServer3D::SHAPE_CONVEX_POLYGON:
			return box_of_points(p_data);
		case PhysicsServer3D::SHAPE_CONCAVE_POLYGON:
			return box_of_points(Dictionary(p_data)["faces"]);
		case PhysicsServer3D::SHAPE_HEIGHTMAP:
			return box_of_heights(p_data);
		case PhysicsServer3D::SHAPE_WORLD_BOUNDARY:
			return box_of_half(Eigen::Vector3d::Constant(ENDLESS));
		default:
			return {};
	}
}

GroundBody::Shape read_shape_at(const RID &p_body, int32_t p_index, const GroundBody &p_before) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const RID shape = server->body_get_shape(p_body, p_index);
	GroundBody::Shape read;
	read.id = shape.get_id();
	read.transform = server->body_get_shape_transform(p_body, p_index);
	read.data = server->shape_get_data(shape);
	const bool is_known = size_t(p_index) < p_before.shapes.size() && p_before.shapes[size_t(p_index)].id == read.id;
	const GroundBody::Shape before = is_known ? p_before.shapes[size_t(p_index)] : GroundBody::Shape();
	const bool is_same = is_known && is_same_data(before.data, read.data);
	read.box = is_same ? before.box : box_of_shape(server->shape_get_type(shape), read.data);
	read.changes = before.changes + (is_known && !is_same ? 1 : 0);
	return read;
}

} // namespace

bool GroundBody::Shape::operator==(const Shape &p_other) const {
	const bool is_same_box = (box.isEmpty() && p_other.box.isEmpty()) || (box.min() == p_other.box.min() && box.max() == p_other.box.max());
	return id == p_other.id && transform == p_other.transform && is_same_box && changes == p_other.changes;
}

Eigen::AlignedBox3d GroundBody::get_box() const {
	Eigen::AlignedBox3d all;
	for (const Shape &shape : shapes) {
		if (!shape.box.isEmpty()) {
			all.extend(shape.box.transformed(to_eigen(transform * shape.transform)));
		}
	}
	return all;
}

std::vector<uint64_t> find_ground_bodies(Node *p_root) {
	std::vector<uint64_t> ids;
	const auto add = [&](Node *p_node) {
		if (Object::cast_to<CSGShape3D>(p_node) || (Object::cast_to<StaticBody3D>(p_node) && !moves_about(p_node))) {
			ids.push_back(p_node->get_instance_id());
		}
	};
	add(p_root);
	for (const char *type : { "StaticBody3D", "CSGShape3D" }) {
		const TypedArray<Node> nodes = p_root->find_children("*", type, true, false);
		for (int64_t i = 0; i < nodes.size(); i++) {
			add(Object::cast_to<Node>(static_cast<Object *>(nodes[i])));
		}
	}
	return ids;
}

GroundBody read_ground_body(const Node3D *p_node, const GroundBody &p_before) {
	GroundBody body;
	if (!p_node->is_inside_tree()) {
		return body;
	}
	body.transform = p_node->get_global_transform();
	if (const CSGShape3D *csg = Object::cast_to<CSGShape3D>(p_node)) {
		if (csg->is_using_collision() && csg->is_root_shape()) {
			const AABB box = csg->get_aabb();
			body.shapes.push_back({ 0, Transform3D(), { to_eigen(box.position), to_eigen(box.position + box.size) }, Variant(), 0 });
		}
	} else if (const StaticBody3D *still = Object::cast_to<StaticBody3D>(p_node)) {
		for (int32_t i = 0; i < PhysicsServer3D::get_singleton()->body_get_shape_count(still->get_rid()); i++) {
			body.shapes.push_back(read_shape_at(still->get_rid(), i, p_before));
		}
	}
	return body;
}

} // namespace grass
