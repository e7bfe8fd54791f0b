// SPDX-License-Identifier: MIT
// How an edge, the segment between two knots, relates to a collider: finds colliders that slip between knots. Twin of
// shaders/solver/edge.inc.
#pragma once

#include "core/solver/leaves.h"

namespace grass {

// Returns true if an edge with knots at these places at the start and the end of the step (blade space) surely stays p_skin (metres) away
// from the collider.
template <class T>
GRASS_INLINE auto is_edge_clear(const TileCollider &p_collider, const Vec3<T> &p_root, const Vec3<T> &p_from_a, const Vec3<T> &p_from_b,
		const Vec3<T> &p_to_a, const Vec3<T> &p_to_b, const T &p_skin) {
	return passes_by(p_collider, extent_of(p_from_a + p_root, p_from_b + p_root), extent_of(p_to_a + p_root, p_to_b + p_root), p_skin);
}

// [Eq 33] Returns the deepest point of the edge between two points in the shape's own axes. The distance from a convex shape is convex
// along the edge, and each face gives a line below it. Each round queries the face where the lines of both sides cross; the result is the
// mixture of both faces that is level along the edge. p_cutoff (metres): beyond this distance it is enough to know that the edge is no
// nearer. p_ground: a way into it is no way out, [Eq 21].
template <class T>
GRASS_INLINE Edge<T> find_edge(
		const TileCollider &p_collider, const Vec3<T> &p_a, const Vec3<T> &p_b, const T &p_cutoff, const Ground<T> &p_ground) {
	const T zero(0.0f), one(1.0f);
	const Vec3<T> along = p_b - p_a;
	Face<T> low = find_face(p_collider, p_a, p_ground),
			high = find_face(p_collider, p_b, p_ground); // of the sides with falling and rising distance
	T fall = dot(low.normal, along), rise = dot(high.normal, along);
	const auto is_low_end = !(fall < zero);
	Edge<T> edge{ { select(is_low_end, low.normal, high.normal), select(is_low_end, low.distance, high.distance) },
		select(is_low_end, zero, one) };
	auto is_open = (fall < zero) & (rise > zero);
	if (!any(is_open)) {
		return edge;
	}
	T nearest = minimum(low.distance, high.distance);
	high.distance = high.distance - rise; // as lines over the share
	for (int i = 0;; i++) {
		const T slope = select(is_open, rise - fall, one);
		const T share = minimum(maximum((low.distance - high.distance) / slope, zero), one);
		const Vec3<T> normal = low.normal * (rise / slope) - high.normal * (fall / slope);
		const T found_size = length(normal);
		const T size = maximum(found_size, T(EDGE_FLAT));
		const T bound = (low.distance + fall * share) / size;
		const Edge<T> between{ { normal * (one / size), select(nearest < p_cutoff, bound, maximum(bound, p_cutoff)) }, share };
		const Edge<T> pierced{ { low.normal, low.distance + fall }, T(PIERCED) };
		edge = select(is_open, select(found_size < T(EDGE_FLAT), pierced, between), edge);
		is_open = is_open & (bound < p_cutoff);
		if (i == EDGE_ROUNDS || !any(is_open)) {
			return edge;
		}
		const Face<T> face = find_face(p_collider, p_a + along * share, p_ground);
		const T change = dot(face.normal, along);
		const auto is_low = is_open & (change < zero), is_high = is_open & (change > zero);
		const auto is_level = is_open & !(is_low | is_high);
		const T start = face.distance - change * share;
		nearest = minimum(nearest, face.distance);
		low = { select(is_low, face.normal, low.normal), select(is_low, start, low.distance) };
		high = { select(is_high, face.normal, high.normal), select(is_high, start, high.distance) };
		fall = select(is_low, change, fall);
		rise = select(is_high, change, rise);
		edge.face = { select(is_level, face.normal, edge.face.normal), select(is_level, face.distance, edge.face.distance) };
		edge.share = select(is_level, share, edge.share);
		is_open = is_open & !is_level;
	}
}

// Does the same where the ground does not matter.
template <class T>
GRASS_INLINE Edge<T> find_edge(const TileCollider &p_collider, const Vec3<T> &p_a, const Vec3<T> &p_b, const T &p_cutoff) {
	return find_edge(p_collider, p_a, p_b, p_cutoff, Ground<T>{ {}, T(0.0f) });
}

// [Eq 34] Does for an edge what sweep() does for a knot: returns the face that it meets while its knots move along two paths, moved along
// to the paths' end. In each iteration no point of the edge moves farther than the edge's distance.
template <class T>
GRASS_INLINE Edge<T> sweep_edge(const TileCollider &p_collider, const Path<T> &p_a, const Path<T> &p_b, const T &p_cutoff) {
	const Edge<T> last = find_edge(p_collider, p_a.to, p_b.to, p_cutoff);
	const Vec3<T> way_a = p_a.to - p_a.from, way_b = p_b.to - p_b.from;
	const T way = square_root(maximum(dot(way_a, way_a), dot(way_b, way_b)));
	const auto may_cross = way > T(p_collider.thin);
	if (!any(may_cross)) {
		return last;
	}
	const T near = T(TRACE_NEAR * p_collider.bound);
	const T per_way = T(1.0f) / maximum(way, T(1e-12f));
	T t(0.0f), first(0.0f);
	Edge<T> entry{};
	Vec3<T> place{};
	for (int i = 0; i < TRACE_STEPS; i++) {
		const Vec3<T> a = p_a.from + way_a * t, b = p_b.from + way_b * t;
		entry = find_edge(p_collider, a, b, near);
		place = a + (b - a) * entry.share;
		first = i == 0 ? entry.face.distance : first;
		t = t + maximum(entry.face.distance, T(0.0f)) * per_way;
		if (!any(may_cross & (t <= T(1.0f)))) {
			return last;
		}
	}
	const Vec3<T> end = p_a.to + (p_b.to - p_a.to) * entry.share;
	const auto is_met = may_cross & (t <= T(1.0f)) & (entry.face.distance < near) & (first > -near);
	return { { select(is_met, entry.face.normal, last.face.normal),
					 select(is_met, dot(entry.face.normal, end - place) + entry.face.distance, last.face.distance) },
		select(is_met, entry.share, last.share) };
}

} // namespace grass
