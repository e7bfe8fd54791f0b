// SPDX-License-Identifier: MIT
// Where a knot stands to a collider: surface, entry point of a path, correction. Twin of shaders/bodies/collider.inc.
// Every shape is convex, and a face is a supporting plane: what is outside of the plane is outside of the shape.
#pragma once

#include "core/base/layout.h"
#include "core/base/vector.h"

#include <Eigen/Core>

#include <span>

namespace grass {

#define GRASS_CONSTANT inline constexpr
#include "bodies/constants.inc"
#undef GRASS_CONSTANT

// A plane n.x = d that the shape lies behind, and how far in front of it a point is (metres, negative inside).
template <class T> struct Face {
	Vec3<T> normal;
	T distance;
};

// A collider as one tile's blades see it: turned into numbers that do not differ between them.
struct TileCollider {
	int shape = GRASS_SPHERE;
	Vec3<float> size, centre, centre_before; // metres, from the tile's centre on the ground
	Turn<float> turn, turn_before; // from the collider's own axes to the field's
	float friction = 0.0f;
	float bound = 0.0f; // radius about the centre, metres
	Vec3<float> box; // half extents of a box about the centre, the field's axes, at the end of the step, metres
	float shortfall = 0.0f; // how many times farther away than a face in front of a point the shape can be
	float spin = 0.0f; // how far its turn during the step moves a point, shares of the distance from the centre
	float thin = 0.0f; // no path shorter than this can cross the shape, metres
	float blunt = 0.0f; // what knots no farther apart than this show is all that edges cut, metres
	std::span<const Eigen::Vector4f> planes; // hulls
};

// Whether a blade with segments of p_segment metres can cut the collider where no knot of it shows that, however far a solve stretches it.
bool is_sharp(const GrassCollider &p_collider, float p_segment);

// p_collider for the tile at (p_tile_x, p_tile_z). False if a number in it is not finite or a plane is missing.
bool make_tile_collider(const GrassCollider &p_collider, int p_tile_x, int p_tile_z, float p_tile_size,
		std::span<const Eigen::Vector4f> p_planes, TileCollider &r_collider);

template <class T> GRASS_INLINE Vec3<T> widened(const Vec3<float> &p_a) {
	return { T(p_a.x), T(p_a.y), T(p_a.z) };
}
template <class T> GRASS_INLINE Turn<T> widened(const Turn<float> &p_a) {
	return { widened<T>(p_a.axis), T(p_a.w) };
}

// What a collider stands on, in its own axes: a knot may not be pushed farther down than there is room above the ground.
template <class T> struct Ground {
	Vec3<T> up; // unit
	T room; // metres
};

// Whether leaving by the face would lead into the ground.
template <class T> GRASS_INLINE auto is_blocked(const Face<T> &p_face, const Ground<T> &p_ground) {
	return p_face.distance * minimum(dot(p_face.normal, p_ground.up), T(0.0f)) > p_ground.room;
}

// The one of two faces that is nearer to a point behind both, but one that is open before one that is blocked.
template <class T> GRASS_INLINE Face<T> outer(const Face<T> &p_a, const Face<T> &p_b, const Ground<T> &p_ground) {
	const T score_a = p_a.distance - select(is_blocked(p_a, p_ground), T(BLOCKED), T(0.0f));
	const T score_b = p_b.distance - select(is_blocked(p_b, p_ground), T(BLOCKED), T(0.0f));
	const auto is_b = score_b > score_a;
	return { select(is_b, p_b.normal, p_a.normal), select(is_b, p_b.distance, p_a.distance) };
}

// A round face at p_out from the axis or centre. Where it is blocked, the way out is level: [Eq 21].
template <class T>
GRASS_INLINE Face<T> round_face(const Vec3<T> &p_out, const T &p_radius, const Vec3<T> &p_fallback, const Ground<T> &p_ground) {
	const Face<T> face{ normalized(p_out, p_fallback), length(p_out) - p_radius };
	const auto is_level = is_blocked(face, p_ground);
	if (!any(is_level)) {
		return face;
	}
	const T height = dot(p_out, p_ground.up);
	const Vec3<T> level = p_out - p_ground.up * height;
	const T level_radius = square_root(maximum(p_radius * p_radius - height * height, T(0.0f)));
	return { select(is_level, normalized(level, perpendicular(p_ground.up)), face.normal),
		select(is_level, length(level) - level_radius, face.distance) };
}

// [Eq 10] The face nearest to a point in the shape's own axes; on the axis or at the centre a fixed one.
template <class T> GRASS_INLINE Face<T> find_face(const TileCollider &p_collider, const Vec3<T> &p_point, const Ground<T> &p_ground) {
	const T zero(0.0f), one(1.0f);
	const Vec3<T> size = widened<T>(p_collider.size);
	const T sign_y = select(p_point.y < zero, -one, one);
	switch (p_collider.shape) {
		case GRASS_CAPSULE: {
			const T along = minimum(maximum(p_point.y, -size.y), size.y);
			return round_face({ p_point.x, p_point.y - along, p_point.z }, size.x, { one, zero, zero }, p_ground);
		}
		case GRASS_BOX: {
			const T sign_x = select(p_point.x < zero, -one, one);
			const T sign_z = select(p_point.z < zero, -one, one);
			const Face<T> side_x{ { sign_x, zero, zero }, p_point.x * sign_x - size.x };
			const Face<T> side_y{ { zero, sign_y, zero }, p_point.y * sign_y - size.y };
			const Face<T> side_z{ { zero, zero, sign_z }, p_point.z * sign_z - size.z };
			return outer(outer(side_x, side_y, p_ground), side_z, p_ground);
		}
		case GRASS_CYLINDER: {
			const Face<T> mantle = round_face<T>({ p_point.x, zero, p_point.z }, size.x, { one, zero, zero }, p_ground);
			const Face<T> cap{ { zero, sign_y, zero }, p_point.y * sign_y - size.y };
			return outer(mantle, cap, p_ground);
		}
		case GRASS_HULL: {
			Face<T> face{ { zero, one, zero }, T(-2.0f * BLOCKED) };
			for (const Eigen::Vector4f &plane : p_collider.planes) {
				const Vec3<T> normal{ T(plane.x()), T(plane.y()), T(plane.z()) };
				face = outer(face, { normal, dot(normal, p_point) - T(plane.w()) }, p_ground);
			}
			return face;
		}
		default:
			return round_face(p_point, size.x, { zero, one, zero }, p_ground);
	}
}
// The same for a point that is outside, or where the ground does not matter.
template <class T> GRASS_INLINE Face<T> find_face(const TileCollider &p_collider, const Vec3<T> &p_point) {
	return find_face(p_collider, p_point, Ground<T>{ {}, T(0.0f) });
}

// Whether the collider, on its way during the step, comes within p_distance (metres) of the blade's root.
template <class T> GRASS_INLINE auto comes_within(const TileCollider &p_collider, const Vec3<T> &p_root, const T &p_distance) {
	const Vec3<T> way = widened<T>(p_collider.centre - p_collider.centre_before);
	const Vec3<T> from = widened<T>(p_collider.centre_before) - p_root;
	const T t = minimum(maximum(-dot(from, way) / maximum(dot(way, way), T(TINY_SQUARED)), T(0.0f)), T(1.0f));
	const Vec3<T> nearest = from + way * t;
	const T farthest = p_distance + T(p_collider.bound);
	return dot(nearest, nearest) < farthest * farthest;
}

// Whether the collider stands still in this step.
GRASS_INLINE bool stands_still(const TileCollider &p_collider) {
	const Vec3<float> way = p_collider.centre - p_collider.centre_before;
	const Vec3<float> axis = p_collider.turn.axis - p_collider.turn_before.axis;
	const float w = p_collider.turn.w - p_collider.turn_before.w;
	return dot(way, way) + dot(axis, axis) + w * w <= 0.0f;
}

// A box with sides along the field's axes that holds some points of a blade, metres from the tile's centre on the ground.
template <class T> struct Extent { Vec3<T> low, high; };
template <class T> GRASS_INLINE Extent<T> extent_of(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { minimum(p_a, p_b), maximum(p_a, p_b) };
}

// [Eq 37] Whether points that are in p_from at the start of the step and in p_to at its end, and what is between them, surely do not meet
// the collider and come no nearer to a face of it than p_skin (metres): far cheaper than asking the shape itself. A face's distance is less
// than the true one where both are in front of a corner; the collider's turn bends paths.
template <class T>
GRASS_INLINE auto passes_by(const TileCollider &p_collider, const Extent<T> &p_from, const Extent<T> &p_to, const T &p_skin) {
	const Vec3<T> zero{};
	const Vec3<T> centre = widened<T>(p_collider.centre), centre_before = widened<T>(p_collider.centre_before);
	const Vec3<T> from_low = p_from.low - centre_before, from_high = p_from.high - centre_before;
	const Vec3<T> low = minimum(from_low, p_to.low - centre), high = maximum(from_high, p_to.high - centre);
	const Vec3<T> nearest = maximum(maximum(low, zero - high), zero);
	const Vec3<T> farthest = maximum(zero - from_low, from_high);
	const Vec3<T> size = high - low;
	const T bent = T(p_collider.spin) * (farthest.x + farthest.y + farthest.z);
	const T traced = select(size.x + size.y + size.z + bent > T(p_collider.thin), T(TRACE_NEAR * p_collider.bound), T(0.0f));
	const T shortfall(p_collider.shortfall);
	const T margin = maximum(shortfall * p_skin, shortfall * traced + bent);
	const Vec3<T> beyond = nearest - widened<T>(p_collider.box);
	const T bound = T(p_collider.bound) + margin;
	return (largest_part(beyond) > margin) | (dot(nearest, nearest) > bound * bound);
}

// A path of a knot during the step, from and to, in the shape's own axes at that time.
template <class T> struct Path { Vec3<T> from, to; };

template <class T>
GRASS_INLINE Path<T> relative_path(const TileCollider &p_collider, const Vec3<T> &p_root, const Vec3<T> &p_from, const Vec3<T> &p_to) {
	return { turned(inverse(widened<T>(p_collider.turn_before)), p_from + (p_root - widened<T>(p_collider.centre_before))),
		turned(inverse(widened<T>(p_collider.turn)), p_to + (p_root - widened<T>(p_collider.centre))) };
}

// [Eq 11] The face that a path meets, moved along to the path's end: its distance says how far the end is behind it.
// Outside, and without a face met, the distance is not negative.
template <class T> GRASS_INLINE Face<T> sweep(const TileCollider &p_collider, const Path<T> &p_path, const Ground<T> &p_ground) {
	const Vec3<T> way = p_path.to - p_path.from;
	const T squared = dot(way, way);
	Face<T> face = find_face(p_collider, p_path.to, p_ground);

	// Where the path comes nearest to the centre, and whether that is within the bounding sphere.
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
	// A path that began inside has no entry, and one that met a face above the ground no way out there: both leave by
	// the nearest face.
	const Face<T> met{ entry.normal, dot(entry.normal, p_path.to - place) + entry.distance };
	const auto is_met = may_meet & (t <= T(1.0f)) & (entry.distance < near) & !is_blocked(met, p_ground) &
			(find_face(p_collider, p_path.from).distance > -near);
	return { select(is_met, met.normal, face.normal), select(is_met, met.distance, face.distance) };
}

// The ground under a knot p_height metres above it.
template <class T> GRASS_INLINE Ground<T> ground_under(const TileCollider &p_collider, const T &p_height) {
	const Vec3<T> up = turned(inverse(widened<T>(p_collider.turn)), Vec3<T>{ T(0.0f), T(1.0f), T(0.0f) });
	return { up, maximum(p_height, T(0.0f)) };
}

// What would bring a knot out: a direction in the field's axes, and how far (metres; 0: it is not inside).
template <class T> struct Correction {
	Vec3<T> direction;
	T depth;
	Vec3<T> normal{}; // of the surface, the field's axes
};

// [Eq 12] The correction of a point behind a face that went p_way (the collider's axes) in this step. Friction takes back what it slid
// along the surface, up to the depth times p_friction.
template <class T>
GRASS_INLINE Correction<T> make_correction(
		const TileCollider &p_collider, const Face<T> &p_face, const Vec3<T> &p_way, const T &p_friction) {
	const T depth = maximum(-p_face.distance, T(0.0f));
	if (!any(depth > T(0.0f))) {
		return { {}, T(0.0f) };
	}
	const Vec3<T> slip = p_way - p_face.normal * dot(p_way, p_face.normal);
	const T slipped = length(slip);
	const T grip = minimum(T(1.0f), p_friction * T(p_collider.friction) * depth / maximum(slipped, T(1e-12f)));
	const Vec3<T> correction = p_face.normal * depth - slip * grip;
	const T size = length(correction);
	const Vec3<T> direction = normalized(correction, p_face.normal);
	const Turn<T> turn = widened<T>(p_collider.turn);
	return { turned(turn, direction), select(depth > T(0.0f), size, T(0.0f)), turned(turn, p_face.normal) };
}

// The correction of a knot that went from p_from to p_to (blade space) while the collider went from its pose before to its pose now.
template <class T>
GRASS_INLINE Correction<T> find_correction(
		const TileCollider &p_collider, const Vec3<T> &p_root, const Vec3<T> &p_from, const Vec3<T> &p_to, const T &p_friction) {
	const Path<T> path = relative_path(p_collider, p_root, p_from, p_to);
	const Face<T> face = sweep(p_collider, path, ground_under(p_collider, p_to.y));
	return make_correction(p_collider, face, path.to - path.from, p_friction);
}

} // namespace grass
