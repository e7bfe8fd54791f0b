// SPDX-License-Identifier: MIT
// How a knot relates to a collider: the nearest surface, the entry point of a path, the contact. Compiles shaders/bodies/leaves.inc as C++,
// and is the twin of shaders/bodies/collider.inc. Every shape is convex, and a face is a supporting plane: whatever is outside the plane is
// outside the shape.
#pragma once

#include "core/base/layout.h"
#include "core/base/vector.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace grass {

#define GRASS_CONSTANT inline constexpr
#include "bodies/constants.inc"
#undef GRASS_CONSTANT

// A plane n.x = d with the shape behind it, and a point's distance in front of it (metres, negative inside).
template <class T> struct Face {
	Vec3<T> normal;
	T distance{};

	GRASS_INLINE Face() = default;
	GRASS_INLINE Face(const Vec3<T> &p_normal, const T &p_distance) : normal(p_normal), distance(p_distance) {}
};
template <class T> GRASS_INLINE Vec3<T> normal_of(const Face<T> &p_face) {
	return p_face.normal;
}
template <class T> GRASS_INLINE T distance_of(const Face<T> &p_face) {
	return p_face.distance;
}
template <class T, class Mask> GRASS_INLINE Face<T> select(const Mask &p_mask, const Face<T> &p_a, const Face<T> &p_b) {
	return { select(p_mask, p_a.normal, p_b.normal), select(p_mask, p_a.distance, p_b.distance) };
}

// A collider as the blades of one tile see it: everything about it that is the same for all of them.
struct TileCollider {
	int shape = GRASS_SPHERE;
	Vec3<float> size, centre, centre_before; // metres, relative to the tile's centre on the ground
	Turn<float> turn, turn_before; // from the collider's axes to the field's
	float friction = 0.0f;
	float bound = 0.0f; // radius of a sphere about the centre, metres
	Vec3<float> box; // half extents of a box about the centre, along the field's axes, at the end of the step, metres
	float shortfall = 0.0f; // how many times farther from a point than the face in front of it the shape can be
	float grown = 1.0f; // its size at the end of the step over that at the start
	float scale = 1.0f; // of its planes, which are those at the end of the whole step
	float spin = 0.0f; // how far its turn during the step moves a point, as a share of the point's distance from the centre
	float moved = 0.0f; // the farthest that the step moves any point of it that a blade may meet, metres
	float thin = 0.0f; // no shorter path can cross the shape, metres
	float blunt = 0.0f; // knots up to this far apart reveal whatever a blade's edges cut, metres
	std::span<const Eigen::Vector4f> planes; // of hulls
};

// Returns whether a blade with segments of p_segment metres can cut the collider without any of its knots revealing it, however far a solve
// stretches the blade.
bool is_sharp(const GrassCollider &p_collider, float p_segment);

// Converts p_collider for the tile at (p_tile_x, p_tile_z). Returns false if one of its numbers is not finite or a plane is missing.
bool make_tile_collider(const GrassCollider &p_collider, int p_tile_x, int p_tile_z, float p_tile_size,
		std::span<const Eigen::Vector4f> p_planes, TileCollider &r_collider);

// Returns the collider as it moves from share p_from to share p_to of the step.
TileCollider between(const TileCollider &p_collider, float p_from, float p_to);

#include "core/base/lane_words.h"

#include "bodies/leaves.inc"

#include "core/base/lane_words_end.h"

// [Eq 10] Returns the face of a hull.
template <class T> GRASS_INLINE Face<T> hull_face(const TileCollider &p_collider, const Vec3<T> &p_point, const Ground<T> &p_ground) {
	Face<T> face{ { T(0.0f), T(1.0f), T(0.0f) }, T(-2.0f * BLOCKED) };
	for (const Eigen::Vector4f &plane : p_collider.planes) {
		const Vec3<T> normal{ T(plane.x()), T(plane.y()), T(plane.z()) };
		face = outer(face, { normal, dot(normal, p_point) - T(plane.w() * p_collider.scale) }, p_ground);
	}
	return face;
}

// [Eq 10] Returns the face nearest to a point in the shape's own axes.
template <class T> GRASS_INLINE Face<T> find_face(const TileCollider &p_collider, const Vec3<T> &p_point, const Ground<T> &p_ground) {
	const Vec3<T> size = widened<T>(p_collider.size);
	switch (p_collider.shape) {
		case GRASS_CAPSULE:
			return capsule_face(size, p_point, p_ground);
		case GRASS_BOX:
			return box_face(size, p_point, p_ground);
		case GRASS_CYLINDER:
			return cylinder_face(size, p_point, p_ground);
		case GRASS_HULL:
			return hull_face(p_collider, p_point, p_ground);
		default:
			return sphere_face(size, p_point, p_ground);
	}
}
// Returns the same for a point that is outside, or where the ground does not matter.
template <class T> GRASS_INLINE Face<T> find_face(const TileCollider &p_collider, const Vec3<T> &p_point) {
	return find_face(p_collider, p_point, Ground<T>{ {}, T(0.0f) });
}

GRASS_INLINE bool is_round(const TileCollider &p_collider) {
	return p_collider.shape == GRASS_SPHERE || p_collider.shape == GRASS_CAPSULE;
}

// Returns whether the collider does not move in this step, and keeps its size.
GRASS_INLINE bool stands_still(const TileCollider &p_collider) {
	const Vec3<float> way = p_collider.centre - p_collider.centre_before;
	const Vec3<float> axis = p_collider.turn.axis - p_collider.turn_before.axis;
	const float w = p_collider.turn.w - p_collider.turn_before.w;
	return dot(way, way) + dot(axis, axis) + w * w <= 0.0f && p_collider.grown == 1.0f;
}

// A knot's path during the step: from its start to its end, each in the shape's own axes at that time.
template <class T> struct Path { Vec3<T> from, to; };

template <class T>
GRASS_INLINE Path<T> relative_path(const TileCollider &p_collider, const Vec3<T> &p_root, const Vec3<T> &p_from, const Vec3<T> &p_to) {
	return { place_before(p_collider, p_root, p_from), place_now(p_collider, p_root, p_to) };
}

// [Eq 11] Returns the face that a path meets, moved along to the path's end: its distance says how far the end is behind it. The distance
// is not negative if the end is outside and the path met no face.
template <class T> GRASS_INLINE Face<T> sweep(const TileCollider &p_collider, const Path<T> &p_path, const Ground<T> &p_ground) {
	const Vec3<T> way = p_path.to - p_path.from;
	const T squared = dot(way, way);
	Face<T> face = find_face(p_collider, p_path.to, p_ground);

	// Find where the path comes nearest to the centre, and whether that is within the bounding sphere.
	const T safe = maximum(squared, T(TINY_SQUARED));
	const T nearest = -dot(p_path.from, way) / safe;
	const Vec3<T> middle = p_path.from + way * minimum(maximum(nearest, T(0.0f)), T(1.0f));
	const T bound(p_collider.bound);
	const auto may_meet =
			((face.distance < T(0.0f)) | (squared > T(p_collider.thin * p_collider.thin))) & (dot(middle, middle) < bound * bound);
	if (!any(may_meet)) {
		return face;
	}
	const T near = T(TRACE_NEAR) * bound;
	const Vec3<T> line = p_path.from + way * nearest;
	const T chord = square_root(maximum(bound * bound - dot(line, line), T(0.0f)) / safe);
	const T inverse_length = T(1.0f) / square_root(safe);
	T t = maximum(nearest - chord, T(0.0f));
	Face<T> entry{};
	Vec3<T> place{};
	auto goes_on = may_meet;
	for (int i = 0; i < TRACE_STEPS && any(goes_on); i++) {
		place = select(goes_on, p_path.from + way * t, place);
		entry = find_face(p_collider, place);
		t = select(goes_on, t + maximum(entry.distance, T(0.0f)) * inverse_length, t);
		goes_on = goes_on & (t <= T(1.0f)) & (entry.distance > T(TRACE_END) * bound);
	}
	if (!any(may_meet & (t <= T(1.0f)))) {
		return face;
	}
	// A path that began inside has no entry. A path that met a face above the ground has no way out through it. Both leave by the nearest
	// face.
	const Face<T> met{ entry.normal, dot(entry.normal, p_path.to - place) + entry.distance };
	const auto is_met = may_meet & (t <= T(1.0f)) & (entry.distance < near) & !is_blocked(met, p_ground) &
			(find_face(p_collider, p_path.from).distance > -near);
	return { select(is_met, met.normal, face.normal), select(is_met, met.distance, face.distance) };
}

} // namespace grass
