// SPDX-License-Identifier: MIT
// METHOD_DIRECT: the part of a blade beyond a joint, as the sweep from tip to root models it, and what knots, edges, surfaces and joints
// add to it. Twin of shaders/solver/beyond.inc, and of Stage in
// shaders/solver/state.inc.
#pragma once

#include "core/base/matrix.h"
#include "core/solver/near.h"
#include "core/solver/touch.h"

namespace grass {

// What one solve found about surfaces.
template <class T> struct Touches {
	T depth; // of the deepest touch below its skin, metres; 0: nothing touches
	T deepest; // deepest touch of a collider, in skins
	T grip; // the most of the blade's motion that friction at colliders can take, metres times the inertia of a mean knot without drag
	T blow; // depth of the deepest touch that the solve had to leave out, metres; 0: none
};

// An implicit step of `span` seconds from a base position; the target is where the knots would go without springs and contact.
template <class T> struct Stage {
	T span; // of the step in seconds
	bool is_part; // one of several parts of a step beside far-moving colliders
	bool is_guess = false; // the first solve of a part, [Eq 52]
	T over_inertia; // [Eq 31] how many times harder contact is than a knot's inertia
	T most_depth; // deepest contact that a solve can undo, metres; a deeper one is a blow
	MaskOf<T> is_buried; // [Eq 46] a blow would not free it
	T caution; // resistance of the joints to one solve, as a share of their stiffness
	T weight; // of a knot's inertia: 1 + drag; of a free blade divided by its step's end's weight, since its forces are computed at a mean
	Vec3<T> base[GRASS_KNOTS]; // metres
	Vec3<T> target[GRASS_KNOTS]; // metres
};

// The terms that do not change during a step.
template <class T> struct ChainTerms {
	T bending; // EI / (density area mean length) at the root, m^3/s^2
	T mean_length;
	T thins, first_joint, stiffer; // StepTerms
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

// [Eq 31] Adds the effect of a surface on a point at p_lever (metres) beyond the end that the model is a function of; turning the lever
// moves the point. p_weight: the knot's inertia, p_own: this point's share of the push. Returns the greatest pull of friction.
template <class T>
GRASS_INLINE T add_touch(Beyond<T> &r_beyond, const Touch<T> &p_touch, const Stage<T> &p_stage, const Vec3<T> &p_lever, const T &p_length,
		const T &p_weight, const T &p_bending, const T &p_own) {
	const auto is_blow = p_touch.depth > p_stage.most_depth;
	const T depth = select(is_blow, T(0.0f), p_touch.depth);
	r_beyond.touches.depth = maximum(r_beyond.touches.depth, p_touch.depth);
	r_beyond.touches.blow = maximum(r_beyond.touches.blow, select(is_blow & !p_stage.is_buried, p_touch.depth, T(0.0f)));
	const T hard =
			p_own * (p_weight * p_stage.over_inertia + p_bending * T(CONTACT_OVER_BENDING) / maximum(p_length * p_length, T(TINY_SQUARED)));
	const T skin = maximum(p_length * T(SKIN), T(1e-12f));
	const T at = p_stage.is_part ? first_depth(depth, p_touch.held, skin) : depth;
	const T stiffness = hard * minimum(maximum(at, T(0.0f)) / skin, T(1.0f));
	const T push = push_at(hard, at, skin) + stiffness * (depth - at);
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
	add(r_beyond.Q, Q);
	const Rows<T> S = crossed(p_lever, Q);
	add(r_beyond.S, Symmetric<T>{ { S.x.x, S.y.y, S.z.z }, { S.y.x, S.x.z, S.y.z } });
	r_beyond.q = r_beyond.q + cross(p_lever, force);
	return friction;
}

// [Eq 36] Records how a collider's touch, with this friction, holds the blade.
template <class T> GRASS_INLINE void keep_hold(Touches<T> &r_touches, const Touch<T> &p_touch, const T &p_length, const T &p_friction) {
	r_touches.grip = r_touches.grip + p_friction;
	r_touches.deepest = maximum(r_touches.deepest, p_touch.depth / maximum(p_length * T(SKIN), T(1e-12f)));
}

// [Eq 26] Adds a knot's inertia, and its touches. p_touch: of the colliders.
template <class T>
GRASS_INLINE void add_knot(Beyond<T> &r_beyond, const Blade<T> &p_blade, const StepTerms<T> &p_terms, const ChainTerms<T> &p_chain,
		const Stage<T> &p_stage, int p_knot, const Touch<T> &p_touch, const T &p_bending) {
	const T weight = knot_mass(p_blade, p_knot, p_chain) * p_stage.weight;
	const Vec3<T> force = (p_stage.target[p_knot] - p_blade.knots[p_knot]) * weight;
	r_beyond.pull = r_beyond.pull + force;
	r_beyond.p = r_beyond.p + force;
	add_identity(r_beyond.P, weight);
	Touch<T> ground = find_ground_touch(p_stage.base[p_knot], p_blade.knots[p_knot], p_blade.lengths[p_knot - 1], p_terms.ground_gap,
			p_blade.rest[p_knot].y, p_terms.friction);
	ground.friction = select(p_stage.caution > T(0.0f), ground.friction, T(0.0f)); // else a free blade would hook into it
	if (any(ground.depth > T(0.0f))) {
		add_touch(r_beyond, ground, p_stage, Vec3<T>{}, p_blade.lengths[p_knot - 1], weight, p_bending, T(1.0f));
	}
	if (!any(p_touch.depth > T(0.0f))) {
		return;
	}
	const T length = p_blade.lengths[p_knot - 1];
	keep_hold(r_beyond.touches, p_touch, length,
			add_touch(r_beyond, p_touch, p_stage, Vec3<T>{}, length, weight, p_bending * T(root_contact(p_knot)), T(1.0f)));
}

// Adds the touches of the edge from knot p_knot - 1 to p_knot, as a function of the shift of the former. p_first, p_second: the touches of
// these knots; the edge does not count again what these already feel of its surface.
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
			add_touch(r_beyond, touch, p_stage, segment(p_blade, p_knot - 1) * share, length, weight, p_bending * T(root_contact(p_knot)),
					own));
}

#include "core/base/lane_words.h"

#include "solver/elimination.inc"

#include "core/base/lane_words_end.h"

} // namespace grass
