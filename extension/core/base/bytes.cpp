// SPDX-License-Identifier: MIT
#include "core/base/bytes.h"

#include <array>

namespace grass {

uint32_t checksum(std::span<const uint8_t> p_bytes) {
	static const auto table = [] {
		std::array<uint32_t, 256> made{};
		for (uint32_t i = 0; i < 256; i++) {
			uint32_t crc = i;
			for (int bit = 0; bit < 8; bit++) {
				crc = crc >> 1 ^ (crc & 1u ? 0xedb88320u : 0u);
			}
			made[i] = crc;
		}
		return made;
	}();
	uint32_t crc = 0xffffffffu;
	for (const uint8_t byte : p_bytes) {
		crc = crc >> 8 ^ table[(crc ^ byte) & 255u];
	}
	return ~crc;
}

} // namespace grass
