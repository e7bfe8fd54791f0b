// SPDX-License-Identifier: MIT
// How colliders and the ground act on a blade: the deepest correction bends it, and finish() leaves no knot inside. Twin of
// shaders/solver/contact.inc, and of finish() and the search in shaders/solver/finish.inc and shaders/solver/touches.inc.
#pragma once

#include "core/solver/touch.h"

namespace grass {

#include "core/base/lane_words.h"

#include "solver/plane.inc"

#include "solver/push.inc"

#include "solver/lay.inc"

#include "core/base/lane_words_end.h"

// The deepest contact of a blade, at knot `knot` (a number, since lanes differ), with the knot's position.
template <class T> struct DeepestCorrection {
	Correction<T> correction{};
	Vec3<T> place{};
	T knot = T(0.0f);
};

// Returns the correction of the edge that ends at knot p_knot, if its contact is between the edge's knots. r_share: its place on the edge.
template <class T>
GRASS_INLINE Correction<T> find_edge_correction(
		const TileCollider &p_collider, const Blade<T> &p_blade, int p_knot, const T &p_friction, T &r_share) {
	const Vec3<T> from_a = p_blade.before[p_knot - 1], from_b = p_blade.before[p_knot];
	const Vec3<T> to_a = p_blade.knots[p_knot - 1], to_b = p_blade.knots[p_knot];
	const auto may_meet = !is_edge_clear(p_collider, p_blade.root, from_a, from_b, to_a, to_b, T(0.0f));
	if (!any(may_meet)) {
		return no_correction(T(0.0f));
	}
	Meeting<T> meeting = meet_edge(p_collider, p_blade.root, from_a, from_b, to_a, to_b, T(0.0f));
	r_share = meeting.share;
	meeting.face.distance = select(may_meet, meeting.face.distance, T(FAR_AWAY));
	return make_correction(p_collider, meeting.face, meeting.way, p_friction);
}

template <class T> GRASS_INLINE DeepestCorrection<T> find_deepest_correction(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	DeepestCorrection<T> deepest;
	for (const TileCollider &collider : p_terms.colliders) {
		const auto is_near = comes_within(collider, p_blade.root, p_blade.blade_length * T(LENGTH_MARGIN));
		if (!any(is_near)) {
			continue;
		}
		for (int k = FIRST_BENDING_KNOT; k < GRASS_KNOTS; k++) {
			const Meeting<T> meeting = meet_knot(collider, p_blade.root, p_blade.before[k], p_blade.knots[k]);
			const Correction<T> correction = make_correction(collider, meeting.face, meeting.way, p_terms.friction);
			const auto is_cut = is_near & cuts(collider, p_blade.lengths[k - 1]);
			const auto is_edges = is_cut & (correction.depth < p_blade.lengths[k - 1]) & is_of_edge(p_blade, k, correction.normal);
			const auto is_deeper = is_near & (correction.depth > deepest.correction.depth) & !is_edges;
			deepest.correction.direction = select(is_deeper, correction.direction, deepest.correction.direction);
			deepest.correction.depth = select(is_deeper, correction.depth, deepest.correction.depth);
			deepest.place = select(is_deeper, p_blade.knots[k], deepest.place);
			deepest.knot = select(is_deeper, T(float(k)), deepest.knot);
			if (!any(is_cut)) {
				continue;
			}
			T share(0.0f);
			const Correction<T> edge_correction =
					apart<T>([&]() GRASS_APART { return find_edge_correction(collider, p_blade, k, p_terms.friction, share); });
			const auto is_edge = is_cut & (edge_correction.depth > deepest.correction.depth);
			deepest.correction.direction = select(is_edge, edge_correction.direction, deepest.correction.direction);
			deepest.correction.depth = select(is_edge, edge_correction.depth, deepest.correction.depth);
			deepest.place = select(is_edge, p_blade.knots[k - 1] + segment(p_blade, k - 1) * share, deepest.place);
			deepest.knot = select(is_edge, T(float(k)), deepest.knot);
		}
	}
	return deepest;
}

// Returns the moment at hinge p_knot of a force along the correction; zero beyond the corrected place.
template <class T> GRASS_INLINE Vec3<T> moment(const DeepestCorrection<T> &p_deepest, const Vec3<T> &p_hinge, int p_knot) {
	const Vec3<T> moment = cross(p_deepest.place - p_hinge, p_deepest.correction.direction);
	return select(p_deepest.knot > T(float(p_knot)), moment, Vec3<T>{});
}

// [Eq 13] Bends the blade by a correction as a force there would: every hinge below it turns in proportion to the force's moment about that
// hinge, so far that the knot comes out. Lengths stay the same; everything above the contact turns with it.
template <class T> GRASS_INLINE void bend(Blade<T> &r_blade, const DeepestCorrection<T> &p_deepest) {
	T stiffness(0.0f);
	Vec3<T> sum{};
	for (int k = 1; k < GRASS_SEGMENTS; k++) {
		const Vec3<T> turn = moment(p_deepest, r_blade.knots[k], k);
		stiffness = stiffness + dot(turn, turn);
		sum = sum + turn;
	}
	const Correction<T> &correction = p_deepest.correction;
	const T strength = bend_strength(correction.direction, correction.depth, p_deepest.place - r_blade.knots[1], sum, stiffness);

	Vec3<T> angle{}, shift{};
	Vec3<T> hinge = r_blade.knots[1];
	for (int k = 1; k < GRASS_SEGMENTS; k++) {
		const Vec3<T> next = r_blade.knots[k + 1];
		angle = angle + moment(p_deepest, hinge, k) * strength;
		shift = shift + turn_change(turn_by(angle), next - hinge);
		r_blade.knots[k + 1] = next + shift;
		hinge = next;
	}
}

// [Eq 16] Turns a knot about its parent until it is outside every collider. p_gap: its least height.
template <class T>
GRASS_INLINE Vec3<T> push_out(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Vec3<T> &p_parent, const Vec3<T> &p_segment,
		const T &p_length, const T &p_gap) {
	Vec3<T> segment = p_segment;
	for (const TileCollider &collider : p_terms.colliders) {
		const Vec3<T> parent = p_parent + (p_blade.root - widened<T>(collider.centre));
		const Vec3<T> offset = parent + segment;
		const Vec3<T> nearest = maximum(minimum(parent, offset), Vec3<T>{} - maximum(parent, offset));
		const auto may_meet = !(largest_part(nearest - widened<T>(collider.box)) > T(0.0f)); // otherwise the whole segment is outside
		if (!any(may_meet)) {
			continue;
		}
		const Turn<T> turn = widened<T>(collider.turn);
		const auto is_near = may_meet & (dot(offset, offset) < T(collider.bound * collider.bound));
		if (any(is_near)) {
			const Ground<T> ground = ground_under(collider, p_parent.y + segment.y - p_gap);
			const Face<T> face = find_face(collider, turned(inverse_of(turn), offset), ground);
			const auto is_behind = is_near & (face.distance < T(0.0f));
			if (any(is_behind)) {
				const Vec3<T> normal = turned(turn, face.normal);
				const Vec3<T> placed = place_before_plane(segment, normal, dot(segment, normal) - face.distance, p_length);
				segment = select(is_behind, placed, segment);
			}
		}
		const Vec3<T> pushed = apart<T>([&]() GRASS_APART { return push_edge_out(collider, p_parent, parent, segment, p_length); });
		segment = select(may_meet, pushed, segment);
	}
	return segment;
}

// Blades that no surface pushes at the end of a step.
template <class Mask> struct Spared {
	Mask is_held; // [Eq 36], [Eq 48] they stay as they are: in a wedge, surfaces would turn them back and forth
	Mask is_laid; // [Eq 47] a body rests on their roots
};

// [Eq 16], [Eq 17] Moves every knot, from root to tip, to its segment's length from the knot before it, outside the colliders and above the
// ground. Knots that already satisfy this stay the same, bit for bit. Returns the blades that a collider pushed.
template <class T, class Mask> GRASS_INLINE Mask finish(Blade<T> &r_blade, const StepTerms<T> &p_terms, const Spared<Mask> &p_spared) {
	const T zero(0.0f);
	Mask is_touched = zero > T(1.0f);
	Vec3<T> carry{};
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> parent = r_blade.knots[k - 1];
		const Vec3<T> rest = rest_segment(r_blade, k - 1);
		const T rest_length = r_blade.lengths[k - 1];
		Vec3<T> knot = r_blade.knots[k] + carry;
		const Vec3<T> found = knot - parent;
		knot = knot + way_to_length(found, rest_length, rest - found);

		const Vec3<T> straight = knot - parent;
		Vec3<T> segment = straight;
		const T gap = minimum(p_terms.ground_gap * r_blade.lengths[k - 1], r_blade.rest[k].y);
		for (int round = 0; round < PUSH_ROUNDS; round++) {
			const Vec3<T> start = segment;
			segment = place_before_plane(segment, Vec3<T>{ zero, T(1.0f), zero }, gap - parent.y, rest_length);
			const Vec3<T> above = segment;
			segment = push_out(r_blade, p_terms, parent, segment, rest_length, gap);
			is_touched = is_touched | (sum_of(segment - above) > zero);
			if (!any(sum_of(segment - start) > zero)) { // no squares, which would underflow for the smallest turns
				break;
			}
		}
		if (any(p_spared.is_laid)) {
			segment = select(p_spared.is_laid, laid_segment(straight, rest_length, parent.y, gap, p_terms.seconds), segment);
		}
		segment = select(p_spared.is_held, straight, segment);
		const Vec3<T> change = segment - straight;
		carry = carry + change;
		r_blade.knots[k] = select(p_spared.is_held, r_blade.knots[k], knot + change);
		// A knot that a surface pushed back does not move afterwards: no bounce, no jitter, no speed from an overlap.
		const auto is_pushed = dot(change, change) > zero;
		r_blade.before[k] = select(is_pushed, r_blade.knots[k], r_blade.before[k]);
	}
	return is_touched;
}

} // namespace grass
