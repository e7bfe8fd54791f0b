// SPDX-License-Identifier: MIT
// Vectors and rotations over any lane type: shaders/base/vector.inc, and GLSL's built-in functions. Every sum is written out, since Eigen's
// reductions leave their order open and do not support lanes.
#pragma once

#include "core/base/lanes.h"
#include "core/base/layout.h"

namespace grass {

inline constexpr float TINY_SQUARED = float(GRASS_TINY_SQUARED);

template <class T> struct Vec3 {
	T x{}, y{}, z{};

	GRASS_INLINE Vec3() = default;
	GRASS_INLINE explicit Vec3(const T &p_all) : x(p_all), y(p_all), z(p_all) {}
	GRASS_INLINE Vec3(const T &p_x, const T &p_y, const T &p_z) : x(p_x), y(p_y), z(p_z) {}
};

template <class T> GRASS_INLINE Vec3<T> operator+(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { p_a.x + p_b.x, p_a.y + p_b.y, p_a.z + p_b.z };
}
template <class T> GRASS_INLINE Vec3<T> operator-(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { p_a.x - p_b.x, p_a.y - p_b.y, p_a.z - p_b.z };
}
template <class T> GRASS_INLINE Vec3<T> operator-(const Vec3<T> &p_a) {
	return { -p_a.x, -p_a.y, -p_a.z };
}
template <class T> GRASS_INLINE Vec3<T> operator*(const Vec3<T> &p_a, const T &p_b) {
	return { p_a.x * p_b, p_a.y * p_b, p_a.z * p_b };
}
template <class T> GRASS_INLINE Vec3<T> operator*(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { p_a.x * p_b.x, p_a.y * p_b.y, p_a.z * p_b.z };
}
template <class T> GRASS_INLINE Vec3<T> minimum(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { minimum(p_a.x, p_b.x), minimum(p_a.y, p_b.y), minimum(p_a.z, p_b.z) };
}
template <class T> GRASS_INLINE Vec3<T> maximum(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { maximum(p_a.x, p_b.x), maximum(p_a.y, p_b.y), maximum(p_a.z, p_b.z) };
}
template <class T, class Mask> GRASS_INLINE Vec3<T> select(const Mask &p_mask, const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { select(p_mask, p_a.x, p_b.x), select(p_mask, p_a.y, p_b.y), select(p_mask, p_a.z, p_b.z) };
}
// Return components in the order of the products of all pairs.
template <class T> GRASS_INLINE Vec3<T> xxy_of(const Vec3<T> &p_a) {
	return { p_a.x, p_a.x, p_a.y };
}
template <class T> GRASS_INLINE Vec3<T> yzz_of(const Vec3<T> &p_a) {
	return { p_a.y, p_a.z, p_a.z };
}

// A rotation as a unit quaternion: its axis part and w.
template <class T> struct Turn {
	Vec3<T> axis;
	T w = T(1.0f);

	GRASS_INLINE Turn() = default;
	GRASS_INLINE Turn(const Vec3<T> &p_axis, const T &p_w) : axis(p_axis), w(p_w) {}
};
template <class T> GRASS_INLINE Vec3<T> axis_of(const Turn<T> &p_turn) {
	return p_turn.axis;
}
template <class T> GRASS_INLINE Turn<T> operator*(const Turn<T> &p_a, const T &p_b) {
	return { p_a.axis * p_b, p_a.w * p_b };
}
template <class T, class Mask> GRASS_INLINE Turn<T> select(const Mask &p_mask, const Turn<T> &p_a, const Turn<T> &p_b) {
	return { select(p_mask, p_a.axis, p_b.axis), select(p_mask, p_a.w, p_b.w) };
}

// Widen a tile's number to a number for all its blades.
template <class T> GRASS_INLINE T widened(float p_a) {
	return T(p_a);
}
template <class T> GRASS_INLINE Vec3<T> widened(const Vec3<float> &p_a) {
	return { T(p_a.x), T(p_a.y), T(p_a.z) };
}
template <class T> GRASS_INLINE Turn<T> widened(const Turn<float> &p_a) {
	return { widened<T>(p_a.axis), T(p_a.w) };
}

// Returns a record made of these members.
template <class Record, class... Members> GRASS_INLINE Record made(const Members &...p_members) {
	return Record{ p_members... };
}

// Do what GLSL's own functions do. Its compiler may fuse their products into sums; here all of them round in the same way.
template <class T> GRASS_INLINE T dot(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return p_a.x * p_b.x + p_a.y * p_b.y + p_a.z * p_b.z;
}
template <class T> GRASS_INLINE Vec3<T> cross(const Vec3<T> &p_a, const Vec3<T> &p_b) {
	return { p_a.y * p_b.z - p_a.z * p_b.y, p_a.z * p_b.x - p_a.x * p_b.z, p_a.x * p_b.y - p_a.y * p_b.x };
}
template <class T> GRASS_INLINE T length(const Vec3<T> &p_a) {
	return square_root(dot(p_a, p_a));
}

#include "core/base/lane_words.h"

#include "base/vector.inc"

#include "core/base/lane_words_end.h"

} // namespace grass
