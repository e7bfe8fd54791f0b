// SPDX-License-Identifier: MIT
// Masks for sixteen blades, which differ from those in lanes.h. Uses intrinsics, since compilers do not turn plain comparisons into masks
// of AVX-512.
#pragma once

#include "core/base/lanes.h"

#include <immintrin.h>

namespace grass {

template <> struct LaneVectors<16> { typedef __m512 Floats; };

// A mask for sixteen lanes: one bit each.
template <> struct LaneMask<16> {
	__mmask16 bits;

	static GRASS_INLINE LaneMask less(const __m512 &p_a, const __m512 &p_b) { return { _mm512_cmp_ps_mask(p_a, p_b, _CMP_LT_OQ) }; }
	static GRASS_INLINE LaneMask less_or_equal(const __m512 &p_a, const __m512 &p_b) {
		return { _mm512_cmp_ps_mask(p_a, p_b, _CMP_LE_OQ) };
	}
	friend GRASS_INLINE LaneMask operator&(const LaneMask &p_a, const LaneMask &p_b) { return { __mmask16(p_a.bits & p_b.bits) }; }
	friend GRASS_INLINE LaneMask operator|(const LaneMask &p_a, const LaneMask &p_b) { return { __mmask16(p_a.bits | p_b.bits) }; }
	friend GRASS_INLINE LaneMask operator!(const LaneMask &p_a) { return { __mmask16(~p_a.bits) }; }
};

template <> GRASS_INLINE Lanes<16> select(const LaneMask<16> &p_mask, const Lanes<16> &p_a, const Lanes<16> &p_b) {
	return Lanes<16>(_mm512_mask_blend_ps(p_mask.bits, p_b.values, p_a.values));
}
template <> GRASS_INLINE bool any(const LaneMask<16> &p_mask) {
	return p_mask.bits != 0;
}
template <> GRASS_INLINE Lanes<16> square_root(const Lanes<16> &p_a) {
	return Lanes<16>(_mm512_mask_sqrt_ps(p_a.values, __mmask16(-1), p_a.values)); // GCC 12's own header warns about the unmasked form
}

} // namespace grass
