// SPDX-License-Identifier: MIT
// METHOD_DIRECT: what lies beyond a joint, as the sweep from tip to root sees it, and what knots, edges, surfaces and joints add to it.
// Twin of shaders/solver/beyond.inc.
#pragma once

#include "core/base/matrix.h"
#include "core/solver/touch.h"

namespace grass {

// What one solve found of the surfaces.
template <class T> struct Touches {
	T depth; // of the deepest touch below its skin, metres; 0: nothing is touched
	T deepest; // of the touches of colliders, skins
	T grip; // most that friction at colliders takes of the blade's motion, metres times the inertia that a mean knot has without drag
	T blow; // of the deepest touch that the solve had to leave out, metres; 0: there was none
};

// An implicit step of `span` seconds from a base place and speed; the step's target is where the knots would go alone.
template <class T> struct Stage {
	T span; // seconds
	T caution; // resistance of the joints to one solve, shares of their stiffness
	T weight; // of a knot's inertia: 1 + drag
	Vec3<T> base[GRASS_KNOTS]; // metres
	Vec3<T> target[GRASS_KNOTS]; // metres
};

// What the sweep from tip to root leaves for the way back: the turn of segment s is
// turn + spring * (turn of segment s - 1) - G^T (shift of knot s).
template <class T> struct JointGain {
	Vec3<T> turn;
	Symmetric<T> spring;
	Rows<T> shift;
};

// What does not change during a step.
template <class T> struct ChainTerms {
	T bending; // EI / (density area mean length), m^3/s^2
	T mean_length;
};

// The quadratic model of everything beyond a joint, as a function of the joint's shift x and of the turn r of the
// segment before it: x P x / 2 + x Q r + r S r / 2 - p x - q r.
template <class T> struct Beyond {
	Symmetric<T> P, S;
	Rows<T> Q;
	Vec3<T> p, q;
	Vec3<T> pull; // sum of the inertial forces, for the tension
	T caution; // see Stage
	Touches<T> touches;
};

// e x (each row), that is P E with E r = r x e.
template <class T> GRASS_INLINE Rows<T> crossed(const Vec3<T> &p_e, const Symmetric<T> &p_a) {
	return { cross(p_e, Vec3<T>{ p_a.xx, p_a.xy, p_a.xz }), cross(p_e, Vec3<T>{ p_a.xy, p_a.yy, p_a.yz }),
		cross(p_e, Vec3<T>{ p_a.xz, p_a.yz, p_a.zz }) };
}
// E^T Q.
template <class T> GRASS_INLINE Rows<T> crossed(const Vec3<T> &p_e, const Rows<T> &p_a) {
	return { p_a.z * p_e.y - p_a.y * p_e.z, p_a.x * p_e.z - p_a.z * p_e.x, p_a.y * p_e.x - p_a.x * p_e.y };
}

// [Eq 31] What a surface does to a point that stands p_lever (metres) beyond the end that the model is a function of, which a turn of
// the lever moves along. p_weight: the knot's inertia, p_own: the share of the push that is this point's. Returns the most that friction
// pulls with.
template <class T>
GRASS_INLINE T add_touch(Beyond<T> &r_beyond, const Touch<T> &p_touch, const ChainTerms<T> &p_chain, const Stage<T> &p_stage,
		const Vec3<T> &p_lever, const T &p_length, const T &p_weight, const T &p_bending, const T &p_own) {
	const auto is_blow = p_touch.depth > p_chain.mean_length * T(MOST_DEPTH);
	const T depth = select(is_blow, T(0.0f), p_touch.depth);
	r_beyond.touches.depth = maximum(r_beyond.touches.depth, p_touch.depth);
	r_beyond.touches.blow = maximum(r_beyond.touches.blow, select(is_blow, p_touch.depth, T(0.0f)));
	const T hard = p_own *
			(p_weight * T(CONTACT_OVER_INERTIA) + p_bending * T(CONTACT_OVER_BENDING) / maximum(p_length * p_length, T(TINY_SQUARED)));
	const T skin = maximum(p_length * T(SKIN), T(1e-12f));
	const T in_skin = minimum(maximum(depth, T(0.0f)) / skin, T(1.0f));
	const T stiffness = hard * in_skin;
	const T push = push_at(hard, depth, skin);
	const T held = select(is_blow, T(0.0f), minimum(p_touch.held, depth));
	const T friction = p_touch.friction * push_at(hard, held, skin);
	const T grip = minimum(hard * T(FRICTION_OVER_CONTACT), friction / maximum(length(p_touch.slip), T(1e-12f)));
	r_beyond.caution = minimum(r_beyond.caution, p_stage.caution * maximum(T(1.0f) - depth / (skin * T(HIT)), T(0.0f)));
	const Vec3<T> force = p_touch.normal * push - p_touch.slip * grip;
	Symmetric<T> P;
	add_outer(P, p_touch.normal, stiffness - grip);
	add_identity(P, grip);
	r_beyond.p = r_beyond.p + force;
	add(r_beyond.P, P);
	const Rows<T> Q = crossed(p_lever, P);
	r_beyond.Q = { r_beyond.Q.x + Q.x, r_beyond.Q.y + Q.y, r_beyond.Q.z + Q.z };
	const Rows<T> S = crossed(p_lever, Q);
	add(r_beyond.S, Symmetric<T>{ S.x.x, S.y.y, S.z.z, S.y.x, S.x.z, S.y.z });
	r_beyond.q = r_beyond.q + cross(p_lever, force);
	return friction;
}

// [Eq 36] Keeps what a collider's touch, with such a friction, says of how the blade is held.
template <class T> GRASS_INLINE void keep_hold(Touches<T> &r_touches, const Touch<T> &p_touch, const T &p_length, const T &p_friction) {
	r_touches.grip = r_touches.grip + p_friction;
	r_touches.deepest = maximum(r_touches.deepest, p_touch.depth / maximum(p_length * T(SKIN), T(1e-12f)));
}

// [Eq 26] A knot's inertia, and what touches it. p_touch: of the colliders.
template <class T>
GRASS_INLINE void add_knot(Beyond<T> &r_beyond, const Blade<T> &p_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain,
		const Stage<T> &p_stage, int p_knot, const Touch<T> &p_touch, const T &p_bending) {
	const T weight = knot_mass(p_blade, p_knot, p_chain) * p_stage.weight;
	const Vec3<T> force = (p_stage.target[p_knot] - p_blade.knots[p_knot]) * weight;
	r_beyond.pull = r_beyond.pull + force;
	r_beyond.p = r_beyond.p + force;
	add_identity(r_beyond.P, weight);
	Touch<T> ground = find_ground_touch(p_blade, p_terms, p_stage.base[p_knot], p_knot);
	ground.friction = select(p_stage.caution > T(0.0f), ground.friction, T(0.0f)); // a blade near nothing would hook itself there
	if (any(ground.depth > T(0.0f))) {
		add_touch(r_beyond, ground, p_chain, p_stage, Vec3<T>{}, p_blade.lengths[p_knot - 1], weight, p_bending, T(1.0f));
	}
	if (!any(p_touch.depth > T(0.0f))) {
		return;
	}
	const T length = p_blade.lengths[p_knot - 1];
	keep_hold(r_beyond.touches, p_touch, length,
			add_touch(r_beyond, p_touch, p_chain, p_stage, Vec3<T>{}, length, weight, p_bending * T(root_contact(p_knot)), T(1.0f)));
}

// What touches the edge from knot p_knot - 1 to p_knot, as a function of the shift of the former. p_first, p_second: what touches these
// knots; what they feel of the edge's surface it does not feel again.
template <class T>
GRASS_INLINE void add_edge(Beyond<T> &r_beyond, const Blade<T> &p_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain,
		const Stage<T> &p_stage, int p_knot, const Touch<T> &p_first, const Touch<T> &p_second, const T &p_bending) {
	if (p_terms.colliders.empty()) {
		return;
	}
	const bool is_first = p_knot == GRASS_CLAMPED_KNOTS;
	T share(0.0f);
	const Vec3<T> &from = is_first ? p_blade.rest[p_knot - 1] : p_stage.base[p_knot - 1];
	const Touch<T> touch =
			apart<T>([&]() GRASS_APART { return find_edge_touch(p_blade, p_terms, from, p_stage.base[p_knot], p_knot, share); });
	if (!any(touch.depth > T(0.0f))) {
		return;
	}
	const T own = own_share(touch, p_first, p_second);
	const T length = p_blade.lengths[p_knot - 1];
	const T weight = knot_mass(p_blade, p_knot, p_chain) * p_stage.weight;
	keep_hold(r_beyond.touches, touch, length,
			add_touch(r_beyond, touch, p_chain, p_stage, segment(p_blade, p_knot - 1) * share, length, weight,
					p_bending * T(root_contact(p_knot)), own));
}

// [Eq 27] From the end of a segment to its base: the end's shift is the base's plus turn x segment.
template <class T> GRASS_INLINE void carry_to_base(Beyond<T> &r_beyond, const Vec3<T> &p_e) {
	const Rows<T> before = crossed(p_e, r_beyond.Q);
	const Rows<T> moved = crossed(p_e, r_beyond.P);
	r_beyond.Q = { r_beyond.Q.x + moved.x, r_beyond.Q.y + moved.y, r_beyond.Q.z + moved.z };
	const Rows<T> after = crossed(p_e, r_beyond.Q);
	r_beyond.S.xx = r_beyond.S.xx + (before.x.x + after.x.x);
	r_beyond.S.yy = r_beyond.S.yy + (before.y.y + after.y.y);
	r_beyond.S.zz = r_beyond.S.zz + (before.z.z + after.z.z);
	r_beyond.S.xy = r_beyond.S.xy + (before.y.x + after.x.y);
	r_beyond.S.xz = r_beyond.S.xz + (before.z.x + after.x.z);
	r_beyond.S.yz = r_beyond.S.yz + (before.z.y + after.y.z);
	r_beyond.q = r_beyond.q + cross(p_e, r_beyond.p);
	// [Eq 28] A segment under tension resists being turned.
	const T tension = maximum(dot(r_beyond.pull, p_e), T(0.0f));
	const T squared = maximum(dot(p_e, p_e), T(TINY_SQUARED));
	add_identity(r_beyond.S, tension);
	add_outer(r_beyond.S, p_e, -tension / squared);
}

// [Eq 29] The joint takes the turn that costs least; what it would be, for any shift and turn before it, is the gain.
template <class T>
GRASS_INLINE void eliminate_joint(Beyond<T> &r_beyond, JointGain<T> &r_gain, const Vec3<T> &p_moment, const T &p_stiffness) {
	Symmetric<T> D = r_beyond.S;
	add_identity(D, p_stiffness);
	const Symmetric<T> inverted = inverse(D);
	const Rows<T> Q = r_beyond.Q;
	const Rows<T> G = { inverted * Q.x, inverted * Q.y, inverted * Q.z };
	const Vec3<T> turn = inverted * (r_beyond.q - p_moment);

	r_beyond.P.xx = r_beyond.P.xx - dot(G.x, Q.x);
	r_beyond.P.yy = r_beyond.P.yy - dot(G.y, Q.y);
	r_beyond.P.zz = r_beyond.P.zz - dot(G.z, Q.z);
	r_beyond.P.xy = r_beyond.P.xy - dot(G.x, Q.y);
	r_beyond.P.xz = r_beyond.P.xz - dot(G.x, Q.z);
	r_beyond.P.yz = r_beyond.P.yz - dot(G.y, Q.z);
	r_beyond.p = r_beyond.p - Vec3<T>{ dot(Q.x, turn), dot(Q.y, turn), dot(Q.z, turn) };
	r_beyond.q = turn * p_stiffness + p_moment;
	r_beyond.Q = { G.x * p_stiffness, G.y * p_stiffness, G.z * p_stiffness };
	const Symmetric<T> spring = { inverted.xx * p_stiffness, inverted.yy * p_stiffness, inverted.zz * p_stiffness,
		inverted.xy * p_stiffness, inverted.xz * p_stiffness, inverted.yz * p_stiffness };
	r_beyond.S = { p_stiffness - spring.xx * p_stiffness, p_stiffness - spring.yy * p_stiffness, p_stiffness - spring.zz * p_stiffness,
		-spring.xy * p_stiffness, -spring.xz * p_stiffness, -spring.yz * p_stiffness };
	r_gain = { turn, spring, G };
}

} // namespace grass
