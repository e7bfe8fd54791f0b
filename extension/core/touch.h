// SPDX-License-Identifier: MIT
// What METHOD_DIRECT's solve knows of a surface: the deepest touch of a knot. Twin of shaders/compute/touch.inc.
#pragma once

#include "core/shape.h"

namespace grass {

// Knots nearer than this to a surface feel it, segment lengths: so a blade that is held stands in its surface's skin,
// with a force, and not to and fro across the surface.
inline constexpr float SKIN = 0.06f;

// A knot at a surface.
template <class T> struct Touch {
	Vec3<T> normal{}; // of the surface, blade space
	Vec3<T> slip{}; // way along the surface since the start of the step, metres
	T depth = T(0.0f); // below the skin, metres; 0: no touch
	T friction = T(0.0f);
};

// [Eq 31] The deepest touch of knot p_knot, which was at p_from (blade space) at the start of the step.
template <class T>
GRASS_INLINE Touch<T> find_touch(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Vec3<T> &p_from, int p_knot) {
	const Vec3<T> to = p_blade.knots[p_knot];
	const T l = p_blade.lengths[p_knot - 1];
	const T skin = l * T(SKIN);
	Touch<T> deepest;
	const T below = minimum(p_terms.ground_gap * l + skin, p_blade.rest[p_knot].y) - to.y;
	if (any(below > T(0.0f))) {
		const Vec3<T> way = to - p_from;
		deepest.normal = { T(0.0f), T(1.0f), T(0.0f) };
		deepest.slip = { way.x, T(0.0f), way.z };
		deepest.depth = maximum(below, T(0.0f));
	}
	for (const TileCollider &collider : p_terms.colliders) {
		if (!any(comes_within(collider, p_blade.root, p_blade.reach * T(REACH_MARGIN)))) {
			continue;
		}
		const Path<T> path = relative_path(collider, p_blade.root, p_from, to);
		const Face<T> face = sweep(collider, path, ground_under(collider, to.y));
		const T depth = skin - face.distance;
		const auto is_deeper = depth > deepest.depth;
		if (any(is_deeper)) {
			const Turn<T> turn = widened<T>(collider.turn);
			const Vec3<T> way = path.to - path.from;
			const Vec3<T> slip = way - face.normal * dot(way, face.normal);
			deepest.normal = select(is_deeper, turned(turn, face.normal), deepest.normal);
			deepest.slip = select(is_deeper, turned(turn, slip), deepest.slip);
			deepest.depth = select(is_deeper, depth, deepest.depth);
			deepest.friction = select(is_deeper, p_terms.friction * T(collider.friction), deepest.friction);
		}
	}
	return deepest;
}

} // namespace grass
