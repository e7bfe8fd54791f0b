// SPDX-License-Identifier: MIT
// One step of one blade (or of eight, one in each lane): METHOD_PBD, the method of Han and Harada 2012 that Fan et al.
// 2015 (section 4.2) use, repaired. Twin of shaders/compute/solve.inc: same names, same order. docs/solver.md derives it.
#pragma once

#include "core/collider.h"

namespace grass {

// Contacts of knots below this one do not bend the whole blade: on so short a lever they would fling it. finish() turns
// their own segments.
inline constexpr int FIRST_BENDING_KNOT = 5;
// How far, in blade lengths from the root, knots are looked after before their lengths are put right.
inline constexpr float REACH_MARGIN = 1.5f;

// A blade in blade space (metres, origin at the root).
template <class T>
struct Blade {
	Vec3<T> rest[GRASS_KNOTS]; // equilibrium under gravity; knots 0 and 1 clamp the blade
	Vec3<T> knots[GRASS_KNOTS]; // in: at the start of the step; out: at its end
	Vec3<T> before[GRASS_KNOTS]; // in: one step earlier; out: at the start of the step
	Vec3<T> root; // from the centre of the tile, metres
	T lengths[GRASS_SEGMENTS]; // of the segments at rest, metres
	T reach; // of the whole blade
};

// The coefficients of a GrassStep, and what else is the same for all blades of a tile.
template <class T>
struct StepTerms {
	T keep, pull, pull_root, straighten;
	Vec3<T> load;
	T max_move, friction, ground_gap, blend;
	int iterations;
	std::span<const TileCollider> colliders;
};

template <class T>
StepTerms<T> make_terms(const GrassStep &p_step, float p_blend, std::span<const TileCollider> p_colliders) {
	return { T(p_step.motion.x), T(p_step.motion.y), T(p_step.motion.z), T(p_step.motion.w),
		{ T(p_step.load.x), T(p_step.load.y), T(p_step.load.z) },
		T(p_step.load.w), T(p_step.contact.y), T(p_step.contact.z), T(p_blend), int(p_step.contact.x), p_colliders };
}

// [Eq 3] How much stiffer knot p_knot is held than the tip: 1 at the clamp, 0 at the tip.
inline constexpr float root_share(int p_knot) {
	const float to_tip = float(GRASS_KNOTS - 1 - p_knot) / float(GRASS_KNOTS - GRASS_CLAMPED_KNOTS);
	return to_tip * to_tip;
}

template <class T>
GRASS_INLINE Vec3<T> rest_segment(const Blade<T> &p_blade, int p_knot) {
	return p_blade.rest[p_knot + 1] - p_blade.rest[p_knot];
}
template <class T>
GRASS_INLINE Vec3<T> segment(const Blade<T> &p_blade, int p_knot) {
	return p_blade.knots[p_knot + 1] - p_blade.knots[p_knot];
}

template <class T>
GRASS_INLINE void measure_lengths(Blade<T> &r_blade) {
	r_blade.reach = T(0.0f);
	for (int k = 0; k < GRASS_SEGMENTS; k++) {
		r_blade.lengths[k] = length(rest_segment(r_blade, k));
		r_blade.reach = r_blade.reach + r_blade.lengths[k];
	}
}

// [Eq 20] The way back to the rest place, for a knot at p_lever and a rest place at p_rest from the clamp: along the arc
// about the clamp, not along the chord, which would squeeze a blade that is held down into a zigzag.
template <class T>
GRASS_INLINE Vec3<T> way_to_rest(const Vec3<T> &p_lever, const Vec3<T> &p_rest) {
	const Vec3<T> across = cross(p_lever, p_rest);
	const T squared = dot(p_lever, p_lever);
	const T product = square_root(squared * dot(p_rest, p_rest)) + dot(p_lever, p_rest);
	const T outwards = dot(across, across) / maximum(product * squared, T(TINY_SQUARED));
	return (p_rest - p_lever) + p_lever * outwards;
}

// [Eq 4] Verlet integration and the global shape constraint in one: with the coefficients of StepClock, each knot moves
// exactly as a damped oscillator about its rest place does, at any time step.
template <class T>
GRASS_INLINE void integrate(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	const T limit = p_terms.max_move * r_blade.reach;
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> knot = r_blade.knots[k];
		const Vec3<T> moved = knot - r_blade.before[k];
		const T size = length(moved);
		const T keep = select(size > limit, p_terms.keep * limit / maximum(size, T(1e-12f)), p_terms.keep);
		const T pull = p_terms.pull + p_terms.pull_root * T(root_share(k));
		const Vec3<T> way = way_to_rest(knot - r_blade.rest[1], r_blade.rest[k] - r_blade.rest[1]);
		r_blade.before[k] = knot;
		r_blade.knots[k] = knot + (moved * keep + way * pull + p_terms.load);
	}
}

// [Eq 5], [Eq 6] The local shape constraint, root to tip: every segment is drawn to where the segment before it, by its
// transported frame (bend and twist), wants it. Weights 1, -2, 1 keep momentum; clamped knots do not take part.
template <class T>
GRASS_INLINE void straighten(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	Turn<T> frame;
	for (int k = 1; k < GRASS_SEGMENTS; k++) {
		const Vec3<T> wanted = turned(frame, rest_segment(r_blade, k));
		const Vec3<T> error = wanted - segment(r_blade, k);
		const float share = k == 1 ? 1.0f : k == 2 ? 0.2f : 1.0f / 6.0f;
		const Vec3<T> change = error * (p_terms.straighten * T(share));
		r_blade.knots[k + 1] = r_blade.knots[k + 1] + change;
		if (k > 1) {
			r_blade.knots[k] = r_blade.knots[k] - change * T(2.0f);
		}
		if (k > 2) {
			r_blade.knots[k - 1] = r_blade.knots[k - 1] + change;
		}
		frame = after(smallest_turn(wanted, segment(r_blade, k)), frame);
	}
}

// [Eq 7] Length constraints, root to tip: both ends of a segment share what it is too long or too short by.
template <class T>
GRASS_INLINE void keep_lengths(Blade<T> &r_blade) {
	for (int k = 1; k < GRASS_SEGMENTS; k++) {
		const Vec3<T> found = segment(r_blade, k);
		const T rest_length = r_blade.lengths[k];
		const T squared = dot(found, found);
		const auto is_long = squared > T(TINY_SQUARED);
		const T found_length = square_root(select(is_long, squared, T(1.0f)));
		const Vec3<T> change = select(is_long, found * ((rest_length - found_length) / found_length), Vec3<T>{});
		if (k == 1) {
			r_blade.knots[k + 1] = r_blade.knots[k + 1] + change;
		} else {
			r_blade.knots[k + 1] = r_blade.knots[k + 1] + change * T(0.5f);
			r_blade.knots[k] = r_blade.knots[k] - change * T(0.5f);
		}
	}
}

// The deepest contact of a blade: of knot `knot` (a number, since lanes differ), with the knot's place.
template <class T>
struct DeepestContact {
	Contact<T> contact{ {}, T(0.0f) };
	Vec3<T> place{};
	T knot = T(0.0f);
};

template <class T>
GRASS_INLINE DeepestContact<T> find_deepest_contact(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	DeepestContact<T> deepest;
	for (const TileCollider &collider : p_terms.colliders) {
		const auto is_near = comes_within(collider, p_blade.root, p_blade.reach * T(REACH_MARGIN));
		if (!any(is_near)) {
			continue;
		}
		for (int k = FIRST_BENDING_KNOT; k < GRASS_KNOTS; k++) {
			const Contact<T> contact = find_contact(collider, p_blade.root, p_blade.before[k], p_blade.knots[k], p_terms.friction);
			const auto is_deeper = is_near & (contact.depth > deepest.contact.depth);
			deepest.contact.direction = select(is_deeper, contact.direction, deepest.contact.direction);
			deepest.contact.depth = select(is_deeper, contact.depth, deepest.contact.depth);
			deepest.place = select(is_deeper, p_blade.knots[k], deepest.place);
			deepest.knot = select(is_deeper, T(float(k)), deepest.knot);
		}
	}
	return deepest;
}

// What a force along the contact's direction turns at hinge p_knot: its moment there; none beyond the contact.
template <class T>
GRASS_INLINE Vec3<T> moment(const DeepestContact<T> &p_deepest, const Vec3<T> &p_hinge, int p_knot) {
	const Vec3<T> moment = cross(p_deepest.place - p_hinge, p_deepest.contact.direction);
	return select(p_deepest.knot > T(float(p_knot)), moment, Vec3<T>{});
}

// [Eq 13] A contact bends the blade as a force there would: every hinge below it turns by the force's moment about that
// hinge, so much in all that the knot comes out. Lengths stay; what is above the contact turns along.
template <class T>
GRASS_INLINE void bend(Blade<T> &r_blade, const DeepestContact<T> &p_deepest) {
	T stiffness(0.0f);
	Vec3<T> sum{};
	for (int k = 1; k < GRASS_SEGMENTS; k++) {
		const Vec3<T> turn = moment(p_deepest, r_blade.knots[k], k);
		stiffness = stiffness + dot(turn, turn);
		sum = sum + turn;
	}
	// [Eq 14] No farther than until the lever points along the force, and at most by one radian.
	const Vec3<T> lever = normalized(p_deepest.place - r_blade.knots[1], p_deepest.contact.direction);
	const T sine = length(cross(lever, p_deepest.contact.direction));
	const T most = select(dot(lever, p_deepest.contact.direction) > T(0.0f), sine, T(1.0f));
	T strength = p_deepest.contact.depth / maximum(stiffness, T(TINY_SQUARED));
	strength = minimum(strength, most / maximum(length(sum), T(1e-12f)));

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

// [Eq 15] A knot that must stand p_ahead in front of its parent along p_normal, at the distance p_length from it: turned
// towards the normal no farther than needed, and where even the normal does not reach, along it.
template <class T>
GRASS_INLINE Vec3<T> place_before_plane(const Vec3<T> &p_segment, const Vec3<T> &p_normal, const T &p_ahead, const T &p_length) {
	const T along = dot(p_segment, p_normal);
	if (!any(along < p_ahead)) {
		return p_segment;
	}
	const T wanted = minimum(p_ahead, p_length);
	const Vec3<T> side = normalized(p_segment - p_normal * along, perpendicular(p_normal));
	const Vec3<T> placed = p_normal * wanted + side * square_root(maximum(p_length * p_length - wanted * wanted, T(0.0f)));
	return select(along < p_ahead, placed, p_segment);
}

// [Eq 16] Turns a knot about its parent until it is outside of every collider. p_gap: its least height.
template <class T>
GRASS_INLINE Vec3<T> push_out(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const Vec3<T> &p_parent, const Vec3<T> &p_segment,
		const T &p_length, const T &p_gap) {
	Vec3<T> segment = p_segment;
	for (const TileCollider &collider : p_terms.colliders) {
		const Vec3<T> offset = (p_parent + (p_blade.root - widened<T>(collider.centre))) + segment;
		if (!any(dot(offset, offset) < T(collider.bound * collider.bound))) {
			continue;
		}
		const Turn<T> turn = widened<T>(collider.turn);
		const Ground<T> ground = ground_under(collider, p_parent.y + segment.y - p_gap);
		const Face<T> face = find_face(collider, turned(inverse(turn), offset), ground);
		if (any(face.distance < T(0.0f))) {
			const Vec3<T> normal = turned(turn, face.normal);
			const Vec3<T> placed = place_before_plane(segment, normal, dot(segment, normal) - face.distance, p_length);
			segment = select(face.distance < T(0.0f), placed, segment);
		}
	}
	return segment;
}

// [Eq 16], [Eq 17] Root to tip: every knot at its segment's length from the knot before it, outside of the
// colliders and above the ground. What the pass leaves is what it found where that was so already, bit for bit.
template <class T>
GRASS_INLINE void finish(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	const T zero(0.0f);
	Vec3<T> carry{};
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> parent = r_blade.knots[k - 1];
		const Vec3<T> rest = rest_segment(r_blade, k - 1);
		const T rest_length = r_blade.lengths[k - 1];
		Vec3<T> knot = r_blade.knots[k] + carry;
		const Vec3<T> found = knot - parent;
		const T squared = dot(found, found);
		const auto is_long = squared > T(TINY_SQUARED);
		const T found_length = square_root(select(is_long, squared, T(1.0f)));
		knot = knot + select(is_long, found * ((rest_length - found_length) / found_length), rest - found);

		const Vec3<T> straight = knot - parent;
		Vec3<T> segment = straight;
		const T gap = minimum(p_terms.ground_gap * rest_length, r_blade.rest[k].y);
		for (int round = 0; round < 2; round++) { // twice, since what one surface turns may run into another
			const Vec3<T> start = segment;
			segment = push_out(r_blade, p_terms, parent, segment, rest_length, gap);
			segment = place_before_plane(segment, Vec3<T>{ zero, T(1.0f), zero }, gap - parent.y, rest_length);
			const Vec3<T> turned_by = segment - start;
			if (!any(dot(turned_by, turned_by) > zero)) {
				break;
			}
		}
		const Vec3<T> change = segment - straight;
		carry = carry + change;
		r_blade.knots[k] = knot + change;
		// What a surface had to push back stands still afterwards: no bounce, no jitter, no speed from an overlap.
		const auto is_pushed = dot(change, change) > zero;
		r_blade.before[k] = select(is_pushed, r_blade.knots[k], r_blade.before[k]);
	}
}

// [Eq 18] Moves the blade a share of the way to rest, standing still there; a share of 1 arrives exactly.
template <class T>
GRASS_INLINE void settle(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	const auto arrives = p_terms.blend >= T(1.0f);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> rest = r_blade.rest[k];
		r_blade.knots[k] = select(arrives, rest, r_blade.knots[k] + (rest - r_blade.knots[k]) * p_terms.blend);
		r_blade.before[k] = select(arrives, rest, r_blade.before[k] + (rest - r_blade.before[k]) * p_terms.blend);
	}
}

// Puts a blade with a number that is not finite to rest. Such a number survives every stage above, so once is enough.
template <class T>
GRASS_INLINE void mend(Blade<T> &r_blade) {
	T sum(0.0f);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> knot = r_blade.knots[k];
		sum = sum + (absolute(knot.x) + absolute(knot.y) + absolute(knot.z));
	}
	const auto is_broken = !(sum < T(1e30f));
	if (any(is_broken)) {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			r_blade.knots[k] = select(is_broken, r_blade.rest[k], r_blade.knots[k]);
			r_blade.before[k] = select(is_broken, r_blade.rest[k], r_blade.before[k]);
		}
	}
}

// [Eq 19] Half the speed squared and the pull to rest, the mean of the free knots: J per kg of blade.
template <class T>
GRASS_INLINE T measure_energy(const Blade<T> &p_blade, const GrassStep &p_step) {
	T sum(0.0f);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> moved = p_blade.knots[k] - p_blade.before[k];
		const Vec3<T> away = p_blade.knots[k] - p_blade.rest[k];
		sum = sum + dot(moved, moved) * T(p_step.energy.x) + dot(away, away) * (T(p_step.energy.y) + T(p_step.energy.z) * T(root_share(k)));
	}
	return sum * T(0.5f / float(GRASS_FREE_KNOTS));
}

// Whether the blade stands at rest with nothing near it and no load on it: a step would not change a bit.
template <class T>
GRASS_INLINE bool is_idle(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	T sum = absolute(p_terms.load.x) + absolute(p_terms.load.y) + absolute(p_terms.load.z);
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> away = p_blade.knots[k] - p_blade.rest[k];
		const Vec3<T> moved = p_blade.knots[k] - p_blade.before[k];
		sum = sum + (dot(away, away) + dot(moved, moved));
	}
	auto is_busy = !(sum <= T(0.0f));
	for (const TileCollider &collider : p_terms.colliders) {
		is_busy = is_busy | comes_within(collider, p_blade.root, p_blade.reach * T(REACH_MARGIN));
	}
	return !any(is_busy);
}

// The whole step. Afterwards lengths are right, knots are finite, and outside of the colliders where that is possible.
template <class T>
GRASS_INLINE void step_blade(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	if (p_terms.iterations == 0) {
		return;
	}
	measure_lengths(r_blade);
	if (is_idle(r_blade, p_terms)) {
		return;
	}
	integrate(r_blade, p_terms);
	for (int i = 0; i < p_terms.iterations; i++) {
		straighten(r_blade, p_terms);
		keep_lengths(r_blade);
		if (!p_terms.colliders.empty()) {
			const DeepestContact<T> deepest = find_deepest_contact(r_blade, p_terms);
			if (any(deepest.contact.depth > T(0.0f))) {
				bend(r_blade, deepest);
			}
		}
	}
	if (any(p_terms.blend > T(0.0f))) {
		settle(r_blade, p_terms);
	}
	finish(r_blade, p_terms);
	mend(r_blade);
}

} // namespace grass
