// SPDX-License-Identifier: MIT
// What METHOD_DIRECT's solve knows of a surface: the deepest touch of a knot. Twin of shaders/solver/touch.inc.
#pragma once

#include "core/solver/edge.h"
#include "core/solver/shape.h"

namespace grass {

// A knot at a surface.
template <class T> struct Touch {
	Vec3<T> normal{}; // of the surface, blade space
	Vec3<T> slip{}; // way along the surface since the start of the step, metres
	T depth = T(0.0f); // below the skin, metres; 0: no touch
	T held = T(0.0f); // the depth at the start of the step, of the plane that is touched now
	T friction = T(0.0f);
};

// [Eq 31] What knot p_knot, which was at p_from (blade space) at the start of the step, feels of the ground.
template <class T>
GRASS_INLINE Touch<T> find_ground_touch(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Vec3<T> &p_from, int p_knot) {
	const Vec3<T> way = p_blade.knots[p_knot] - p_from;
	const T l = p_blade.lengths[p_knot - 1];
	const T height = minimum(p_terms.ground_gap * l + l * T(SKIN), p_blade.rest[p_knot].y);
	return { { T(0.0f), T(1.0f), T(0.0f) }, { way.x, T(0.0f), way.z }, maximum(height - p_blade.knots[p_knot].y, T(0.0f)),
		height - p_from.y, p_terms.friction * T(GROUND_FRICTION) };
}

// The deepest touch of a collider.
template <class T>
GRASS_INLINE Touch<T> find_touch(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Vec3<T> &p_from, int p_knot) {
	const Vec3<T> to = p_blade.knots[p_knot];
	const T l = p_blade.lengths[p_knot - 1];
	const T skin = l * T(SKIN);
	const Vec3<T> from = p_from + p_blade.root, place = to + p_blade.root;
	Touch<T> deepest;
	for (const TileCollider &collider : p_terms.colliders) {
		const auto is_clear = passes_by(collider, extent_of(from, from), extent_of(place, place), skin);
		if (!any(comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN)) & !is_clear)) {
			continue;
		}
		const Path<T> path = relative_path(collider, p_blade.root, p_from, to);
		const Face<T> face = sweep(collider, path, ground_under(collider, to.y));
		const T depth = skin - face.distance;
		auto is_deeper = depth > deepest.depth;
		if (any(is_deeper)) {
			const Turn<T> turn = widened<T>(collider.turn);
			const Vec3<T> normal = turned(turn, face.normal);
			is_deeper = is_deeper & !(cuts(collider, l) & is_of_edge(p_blade, p_knot, normal));
			const Vec3<T> way = path.to - path.from;
			const T inwards = T(0.0f) - dot(way, face.normal);
			const Vec3<T> slip = way + face.normal * inwards;
			deepest.normal = select(is_deeper, normal, deepest.normal);
			deepest.slip = select(is_deeper, turned(turn, slip), deepest.slip);
			deepest.depth = select(is_deeper, depth, deepest.depth);
			deepest.held = select(is_deeper, depth - inwards, deepest.held);
			deepest.friction = select(is_deeper, p_terms.friction * T(collider.friction), deepest.friction);
		}
	}
	return deepest;
}

// [Eq 33] The deepest touch of the edge from knot p_knot - 1 to p_knot, where that is between them; r_share: where. The edge's knots
// were at p_from_a and p_from_b at the start of the step.
template <class T>
GRASS_INLINE Touch<T> find_edge_touch(
		const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Vec3<T> &p_from_a, const Vec3<T> &p_from_b, int p_knot, T &r_share) {
	const Vec3<T> to_a = p_blade.knots[p_knot - 1], to_b = p_blade.knots[p_knot];
	const T l = p_blade.lengths[p_knot - 1];
	const T skin = l * T(SKIN);
	Touch<T> deepest;
	for (const TileCollider &collider : p_terms.colliders) {
		if (!any(cuts(collider, l) & !is_edge_clear(collider, p_blade.root, p_from_a, p_from_b, to_a, to_b, skin))) {
			continue;
		}
		const Path<T> path_a = relative_path(collider, p_blade.root, p_from_a, to_a);
		const Path<T> path_b = relative_path(collider, p_blade.root, p_from_b, to_b);
		const Edge<T> edge = sweep_edge(collider, path_a, path_b, skin);
		const T depth = skin - edge.face.distance;
		const T height = to_a.y + (to_b.y - to_a.y) * edge.share;
		const auto is_deeper = cuts(collider, l) & is_between_knots(edge) & (depth > deepest.depth) &
				!is_blocked(edge.face, ground_under(collider, height));
		if (any(is_deeper)) {
			const Turn<T> turn = widened<T>(collider.turn);
			const Vec3<T> way_a = path_a.to - path_a.from, way_b = path_b.to - path_b.from;
			const Vec3<T> way = way_a + (way_b - way_a) * edge.share;
			const T inwards = T(0.0f) - dot(way, edge.face.normal);
			const Vec3<T> slip = way + edge.face.normal * inwards;
			deepest.normal = select(is_deeper, turned(turn, edge.face.normal), deepest.normal);
			deepest.slip = select(is_deeper, turned(turn, slip), deepest.slip);
			deepest.depth = select(is_deeper, depth, deepest.depth);
			deepest.held = select(is_deeper, depth - inwards, deepest.held);
			deepest.friction = select(is_deeper, p_terms.friction * T(collider.friction), deepest.friction);
			r_share = select(is_deeper, edge.share, r_share);
		}
	}
	return deepest;
}

// [Eq 33] The share of an edge's touch that its knots' touches, p_first and p_second, do not feel already. So what the edge does begins
// with nothing where its deepest point leaves a knot.
template <class T> GRASS_INLINE T own_share(const Touch<T> &p_edge, const Touch<T> &p_first, const Touch<T> &p_second) {
	const T felt = maximum(p_first.depth * dot(p_first.normal, p_edge.normal), p_second.depth * dot(p_second.normal, p_edge.normal));
	return T(1.0f) - minimum(maximum(felt, T(0.0f)) / maximum(p_edge.depth, T(1e-12f)), T(1.0f));
}

} // namespace grass
