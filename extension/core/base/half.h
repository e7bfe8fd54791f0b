// SPDX-License-Identifier: MIT
// Converts 16-bit floats (IEEE 754 binary16), the format of RGBA16F textures: the patch and the pool.
#pragma once

#include <bit>
#include <cstdint>

namespace grass {

// Returns the half nearest to p_value, ties to even. Magnitudes of 65,520 and above become infinity. NaN stays NaN (quiet).
constexpr uint16_t float_to_half(float p_value) {
	const uint32_t bits = std::bit_cast<uint32_t>(p_value);
	const uint32_t sign = bits >> 16 & 0x8000u;
	const uint32_t magnitude = bits & 0x7fffffffu;
	if (magnitude > 0x7f800000u) { // NaN: keep as much of its payload as fits
		return uint16_t(sign | 0x7e00u | (magnitude >> 13 & 0x1ffu));
	}
	if (magnitude >= 0x477ff000u) { // 65,520 and above, where the nearest half would be 65,536
		return uint16_t(sign | 0x7c00u);
	}
	uint32_t mantissa = magnitude - 0x38000000u; // exponent bias 127 -> 15, still with 23 fraction bits
	uint32_t dropped = 13;
	if (magnitude < 0x38800000u) { // below 2^-14: the half is denormal, a multiple of 2^-24
		dropped = 126u - (magnitude >> 23);
		if (dropped > 24u) { // below 2^-25
			return uint16_t(sign);
		}
		mantissa = (magnitude & 0x7fffffu) | 0x800000u;
	}
	const uint32_t odd = mantissa >> dropped & 1u;
	return uint16_t(sign | (mantissa + (1u << (dropped - 1u)) - 1u + odd) >> dropped);
}

// Returns the exact value of any half; NaN keeps its payload.
constexpr float half_to_float(uint16_t p_half) {
	const uint32_t sign = uint32_t(p_half & 0x8000u) << 16;
	const uint32_t exponent = p_half >> 10 & 0x1fu;
	const uint32_t fraction = p_half & 0x3ffu;
	if (exponent == 0u) { // zero and denormals: a multiple of 2^-24
		return std::bit_cast<float>(sign | std::bit_cast<uint32_t>(float(fraction) * 0x1p-24f));
	}
	const uint32_t wide = exponent == 31u ? 255u : exponent + 112u;
	return std::bit_cast<float>(sign | wide << 23 | fraction << 13);
}

} // namespace grass
