// SPDX-License-Identifier: MIT
// METHOD_DIRECT: the quick solve, of a blade that nothing is near and that is nowhere bent sharply. Twin of shaders/solver/quick.inc.
// docs/solver.md derives it.
#pragma once

#include "core/solver/chain.h"

namespace grass {

// Whether a first guess is one that a quick solve can take: no knot near the ground, all segments alike, none bent sharply against the
// next.
template <class T> GRASS_INLINE auto is_simple(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain) {
	const T mean = p_chain.mean_length;
	auto is_simple = mean > T(0.0f);
	Vec3<T> before{};
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		const Vec3<T> e = segment(p_blade, k - 1);
		const T length = p_blade.lengths[k - 1];
		is_simple = is_simple & (absolute(length - mean) < mean * T(MOST_UNEVEN)) &
				(p_blade.knots[k].y > (p_terms.ground_gap + T(SKIN)) * length);
		if (k > GRASS_CLAMPED_KNOTS) {
			is_simple = is_simple & (dot(e, before) > mean * mean * T(LEAST_COSINE));
		}
		before = e;
	}
	return is_simple;
}

// [Eq 40] Carries what is across segment p_from along to p_to, unit vectors both, as the smallest turn between them does.
template <class T> struct Carrier { Vec3<T> to, over; };
template <class T> GRASS_INLINE Carrier<T> carrier_between(const Vec3<T> &p_from, const Vec3<T> &p_to, const T &p_cosine) {
	return { p_to, (p_from + p_to) * (T(0.75f) - T(0.25f) * p_cosine) }; // 1 / (1 + cosine), to 0.5 %
}
template <class T> GRASS_INLINE Vec3<T> carried(const Carrier<T> &p_carrier, const Vec3<T> &p_a) {
	return p_a - p_carrier.over * dot(p_carrier.to, p_a);
}

// What the sweep from tip to root leaves for the way back.
template <class T> struct QuickGain {
	Vec3<T> turn; // radians
	T spin, spin_pass; // how the segment turns about itself, radians, alone and with the one before
};

// What the way back carries from joint to joint.
template <class T> struct QuickBack {
	Vec3<T> along; // the segment before, of length 1
	Vec3<T> turn; // of it, radians
	Vec3<T> away; // how far its end is moved across it, segment lengths
};
// [Eq 39] The turn of the next joint, whose segment is p_e.
template <class T>
GRASS_INLINE void quick_turn(
		QuickBack<T> &r_back, const QuickJoint<T> &p_joint, const Vec3<T> &p_gain, const Vec3<T> &p_e, const ChainTerms<T> &p_chain) {
	const Vec3<T> along = p_e * (T(1.0f) / p_chain.mean_length);
	const Carrier<T> carrier = carrier_between(r_back.along, along, dot(r_back.along, along));
	r_back.away = carried(carrier, r_back.away);
	r_back.turn = p_gain + carried(carrier, r_back.turn) * p_joint.pass - r_back.away * p_joint.shift;
	r_back.away = r_back.away + r_back.turn;
	r_back.along = along;
}

// [Eq 42] How far a blade goes by turns about the normal of the plane that it is bent in, as a share of how far it would if it were
// straight.
template <class T> struct Stride {
	Vec3<T> normal;
	T more; // beyond 1
};
// The plane is that of the first and the last segment; of a straight blade any will do.
template <class T> GRASS_INLINE Stride<T> find_stride(const Blade<T> &p_blade, const ChainTerms<T> &p_chain) {
	Vec3<T> moved{};
	T inertia(0.0f);
	float straight = 0.0f, inertia_straight = 0.0f;
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		const float mass = s == GRASS_SEGMENTS - 1 ? 0.5f : 1.0f;
		moved = moved + segment(p_blade, s) * T(first_swing(s));
		inertia = inertia + dot(moved, moved) * T(mass);
		straight += first_swing(s);
		inertia_straight += straight * straight * mass;
	}
	const T most = p_chain.mean_length * p_chain.mean_length * T(inertia_straight);
	const Vec3<T> across = cross(segment(p_blade, 1), segment(p_blade, GRASS_SEGMENTS - 1));
	return { normalized(across, Vec3<T>{ T(0.0f), T(0.0f), T(1.0f) }),
		minimum(maximum(most / inertia - T(1.0f), T(0.0f)), T(MOST_STRIDE - 1.0f)) };
}

// [Eq 39] to [Eq 41] Tip to root.
template <class T>
GRASS_INLINE void sweep_quick(const Blade<T> &p_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Stage<T> &p_stage,
		const JointGain<T> (&p_measured)[GRASS_SEGMENTS], QuickGain<T> (&r_gains)[GRASS_SEGMENTS]) {
	constexpr int LAST = GRASS_SEGMENTS - 1;
	const T inverse_length = T(1.0f) / p_chain.mean_length;
	Vec3<T> force{}, moment{}, bend_moment{}, p{}, q{};
	T spin_moment(0.0f), spin_stiffness(0.0f), cosine_beyond(1.0f);
	Vec3<T> along = segment(p_blade, LAST) * inverse_length;
	Vec3<T> beyond = along;
	for (int s = LAST; s >= 1; s--) {
		const Vec3<T> before = segment(p_blade, s - 1) * inverse_length;
		const T cosine = dot(along, before);
		const QuickJoint<T> &joint = p_terms.quick[s];

		// [Eq 41] The twist that no moment is left of, by how the segments turn about themselves.
		const Vec3<T> own = p_measured[s].turn * joint.stiffness;
		const T spin_soft = T(1.0f) / (joint.stiffness + spin_stiffness);
		const T spin = (spin_moment + dot(bend_moment - own, along)) * spin_soft;
		const T spin_pass = joint.stiffness * cosine * spin_soft;
		spin_moment = joint.stiffness * cosine * spin;
		spin_stiffness = joint.stiffness - joint.stiffness * cosine * spin_pass;
		bend_moment = own;

		// [Eq 40] What is left for bending.
		force = force + (p_stage.target[s + 1] - p_blade.knots[s + 1]) * (s == LAST ? T(0.5f) * inverse_length : inverse_length);
		const Vec3<T> left = cross(along, force) - own + moment;
		const T about = dot(left, along);
		moment = own + along * about;
		const Carrier<T> carrier = carrier_between(beyond, along, cosine_beyond);
		p = carried(carrier, p);
		q = carried(carrier, q) + p + (left - along * about);
		r_gains[s] = { q * joint.soft, spin, spin_pass };
		p = p - q * joint.shift;
		q = q * joint.pass;
		beyond = along;
		cosine_beyond = cosine;
		along = before;
	}
}

// [Eq 39] One quick solve. p_active: which lanes' blades move.
template <class T, class Mask>
GRASS_INLINE void solve_quick(
		Blade<T> &r_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain, const Stage<T> &p_stage, const Mask &p_active) {
	JointGain<T> measured[GRASS_SEGMENTS];
	measure_joints(r_blade, measured);
	QuickGain<T> gains[GRASS_SEGMENTS];
	sweep_quick(r_blade, p_terms, p_chain, p_stage, measured, gains);
	const Stride<T> stride = find_stride(r_blade, p_chain);
	QuickBack<T> back{};
	Vec3<T> shift{};
	T spin(0.0f);
	Vec3<T> parent = r_blade.knots[1];
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		const Vec3<T> knot = r_blade.knots[s + 1], before = back.along;
		const Vec3<T> e = knot - parent;
		quick_turn(back, p_terms.quick[s], gains[s].turn, e, p_chain);
		const T own_spin = gains[s].spin + gains[s].spin_pass * spin;
		const T twisted = minimum(
				maximum(r_blade.twist[s] + (own_spin - spin * dot(before, back.along)) * T(SPIN_SHARE), T(-MOST_TWIST)), T(MOST_TWIST));
		spin = own_spin;
		const Vec3<T> turn = back.turn + stride.normal * (dot(back.turn, stride.normal) * stride.more);
		shift = shift + turn_change(turn_by(turn), e);
		parent = knot;
		r_blade.knots[s + 1] = select(p_active, knot + shift, knot);
		r_blade.twist[s] = select(p_active, twisted, r_blade.twist[s]);
	}
}

} // namespace grass
