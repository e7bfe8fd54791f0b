// SPDX-License-Identifier: MIT
// A compute pass as the build made it, for the header that the build writes.
#pragma once

#include <cstdint>
#include <span>

namespace grass {

// The bytes are packed: core/base/packed_pass.h.
struct SpirvCode : std::span<const uint8_t> {
	uint32_t pushed = 0; // bytes of the push constant block that it declares; 0: none
	uint32_t sum = 0; // checksum of the words, for tests
};

} // namespace grass
