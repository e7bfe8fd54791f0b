// SPDX-License-Identifier: MIT
// What lanes.h has of four and eight blades, of sixteen. By the instructions' own names: compilers make no masks of AVX-512's of plain
// comparisons.
#pragma once

#include "core/lanes.h"

#include <immintrin.h>

namespace grass {

// True or false for each of sixteen lanes: a bit.
template <> struct LaneMask<16> {
	__mmask16 bits;

	friend GRASS_INLINE LaneMask operator&(const LaneMask &p_a, const LaneMask &p_b) { return { __mmask16(p_a.bits & p_b.bits) }; }
	friend GRASS_INLINE LaneMask operator|(const LaneMask &p_a, const LaneMask &p_b) { return { __mmask16(p_a.bits | p_b.bits) }; }
	friend GRASS_INLINE LaneMask operator!(const LaneMask &p_a) { return { __mmask16(~p_a.bits) }; }
};

template <> struct Lanes<16> {
	static constexpr int COUNT = 16;
	__m512 values;

	GRASS_INLINE Lanes() : values(_mm512_setzero_ps()) {}
	GRASS_INLINE Lanes(float p_value) : values(_mm512_set1_ps(p_value)) {}
	GRASS_INLINE explicit Lanes(const __m512 &p_values) : values(p_values) {}
	GRASS_INLINE float operator[](int p_lane) const { return values[p_lane]; }

	friend GRASS_INLINE Lanes operator+(const Lanes &p_a, const Lanes &p_b) { return Lanes(p_a.values + p_b.values); }
	friend GRASS_INLINE Lanes operator-(const Lanes &p_a, const Lanes &p_b) { return Lanes(p_a.values - p_b.values); }
	friend GRASS_INLINE Lanes operator*(const Lanes &p_a, const Lanes &p_b) { return Lanes(p_a.values * p_b.values); }
	friend GRASS_INLINE Lanes operator/(const Lanes &p_a, const Lanes &p_b) { return Lanes(p_a.values / p_b.values); }
	friend GRASS_INLINE Lanes operator-(const Lanes &p_a) { return Lanes(-p_a.values); }
	friend GRASS_INLINE LaneMask<16> operator<(const Lanes &p_a, const Lanes &p_b) {
		return { _mm512_cmp_ps_mask(p_a.values, p_b.values, _CMP_LT_OQ) };
	}
	friend GRASS_INLINE LaneMask<16> operator>(const Lanes &p_a, const Lanes &p_b) {
		return { _mm512_cmp_ps_mask(p_a.values, p_b.values, _CMP_GT_OQ) };
	}
	friend GRASS_INLINE LaneMask<16> operator<=(const Lanes &p_a, const Lanes &p_b) {
		return { _mm512_cmp_ps_mask(p_a.values, p_b.values, _CMP_LE_OQ) };
	}
	friend GRASS_INLINE LaneMask<16> operator>=(const Lanes &p_a, const Lanes &p_b) {
		return { _mm512_cmp_ps_mask(p_a.values, p_b.values, _CMP_GE_OQ) };
	}
};

template <> GRASS_INLINE Lanes<16> select(const LaneMask<16> &p_mask, const Lanes<16> &p_a, const Lanes<16> &p_b) {
	return Lanes<16>(_mm512_mask_blend_ps(p_mask.bits, p_b.values, p_a.values));
}
template <> GRASS_INLINE bool any(const LaneMask<16> &p_mask) {
	return p_mask.bits != 0;
}
template <> GRASS_INLINE Lanes<16> square_root(const Lanes<16> &p_a) {
	return Lanes<16>(_mm512_mask_sqrt_ps(p_a.values, __mmask16(-1), p_a.values)); // what has no mask warns in GCC 12's own header
}

} // namespace grass
