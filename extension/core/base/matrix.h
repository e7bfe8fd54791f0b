// SPDX-License-Identifier: MIT
// The few 3 x 3 matrices of METHOD_DIRECT, over any lane type. Twin of shaders/base/matrix.inc.
#pragma once

#include "core/base/vector.h"

namespace grass {

// A symmetric matrix.
template <class T> struct Symmetric { T xx{}, yy{}, zz{}, xy{}, xz{}, yz{}; };
// Any matrix, by its rows.
template <class T> struct Rows { Vec3<T> x, y, z; };

template <class T> GRASS_INLINE Vec3<T> operator*(const Symmetric<T> &p_a, const Vec3<T> &p_b) {
	return { p_a.xx * p_b.x + p_a.xy * p_b.y + p_a.xz * p_b.z, p_a.xy * p_b.x + p_a.yy * p_b.y + p_a.yz * p_b.z,
		p_a.xz * p_b.x + p_a.yz * p_b.y + p_a.zz * p_b.z };
}

template <class T> GRASS_INLINE void add(Symmetric<T> &r_a, const Symmetric<T> &p_b) {
	r_a = { r_a.xx + p_b.xx, r_a.yy + p_b.yy, r_a.zz + p_b.zz, r_a.xy + p_b.xy, r_a.xz + p_b.xz, r_a.yz + p_b.yz };
}
// p_scale times the identity.
template <class T> GRASS_INLINE void add_identity(Symmetric<T> &r_a, const T &p_scale) {
	r_a.xx = r_a.xx + p_scale;
	r_a.yy = r_a.yy + p_scale;
	r_a.zz = r_a.zz + p_scale;
}
// p_scale times v v^T.
template <class T> GRASS_INLINE void add_outer(Symmetric<T> &r_a, const Vec3<T> &p_v, const T &p_scale) {
	const Vec3<T> scaled = p_v * p_scale;
	r_a.xx = r_a.xx + scaled.x * p_v.x;
	r_a.yy = r_a.yy + scaled.y * p_v.y;
	r_a.zz = r_a.zz + scaled.z * p_v.z;
	r_a.xy = r_a.xy + scaled.x * p_v.y;
	r_a.xz = r_a.xz + scaled.x * p_v.z;
	r_a.yz = r_a.yz + scaled.y * p_v.z;
}

// Of a positive definite matrix, by its Cholesky factors: a determinant would lose the small directions.
template <class T> GRASS_INLINE Symmetric<T> inverse(const Symmetric<T> &p_a) {
	const T one(1.0f);
	const T x = one / p_a.xx; // A = L diag(1/x, 1/y, 1/z) L^T
	const T yx = p_a.xy * x, zx = p_a.xz * x;
	const T y = one / (p_a.yy - yx * p_a.xy);
	const T zy_raw = p_a.yz - zx * p_a.xy;
	const T zy = zy_raw * y;
	const T z = one / (p_a.zz - zx * p_a.xz - zy * zy_raw);
	const T far = yx * zy - zx; // of the inverse of L, below its diagonal: -yx, far, -zy
	return { x + yx * yx * y + far * far * z, y + zy * zy * z, z, -yx * y - far * zy * z, far * z, -zy * z };
}

} // namespace grass
