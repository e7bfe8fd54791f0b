// SPDX-License-Identifier: MIT
// shaders/strain as C++: a blade that is described by its strains, over any lane type. docs/internals/solver.md derives it.
#pragma once

#include "core/solver/free.h"
#include "core/solver/strain/constants.h"

#if defined(__clang__)
#pragma clang diagnostic ignored "-Wpass-failed" // without optimization no loop is unrolled
#endif

namespace grass {

#define GRASS_CONSTANT inline constexpr
#include "strain/basis.inc"
#undef GRASS_CONSTANT

#define GRASS_FUNCTION GRASS_INLINE constexpr
#include "core/base/lane_words.h"

#include "strain/kinematics.inc"

#include "strain/rows.inc"

#include "strain/solve.inc"

template <class T> GRASS_INLINE const T &mass_of(const StrainSection<T> &p_section, int p_mass) {
	return p_section.mass[p_mass];
}

// A blade in blade space (metres, origin at the root).
template <class T> struct StrainBlade {
	Vec3<T> rest[GRASS_KNOTS];
	JointAxes<T> axes[GRASS_SEGMENTS]; // of each joint; the first unused
	T length; // metres
	Strains<T> now, before;
	Vec3<T> places[GRASS_KNOTS], places_before[GRASS_KNOTS]; // of the knots
	T twist[GRASS_SEGMENTS]; // of each joint, radians
	Vec3<T> forces[GRASS_STRAIN_MASSES]; // on every second knot, within a step
};
template <class T> GRASS_INLINE const T &whole_length(const StrainBlade<T> &p_blade) {
	return p_blade.length;
}
template <class T> GRASS_INLINE const Vec3<T> &rest_knot(const StrainBlade<T> &p_blade, int p_knot) {
	return p_blade.rest[p_knot];
}
template <class T> GRASS_INLINE const JointAxes<T> &axes_of(const StrainBlade<T> &p_blade, int p_joint, const Joint<T> &) {
	return p_blade.axes[p_joint];
}
template <class T> GRASS_INLINE const Strains<T> &strains_now(const StrainBlade<T> &p_blade) {
	return p_blade.now;
}
template <class T> GRASS_INLINE const Strains<T> &strains_before(const StrainBlade<T> &p_blade) {
	return p_blade.before;
}
template <class T> GRASS_INLINE const Vec3<T> &mass_now(const StrainBlade<T> &p_blade, int p_mass) {
	return p_blade.places[GRASS_STRAIN_FIRST_MASS + 2 * p_mass];
}
template <class T> GRASS_INLINE const Vec3<T> &mass_before(const StrainBlade<T> &p_blade, int p_mass) {
	return p_blade.places_before[GRASS_STRAIN_FIRST_MASS + 2 * p_mass];
}
template <class T> GRASS_INLINE void put_force(StrainBlade<T> &r_blade, int p_mass, const Vec3<T> &p_force) {
	r_blade.forces[p_mass] = p_force;
}
template <class T> GRASS_INLINE const Vec3<T> &force_on(const StrainBlade<T> &p_blade, int p_mass) {
	return p_blade.forces[p_mass];
}
// Goes on to the numbers at the step's end. The share p_share of the present ones becomes those before. With a share of 0 these are 0, even
// if a number was not finite.
template <class T> GRASS_INLINE void move_to(StrainBlade<T> &r_blade, const Strains<T> &p_next, const T &p_share) {
	const auto is_none = !(p_share > T(0.0f));
	for (int n = 0; n < GRASS_STRAINS; n++) {
		r_blade.before.at[n] = select(is_none, T(0.0f), r_blade.now.at[n] * p_share);
		r_blade.now.at[n] = p_next.at[n];
	}
}
// Does the same for a knot. p_is_stopped: it does not move.
template <class T>
GRASS_INLINE void put_knot(StrainBlade<T> &r_blade, int p_knot, const Vec3<T> &p_rest, const Vec3<T> &p_place, const T &p_twist,
		const T &p_share, const MaskOf<T> &p_is_stopped) {
	const Vec3<T> now = r_blade.places[p_knot], shared = p_rest + (now - p_rest) * p_share;
	const Vec3<T> before = select(p_share < T(1.0f), select(p_share > T(0.0f), shared, p_rest), now);
	r_blade.places_before[p_knot] = select(p_is_stopped, p_place, before);
	r_blade.places[p_knot] = p_place;
	r_blade.twist[p_knot - 1] = p_twist;
}

#include "strain/step.inc"

template <class T> GRASS_INLINE const T &twist_of(const StrainBlade<T> &p_blade, int p_joint) {
	return p_blade.twist[p_joint];
}
template <class T> GRASS_INLINE void set_strains(StrainBlade<T> &r_blade, const Strains<T> &p_now, const Strains<T> &p_before) {
	r_blade.now = p_now;
	r_blade.before = p_before;
}
template <class T> GRASS_INLINE void move_knot(StrainBlade<T> &r_blade, int p_knot, const Vec3<T> &p_place) {
	r_blade.places_before[p_knot] = r_blade.places_before[p_knot] + (p_place - r_blade.places[p_knot]);
	r_blade.places[p_knot] = p_place;
}

#include "strain/take_chain.inc"

#include "core/base/lane_words_end.h"
#undef GRASS_FUNCTION

} // namespace grass
