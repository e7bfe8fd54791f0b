// SPDX-License-Identifier: MIT
// What files are written with: numbers as bytes, little-endian, and a checksum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace grass {

inline void put_u32(std::vector<uint8_t> &r_bytes, uint32_t p_value) {
	const size_t at = r_bytes.size();
	r_bytes.resize(at + 4);
	std::memcpy(&r_bytes[at], &p_value, 4);
}

inline uint32_t get_u32(std::span<const uint8_t> p_bytes, size_t p_at) {
	uint32_t value;
	std::memcpy(&value, &p_bytes[p_at], 4);
	return value;
}

// CRC-32 (ISO 3309) of some bytes.
uint32_t checksum(std::span<const uint8_t> p_bytes);

} // namespace grass
