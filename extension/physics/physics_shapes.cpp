// SPDX-License-Identifier: MIT
#include "physics/physics_shapes.h"

#include "core/bodies/hull.h"
#include "shared/convert.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// Ticks from the first check of a trimesh to its pieces. Fewer: the thread may not be done, and the tick waits.
constexpr uint64_t SPLIT_TICKS = 8;

void set_round(ColliderShape &r_shape, int p_type, const Dictionary &p_data, double p_cap) {
	const double radius = p_data["radius"], height = p_data["height"];
	r_shape.type = p_type;
	r_shape.size = { radius, std::max(0.5 * height - p_cap * radius, 0.0), 0.0 };
}

void add_hull(TrackedShape &r_tracked, const Hull &p_hull) {
	if (p_hull.planes.empty()) {
		return;
	}
	ShapePart &part = r_tracked.parts.emplace_back();
	part.shape.type = GRASS_HULL;
	part.shape.size = p_hull.half_extents;
	part.shape.planes = p_hull.planes;
	part.offset.translation() = p_hull.centre;
}

void set_hull(TrackedShape &r_tracked, const PackedVector3Array &p_points) {
	const Hull hull = Hull::make(to_eigen(p_points));
	r_tracked.is_simplified = hull.is_bound;
	add_hull(r_tracked, hull);
}

// Makes the box around the faces of a trimesh, see split_mesh().
void set_box(TrackedShape &r_tracked, const PackedVector3Array &p_faces) {
	Eigen::AlignedBox3d box;
	for (int64_t i = 0; i < p_faces.size(); i++) {
		box.extend(to_eigen(p_faces[i]));
	}
	if (!box.isEmpty()) {
		ShapePart &part = r_tracked.parts.emplace_back();
		part.shape.type = GRASS_BOX;
		part.shape.size = 0.5 * box.sizes();
		part.offset.translation() = box.center();
	}
}

void convert(TrackedShape &r_tracked) {
	r_tracked.parts.clear();
	r_tracked.pieces = MeshPieces::Future();
	r_tracked.is_split = r_tracked.is_bound = r_tracked.is_simplified = false;
	ColliderShape shape;
	switch (r_tracked.type) {
		case PhysicsServer3D::SHAPE_SPHERE:
			shape.type = GRASS_SPHERE;
			shape.size = Eigen::Vector3d(double(r_tracked.data), 0.0, 0.0);
			break;
		case PhysicsServer3D::SHAPE_BOX:
			shape.type = GRASS_BOX;
			shape.size = to_eigen(Vector3(r_tracked.data));
			break;
		case PhysicsServer3D::SHAPE_CAPSULE:
			set_round(shape, GRASS_CAPSULE, r_tracked.data, 1.0); // its height includes the caps
			break;
		case PhysicsServer3D::SHAPE_CYLINDER:
			set_round(shape, GRASS_CYLINDER, r_tracked.data, 0.0);
			break;
		case PhysicsServer3D::SHAPE_CONVEX_POLYGON:
			set_hull(r_tracked, r_tracked.data);
			return;
		case PhysicsServer3D::SHAPE_CONCAVE_POLYGON:
			set_box(r_tracked, Dictionary(r_tracked.data)["faces"]);
			return;
		default:
			return;
	}
	r_tracked.parts.emplace_back().shape = shape;
}

} // namespace

bool read_shape(const RID &p_shape, TrackedShape &r_shape, int64_t *r_calls) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const bool is_known = r_shape.type >= 0 && p_shape == r_shape.rid;
	const int64_t type = is_known ? r_shape.type : int64_t(server->shape_get_type(p_shape)); // a shape never changes its kind
	// Planes, rays and height maps are ground, not bodies in the grass; their data may be large.
	const bool is_object = type >= PhysicsServer3D::SHAPE_SPHERE && type <= PhysicsServer3D::SHAPE_CONCAVE_POLYGON &&
			type != PhysicsServer3D::SHAPE_HEIGHTMAP;
	const Variant data = is_object ? server->shape_get_data(p_shape) : Variant();
	r_shape.rid = p_shape;
	if (r_calls != nullptr) {
		*r_calls += (is_known ? 0 : 1) + (is_object ? 1 : 0);
	}
	if (type == r_shape.type && data == r_shape.data) {
		return false;
	}
	r_shape.type = type;
	r_shape.data = data;
	convert(r_shape);
	return true;
}

bool split_mesh(TrackedShape &r_shape) {
	if (r_shape.type != PhysicsServer3D::SHAPE_CONCAVE_POLYGON || r_shape.is_split || r_shape.parts.empty()) {
		return false;
	}
	const uint64_t now = Engine::get_singleton()->get_physics_frames();
	if (!r_shape.pieces.valid()) {
		r_shape.pieces = MeshPieces::begin(to_eigen(PackedVector3Array(Dictionary(r_shape.data)["faces"])));
		r_shape.pieces_due = now + SPLIT_TICKS;
	}
	if (now < r_shape.pieces_due) {
		return false;
	}
	const MeshPieces::Future pieces = r_shape.pieces;
	r_shape.pieces = MeshPieces::Future();
	r_shape.is_split = true;
	r_shape.is_bound = pieces.get().empty();
	if (r_shape.is_bound) {
		return false;
	}
	r_shape.parts.clear();
	for (const Hull &hull : pieces.get()) {
		add_hull(r_shape, hull);
	}
	return true;
}

String why_other(const TrackedShape &p_shape, const String &p_name) {
	if (p_shape.type == PhysicsServer3D::SHAPE_HEIGHTMAP) {
		return vformat("%s: it moves, but its HeightMapShape3D bends no grass, since a height map counts as ground. Add a sphere, box, "
					   "capsule, cylinder or convex polygon, or do not move it.",
				p_name);
	}
	if (p_shape.is_bound) {
		return vformat("%s: its ConcavePolygonShape3D moves and has more than %d faces, or one that is not finite, so it is not split into "
					   "convex pieces: the box around it bends the grass. Use a simpler mesh, or convex shapes.",
				p_name, int64_t(MeshPieces::MAX_FACES));
	}
	if (p_shape.is_simplified) {
		return vformat("%s: its ConvexPolygonShape3D has more than %d points or %d faces, so a bound of it with 26 sides bends the grass. "
					   "Use a simpler shape.",
				p_name, int64_t(Hull::MAX_POINTS), int64_t(Hull::MAX_PLANES));
	}
	return String();
}

} // namespace grass
