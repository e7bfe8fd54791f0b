// SPDX-License-Identifier: MIT
// A blade's shape without contact: integration, global and local shape constraints, lengths. Twin of
// shaders/solver/shape.inc.
#pragma once

#include "core/solver/leaves.h"

namespace grass {

// A blade in blade space (metres, origin at the root).
template <class T> struct Blade {
	Vec3<T> rest[GRASS_KNOTS]; // equilibrium under gravity; knots 0 and 1 clamp the blade
	Vec3<T> knots[GRASS_KNOTS]; // in: at the start of the step; out: at its end
	Vec3<T> before[GRASS_KNOTS]; // in: one step earlier; out: at the start of the step
	T twist[GRASS_SEGMENTS]{}; // of each joint, radians: METHOD_DIRECT's first guess, which bending corrects within a step
	T calm = T(0.0f); // METHOD_PBD: what kept_calm() returned, [Eq 48]
	Vec3<T> width{}; // direction of the width at the root; zero: equally stiff across and in the plane
	Vec3<T> root; // relative to the centre of the tile, metres
	T lengths[GRASS_SEGMENTS]; // of the segments at rest, metres
	T blade_length; // of the whole blade
};

// The coefficients of a GrassStep, and other values that are the same for all blades of a tile.
template <class T> struct StepTerms {
	T keep, pull, pull_root, straighten; // GrassStep.pbd_motion of METHOD_PBD
	T still_turns; // GrassStep.pbd_motion.y of METHOD_DIRECT
	Vec3<T> load;
	T max_move, friction, ground_gap, blend;
	T seconds, step_ratio, bending, drag; // GrassStep.chain
	T free_span, thins, first_joint; // GrassStep.free_motion
	T wild_move;
	T energy_of_speed, energy_at_tip, energy_at_root, stiffer; // GrassStep.energy
	int iterations;
	float finer; // contact_rate over its least; of that rate, and of the least one:
	int most_parts, least_most_parts;
	float bury_round_below, least_bury_round_below; // blade lengths a second
	bool is_direct;
	std::span<const TileCollider> colliders;
};

// Takes the coefficients of a step. p_is_far: from every eye, so that contact_rate does not apply.
template <class T>
StepTerms<T> make_terms(const GrassStep &p_step, float p_blend, std::span<const TileCollider> p_colliders, bool p_is_far = false) {
	const float finer = p_is_far ? 1.0f : p_step.pbd_motion.x, seconds = p_step.chain.x;
	const int iterations = int(p_step.contact.x);
	return { T(p_step.pbd_motion.x), T(p_step.pbd_motion.y), T(p_step.pbd_motion.z), T(p_step.pbd_motion.w), T(p_step.pbd_motion.y),
		{ T(p_step.load.x), T(p_step.load.y), T(p_step.load.z) }, T(p_step.load.w), T(p_step.contact.y), T(p_step.contact.z), T(p_blend),
		T(p_step.chain.x), T(p_step.chain.y), T(p_step.chain.z) * T(p_step.free_motion.z), T(p_step.chain.w), T(p_step.free_motion.x),
		T(p_step.free_motion.y), T(p_step.free_motion.w), T(WILD * p_step.chain.x) * square_root(T(p_step.chain.z)), T(p_step.energy.x),
		T(p_step.energy.y), T(p_step.energy.z), T(p_step.energy.w), iterations, finer, most_parts(iterations, seconds, finer),
		most_parts(iterations, seconds, 1.0f), bury_round_below(iterations, seconds, finer), bury_round_below(iterations, seconds, 1.0f),
		int(p_step.contact.w) == GRASS_METHOD_DIRECT, p_colliders };
}

template <class T> GRASS_INLINE Vec3<T> rest_segment(const Blade<T> &p_blade, int p_knot) {
	return p_blade.rest[p_knot + 1] - p_blade.rest[p_knot];
}
template <class T> GRASS_INLINE Vec3<T> segment(const Blade<T> &p_blade, int p_knot) {
	return p_blade.knots[p_knot + 1] - p_blade.knots[p_knot];
}

// [Eq 33] Returns true if p_normal (blade space) does not belong to a knot: a neighbour is so much deeper behind the same plane that the
// edge between them meets the shape, with a normal across the edge. If it were pushed along the edge, the blade would buckle.
template <class T> GRASS_INLINE auto is_of_edge(const Blade<T> &p_blade, int p_knot, const Vec3<T> &p_normal) {
	const int above = p_knot < GRASS_SEGMENTS ? p_knot : p_knot - 1;
	const T below = dot(p_normal, segment(p_blade, p_knot - 1));
	const T beyond = p_knot < GRASS_SEGMENTS ? T(0.0f) - dot(p_normal, segment(p_blade, above)) : T(0.0f);
	return maximum(below, beyond) > p_blade.lengths[p_knot - 1] * T(STEEP);
}

template <class T> GRASS_INLINE void measure_lengths(Blade<T> &r_blade) {
	r_blade.blade_length = T(0.0f);
	for (int k = 0; k < GRASS_SEGMENTS; k++) {
		r_blade.lengths[k] = length(rest_segment(r_blade, k));
		r_blade.blade_length = r_blade.blade_length + r_blade.lengths[k];
	}
}

// [Eq 4] Takes Verlet integration and the global shape constraint in one: with the coefficients of StepClock, each knot moves
// exactly as a damped oscillator about its rest place does, at any time step.
template <class T> GRASS_INLINE void integrate(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	const T limit = p_terms.max_move * r_blade.blade_length;
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

// [Eq 5], [Eq 6] Applies the local shape constraint, root to tip: pulls every segment to where the transported frame (bend and twist) of
// the segment before it puts it. The weights 1, -2, 1 conserve momentum; clamped knots do not take part.
template <class T> GRASS_INLINE void straighten(Blade<T> &r_blade, const StepTerms<T> &p_terms) {
	Turn<T> frame;
	for (int k = 1; k < GRASS_SEGMENTS; k++) {
		const Vec3<T> wanted = turned(frame, rest_segment(r_blade, k));
		const Vec3<T> error = shape_error(wanted, segment(r_blade, k));
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

// [Eq 7] Applies the length constraint, root to tip: both ends of a segment share its excess or lack of length.
template <class T> GRASS_INLINE void keep_length(Blade<T> &r_blade) {
	for (int k = 1; k < GRASS_SEGMENTS; k++) {
		const Vec3<T> change = way_to_length(segment(r_blade, k), r_blade.lengths[k], Vec3<T>{});
		if (k == 1) {
			r_blade.knots[k + 1] = r_blade.knots[k + 1] + change;
		} else {
			r_blade.knots[k + 1] = r_blade.knots[k + 1] + change * T(0.5f);
			r_blade.knots[k] = r_blade.knots[k] - change * T(0.5f);
		}
	}
}

} // namespace grass
