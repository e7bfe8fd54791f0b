// SPDX-License-Identifier: MIT
// Vectors and rotations over any lane type. Twin of shaders/base/vector.inc: every sum is written out, so that
// both languages add in the same order (Eigen's reductions leave that open and know no lanes).
#pragma once

#include "core/base/lanes.h"
#include "core/base/layout.h"

namespace grass {

inline constexpr float TINY_SQUARED = float(GRASS_TINY_SQUARED);

template <class T> struct Vec3 { T x{}, y{}, z{}; };

template <class T> GRASS_INLINE Vec3<T> operator+(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { p_a.x + p_b.x, p_a.y + p_b.y, p_a.z + p_b.z };
}
template <class T> GRASS_INLINE Vec3<T> operator-(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { p_a.x - p_b.x, p_a.y - p_b.y, p_a.z - p_b.z };
}
template <class T> GRASS_INLINE Vec3<T> operator*(const Vec3<T> &p_a, const T &p_b) {
	return { p_a.x * p_b, p_a.y * p_b, p_a.z * p_b };
}

template <class T> GRASS_INLINE T dot(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return p_a.x * p_b.x + p_a.y * p_b.y + p_a.z * p_b.z;
}
// Exactly zero for two equal vectors: no term may be fused with the next one.
template <class T> GRASS_INLINE Vec3<T> cross(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { p_a.y * p_b.z - p_a.z * p_b.y, p_a.z * p_b.x - p_a.x * p_b.z, p_a.x * p_b.y - p_a.y * p_b.x };
}
template <class T> GRASS_INLINE T length(const Vec3<T> &p_a) {
	return square_root(dot(p_a, p_a));
}
template <class T> GRASS_INLINE Vec3<T> minimum(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { minimum(p_a.x, p_b.x), minimum(p_a.y, p_b.y), minimum(p_a.z, p_b.z) };
}
template <class T> GRASS_INLINE Vec3<T> maximum(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { maximum(p_a.x, p_b.x), maximum(p_a.y, p_b.y), maximum(p_a.z, p_b.z) };
}
template <class T> GRASS_INLINE T largest_part(const Vec3<T> &p_a) {
	return maximum(p_a.x, maximum(p_a.y, p_a.z));
}
template <class T, class Mask> GRASS_INLINE Vec3<T> select(const Mask &p_mask, const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { select(p_mask, p_a.x, p_b.x), select(p_mask, p_a.y, p_b.y), select(p_mask, p_a.z, p_b.z) };
}

// p_a with length 1; p_fallback where it has none.
template <class T> GRASS_INLINE Vec3<T> normalized(const Vec3<T> &p_a, const Vec3<T> &p_fallback) {
	const T squared = dot(p_a, p_a);
	const auto is_long = squared > T(TINY_SQUARED);
	const T inverse = T(1.0f) / square_root(select(is_long, squared, T(1.0f)));
	return select(is_long, p_a * inverse, p_fallback);
}

// A unit vector at right angles to the unit vector p_a, the same one every time.
template <class T> GRASS_INLINE Vec3<T> perpendicular(const Vec3<T> &p_a) {
	const auto is_steep = absolute(p_a.y) > T(0.7f);
	const Vec3<T> across = select(is_steep, Vec3<T>{ T(0.0f), p_a.z, -p_a.y }, Vec3<T>{ p_a.z, T(0.0f), -p_a.x });
	return normalized(across, Vec3<T>{ T(1.0f), T(0.0f), T(0.0f) });
}

// A rotation: unit quaternion, axis part and w.
template <class T> struct Turn {
	Vec3<T> axis;
	T w = T(1.0f);
};

// [Eq 1] What the turn adds to p_a; exactly zero where its axis part is.
template <class T> GRASS_INLINE Vec3<T> turn_change(const Turn<T> &p_turn, const Vec3<T> &p_a) {
	const Vec3<T> across = cross(p_turn.axis, p_a);
	return (across * p_turn.w + cross(p_turn.axis, across)) * T(2.0f);
}
template <class T> GRASS_INLINE Vec3<T> turned(const Turn<T> &p_turn, const Vec3<T> &p_a) {
	return p_a + turn_change(p_turn, p_a);
}
template <class T> GRASS_INLINE Turn<T> inverse(const Turn<T> &p_turn) {
	return { Vec3<T>{ -p_turn.axis.x, -p_turn.axis.y, -p_turn.axis.z }, p_turn.w };
}
// p_second after p_first.
template <class T> GRASS_INLINE Turn<T> after(const Turn<T> &p_second, const Turn<T> &p_first) {
	return { p_first.axis * p_second.w + p_second.axis * p_first.w + cross(p_second.axis, p_first.axis),
		p_second.w * p_first.w - dot(p_second.axis, p_first.axis) };
}

// [Eq 2] The smallest turn that takes the direction of p_from to that of p_to: normalize(1 + u.v, u x v) of the unit
// vectors, without an angle. Opposite directions turn about perpendicular(); a vector without length turns nothing.
template <class T> GRASS_INLINE Turn<T> smallest_turn(const Vec3<T> &p_from, const Vec3<T> &p_to) {
	const T product = square_root(dot(p_from, p_from) * dot(p_to, p_to));
	const T w = product + dot(p_from, p_to);
	const Vec3<T> axis = cross(p_from, p_to);
	const auto is_short = !(product > T(TINY_SQUARED));
	const auto is_opposite = w < product * T(1e-6f);
	const T squared = select(is_short | is_opposite, T(1.0f), w * w + dot(axis, axis));
	const T inverse = T(1.0f) / square_root(squared);
	Turn<T> turn{ axis * inverse, w * inverse };
	if (any(is_opposite)) {
		const Vec3<T> unit = normalized(p_from, Vec3<T>{ T(0.0f), T(1.0f), T(0.0f) });
		turn.axis = select(is_opposite, perpendicular(unit), turn.axis);
		turn.w = select(is_opposite, T(0.0f), turn.w);
	}
	turn.axis = select(is_short, Vec3<T>{}, turn.axis);
	turn.w = select(is_short, T(1.0f), turn.w);
	return turn;
}

// The turn by a rotation vector (radians, up to about 1): Cayley's form, axis kept, angle 2 atan(|p_angle| / 2).
template <class T> GRASS_INLINE Turn<T> turn_by(const Vec3<T> &p_angle) {
	const Vec3<T> half = p_angle * T(0.5f);
	const T inverse = T(1.0f) / square_root(T(1.0f) + dot(half, half));
	return { half * inverse, inverse };
}

} // namespace grass
