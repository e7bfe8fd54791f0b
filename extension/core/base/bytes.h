// SPDX-License-Identifier: MIT
// Writes numbers as little-endian bytes, reads them back, and computes checksums, for files.
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

// Returns the CRC-32 (ISO 3309) of the bytes.
uint32_t checksum(std::span<const uint8_t> p_bytes);

} // namespace grass
