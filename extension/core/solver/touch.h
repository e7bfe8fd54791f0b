// SPDX-License-Identifier: MIT
// The surface that METHOD_DIRECT's solve considers: the deepest touch of a knot. Twin of shaders/solver/touch.inc.
#pragma once

#include "core/solver/edge.h"
#include "core/solver/shape.h"

namespace grass {

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
		const Path<T> path = relative_path(collider, p_blade.root, p_from, to);
		const Face<T> face = sweep(collider, path, ground_under(collider, to.y));
		const T depth = skin - face.distance;
		auto is_deeper = may_touch & (depth > deepest.depth);
		if (any(is_deeper)) {
			const Touch<T> touch = make_touch(collider, face, path.to - path.from, skin, p_terms.friction);
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
		const Path<T> path_a = relative_path(collider, p_blade.root, p_from_a, to_a);
		const Path<T> path_b = relative_path(collider, p_blade.root, p_from_b, to_b);
		const Edge<T> edge = sweep_edge(collider, path_a, path_b, skin);
		const T depth = skin - edge.face.distance;
		const T height = to_a.y + (to_b.y - to_a.y) * edge.share;
		const auto is_deeper =
				may_touch & is_between_knots(edge) & (depth > deepest.depth) & !is_blocked(edge.face, ground_under(collider, height));
		if (any(is_deeper)) {
			const Vec3<T> way_a = path_a.to - path_a.from, way_b = path_b.to - path_b.from;
			const Vec3<T> way = way_a + (way_b - way_a) * edge.share;
			deepest = select(is_deeper, make_touch(collider, edge.face, way, skin, p_terms.friction), deepest);
			r_share = select(is_deeper, edge.share, r_share);
		}
	}
	return deepest;
}

} // namespace grass
