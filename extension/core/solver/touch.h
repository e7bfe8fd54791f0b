// SPDX-License-Identifier: MIT
// The surface that METHOD_DIRECT's solve considers: the deepest touch of a knot. Twin of shaders/solver/touch.inc
// and shaders/solver/touches.inc.
#pragma once

#include "core/solver/edge.h"
#include "core/solver/shape.h"

namespace grass {

// What a knot, or an edge, meets of a collider in the step.
template <class T> struct Meeting {
	Face<T> face; // of the collider, in its own axes
	Vec3<T> way; // of the point that meets it, relative to the collider, in the same axes, metres
	T share; // where on the edge
};

// Returns what a knot meets that moved from p_from to p_to (blade space) while the collider moved from its pose before to its pose now.
template <class T>
GRASS_INLINE Meeting<T> meet_knot(const TileCollider &p_collider, const Vec3<T> &p_root, const Vec3<T> &p_from, const Vec3<T> &p_to) {
	const Path<T> path = relative_path(p_collider, p_root, p_from, p_to);
	return { sweep(p_collider, path, ground_under(p_collider, p_to.y)), path.to - path.from, T(0.0f) };
}

// [Eq 33] Returns the same for the edge between two knots, a and b: its deepest point, if that is between them.
template <class T>
GRASS_INLINE Meeting<T> meet_edge(const TileCollider &p_collider, const Vec3<T> &p_root, const Vec3<T> &p_from_a, const Vec3<T> &p_from_b,
		const Vec3<T> &p_to_a, const Vec3<T> &p_to_b, const T &p_skin) {
	const Path<T> path_a = relative_path(p_collider, p_root, p_from_a, p_to_a);
	const Path<T> path_b = relative_path(p_collider, p_root, p_from_b, p_to_b);
	Edge<T> edge = sweep_edge(p_collider, path_a, path_b, p_skin);
	const T height = p_to_a.y + (p_to_b.y - p_to_a.y) * edge.share;
	const auto is_met = is_between_knots(edge) & !is_blocked(edge.face, ground_under(p_collider, height));
	edge.face.distance = select(is_met, edge.face.distance, T(FAR_AWAY));
	const Vec3<T> way_a = path_a.to - path_a.from, way_b = path_b.to - path_b.from;
	return { edge.face, way_a + (way_b - way_a) * edge.share, edge.share };
}

// Returns the deepest touch of a collider.
template <class T>
GRASS_INLINE Touch<T> find_touch(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Vec3<T> &p_from, int p_knot) {
	const Vec3<T> to = p_blade.knots[p_knot];
	const T l = p_blade.lengths[p_knot - 1];
	const T skin = l * T(SKIN);
	const Vec3<T> from = p_from + p_blade.root, place = to + p_blade.root;
	Touch<T> deepest{};
	for (const TileCollider &collider : p_terms.colliders) {
		const auto is_clear = passes_by(collider, extent_of(from, from), extent_of(place, place), skin);
		const auto may_touch = comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN)) & !is_clear;
		if (!any(may_touch)) {
			continue;
		}
		const Meeting<T> meeting = meet_knot(collider, p_blade.root, p_from, to);
		const T depth = skin - meeting.face.distance;
		auto is_deeper = may_touch & (depth > deepest.depth);
		if (any(is_deeper)) {
			const Touch<T> touch = make_touch(collider, meeting.face, meeting.way, skin, p_terms.friction);
			is_deeper = is_deeper & !(cuts(collider, l) & is_of_edge(p_blade, p_knot, touch.normal));
			deepest = select(is_deeper, touch, deepest);
		}
	}
	return deepest;
}

// [Eq 33] Returns the deepest touch of the edge from knot p_knot - 1 to p_knot, if it is between the knots; r_share: its place on the edge.
// The edge's knots were at p_from_a and p_from_b at the start of the step.
template <class T>
GRASS_INLINE Touch<T> find_edge_touch(
		const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Vec3<T> &p_from_a, const Vec3<T> &p_from_b, int p_knot, T &r_share) {
	const Vec3<T> to_a = p_blade.knots[p_knot - 1], to_b = p_blade.knots[p_knot];
	const T l = p_blade.lengths[p_knot - 1];
	const T skin = l * T(SKIN);
	Touch<T> deepest{};
	for (const TileCollider &collider : p_terms.colliders) {
		const auto may_touch = cuts(collider, l) & !is_edge_clear(collider, p_blade.root, p_from_a, p_from_b, to_a, to_b, skin);
		if (!any(may_touch)) {
			continue;
		}
		const Meeting<T> meeting = meet_edge(collider, p_blade.root, p_from_a, p_from_b, to_a, to_b, skin);
		const auto is_deeper = may_touch & (skin - meeting.face.distance > deepest.depth);
		if (any(is_deeper)) {
			deepest = select(is_deeper, make_touch(collider, meeting.face, meeting.way, skin, p_terms.friction), deepest);
			r_share = select(is_deeper, meeting.share, r_share);
		}
	}
	return deepest;
}

} // namespace grass
