// SPDX-License-Identifier: MIT
// METHOD_DIRECT: a blade is a chain of rigid segments on springy joints (an inextensible elastic rod), and one implicit
// step is one sweep from tip to root and one back. Twin of shaders/solver/chain.inc. docs/internals/solver.md derives it.
#pragma once

#include "core/solver/beyond.h"

namespace grass {

template <class T> GRASS_INLINE ChainTerms<T> make_chain_terms(const Blade<T> &p_blade, const StepTerms<T> &p_terms) {
	const T mean = p_blade.blade_length * T(1.0f / float(GRASS_SEGMENTS));
	const T squared = p_blade.blade_length * p_blade.blade_length;
	return { p_terms.bending * (squared * squared) / maximum(mean, T(1e-12f)), mean, p_terms.thins, p_terms.first_joint, p_terms.stiffer };
}

template <class T> GRASS_INLINE T knot_mass(const Blade<T> &p_blade, int p_knot, const ChainTerms<T> &p_chain) {
	const T above = p_knot < GRASS_SEGMENTS ? p_blade.lengths[p_knot < GRASS_SEGMENTS ? p_knot : 0] : T(0.0f);
	const T even = (p_blade.lengths[p_knot - 1] + above) * T(0.5f) / maximum(p_chain.mean_length, T(1e-12f));
	return even * section_at(float(p_knot), p_chain.thins);
}

// [Eq 23], [Eq 44] Returns the stiffness of a joint that resists by p_bending.
template <class T> GRASS_INLINE T joint_stiffness(const Blade<T> &p_blade, int p_joint, const ChainTerms<T> &p_chain, const T &p_bending) {
	const T stands_for = joint_length(p_joint, p_blade.blade_length, p_blade.lengths[p_joint - 1], p_blade.lengths[p_joint]);
	return p_bending * joint_section(p_joint, p_chain.thins, p_chain.first_joint) / maximum(stands_for, T(1e-12f));
}

// [Eq 24] Sets where the knots would go without springs and contact: by p_way from p_base.
template <class T> GRASS_INLINE void set_target(Stage<T> &r_stage, int p_knot, const Vec3<T> &p_base, const Vec3<T> &p_way) {
	r_stage.base[p_knot] = p_base;
	r_stage.target[p_knot] = p_base + p_way;
}

// [Eq 17] Makes the first guess: the targets, moved to their segments' lengths from root to tip. p_lacks: the rest of the way, metres.
template <class T> GRASS_INLINE void follow_targets(Blade<T> &r_blade, const Stage<T> &p_stage, const Vec3<T> &p_lacks) {
	Vec3<T> carry{};
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> guess = p_stage.target[k] - p_lacks;
		const Vec3<T> found = (guess + carry) - r_blade.knots[k - 1];
		carry = carry + way_to_length(found, r_blade.lengths[k - 1], rest_segment(r_blade, k - 1) - found);
		r_blade.knots[k] = guess + carry;
	}
}

// [Eq 45] Returns the normal of a segment's face.
template <class T> GRASS_INLINE Vec3<T> face_of(const Vec3<T> &p_width, const Vec3<T> &p_e) {
	const Vec3<T> normal = cross(p_width, p_e);
	return normal * (T(1.0f) / square_root(maximum(dot(normal, normal), T(TINY_SQUARED))));
}

// [Eq 5] Measures how far joint p_joint is bent and twisted from its shape at rest, and [Eq 45] the axis about which it is stiffer. r_face:
// the normal of the face of the segment before, which becomes that of this one.
template <class T>
GRASS_INLINE void measure_joint(
		const Blade<T> &p_blade, const ChainTerms<T> &p_chain, int p_joint, Turn<T> &r_frame, Vec3<T> &r_face, JointGain<T> &r_gain) {
	const Vec3<T> wanted = turned(r_frame, rest_segment(p_blade, p_joint));
	const Vec3<T> e = segment(p_blade, p_joint);
	const Vec3<T> axis = e * (p_blade.twist[p_joint] / maximum(p_blade.lengths[p_joint], T(1e-12f)));
	const Turn<T> turn = after(turn_by(axis), smallest_turn(wanted, e));
	r_gain.turn = rotation_vector(turn);
	r_frame = after(turn, r_frame);
	const Vec3<T> before = r_face;
	r_face = face_of(turned(r_frame, p_blade.width), e);
	r_gain.axis = stiff_axis(before, r_face, p_chain.stiffer * section_at(float(p_joint), p_chain.thins));
}

template <class T>
GRASS_INLINE void measure_joints(const Blade<T> &p_blade, const ChainTerms<T> &p_chain, JointGain<T> (&r_gains)[GRASS_SEGMENTS]) {
	Turn<T> frame;
	Vec3<T> face = face_of(p_blade.width, rest_segment(p_blade, 0));
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		measure_joint(p_blade, p_chain, s, frame, face, r_gains[s]);
	}
}

// [Eq 52] Mixes the turns of the guess, r_gains, with those at the part's start.
template <class T> GRASS_INLINE void mix_turns(const Blade<T> &p_blade, const Stage<T> &p_stage, JointGain<T> (&r_gains)[GRASS_SEGMENTS]) {
	Vec3<T> before{}; // swing of the segment before, radians
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		const Vec3<T> start = p_stage.base[s + 1] - (s >= GRASS_CLAMPED_KNOTS ? p_stage.base[s] : p_blade.knots[s]);
		const Vec3<T> e = segment(p_blade, s);
		const T squared = maximum(dot(e, e), T(TINY_SQUARED));
		const Vec3<T> swing = cross(start, e - start) * (T(1.0f) / squared);
		r_gains[s].turn = turn_in_part(r_gains[s].turn, swing - before, e, squared);
		before = swing;
	}
}

// [Eq 30] Sweeps from tip to root: r_gains holds what measure_joints() found, and then the gains.
template <class T>
GRASS_INLINE Touches<T> sweep_to_root(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain,
		const Stage<T> &p_stage, JointGain<T> (&r_gains)[GRASS_SEGMENTS]) {
	Beyond<T> beyond{};
	beyond.caution = p_stage.caution;
	Touch<T> touch{}; // of knot s + 1
	for (int s = GRASS_SEGMENTS; s >= 1; s--) {
		const Touch<T> first = s >= GRASS_CLAMPED_KNOTS ? find_touch(p_blade, p_terms, p_stage.base[s], s) : Touch<T>{};
		if (s == GRASS_SEGMENTS) {
			touch = first;
			continue;
		}
		const T whole = joint_stiffness(p_blade, s, p_chain, p_chain.bending * p_stage.span * p_stage.span);
		const T stiffness = whole * T(p_stage.is_guess ? PART_SPRING : 1.0f);
		add_knot(beyond, p_blade, p_terms, p_chain, p_stage, s + 1, touch, whole);
		carry_to_base(beyond, segment(p_blade, s));
		add_edge(beyond, p_blade, p_terms, p_chain, p_stage, s + 1, first, touch, whole);
		touch = first;
		const Vec3<T> axis = r_gains[s].axis;
		const Vec3<T> moment = (r_gains[s].turn + axis * dot(axis, r_gains[s].turn)) * stiffness;
		r_gains[s] = eliminate_joint(beyond, moment, maximum(stiffness * (T(1.0f) + beyond.caution), whole), axis);
	}
	return beyond.touches;
}

// The values that the sweep back carries from joint to joint.
template <class T> struct WayBack {
	Vec3<T> parent; // the knot before, at its place before the sweep
	Vec3<T> shift{}; // of that knot, metres
	Vec3<T> turn{}; // of the segment before, radians
	T twist = T(0.0f); // of it, about itself
};

// [Eq 30] Turns the next segment, of p_length, on the way from root to tip, and moves r_knot, its end. p_twist: of its joint; returns the
// new one.
template <class T>
GRASS_INLINE T turn_joint(WayBack<T> &r_back, const T &p_twist, const JointGain<T> &p_gain, const T &p_length, Vec3<T> &r_knot) {
	const T most_twist = T(MOST_TWIST);
	const Vec3<T> stiffened = r_back.turn + p_gain.axis * dot(p_gain.axis, r_back.turn);
	const Vec3<T> by_shift = p_gain.shift.x * r_back.shift.x + p_gain.shift.y * r_back.shift.y + p_gain.shift.z * r_back.shift.z;
	const Vec3<T> turn = p_gain.turn + product_of(p_gain.spring, stiffened) - by_shift;
	const Vec3<T> e = r_knot - r_back.parent;
	// The part of the turn about the segment itself is twist. It is much larger, and would spoil the turn.
	const T along = dot(turn, e) / maximum(dot(e, e), T(TINY_SQUARED));
	const T twist = along * p_length;
	const T twisted = minimum(maximum(p_twist + (twist - r_back.twist), T(0.0f) - most_twist), most_twist);
	r_back = { r_knot, r_back.shift + turn_change(turn_by(turn - e * along), e), turn, twist };
	r_knot = r_knot + r_back.shift;
	return twisted;
}

// Performs one solve: from tip to root, then from root to tip. p_active: the lanes whose blades move.
template <class T, class Mask>
GRASS_INLINE Touches<T> solve_chain(
		Blade<T> &r_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Stage<T> &p_stage, const Mask &p_active) {
	JointGain<T> gains[GRASS_SEGMENTS];
	measure_joints(r_blade, p_chain, gains);
	if (p_stage.is_guess) {
		mix_turns(r_blade, p_stage, gains);
	}
	const Touches<T> touches = sweep_to_root(r_blade, p_terms, p_chain, p_stage, gains);
	WayBack<T> back{ r_blade.knots[1] };
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		Vec3<T> knot = r_blade.knots[s + 1];
		const T twist = turn_joint(back, r_blade.twist[s], gains[s], r_blade.lengths[s], knot);
		r_blade.twist[s] = select(p_active, twist, r_blade.twist[s]);
		r_blade.knots[s + 1] = select(p_active, knot, r_blade.knots[s + 1]);
	}
	return touches;
}

} // namespace grass
