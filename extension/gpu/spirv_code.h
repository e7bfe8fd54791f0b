// SPDX-License-Identifier: MIT
// A compute pass as the build made it, for the header that the build writes.
#pragma once

#include <cstdint>
#include <span>

namespace grass {

struct SpirvCode : std::span<const uint32_t> {
	uint32_t pushed = 0; // bytes of the push constant block that it declares; 0: none
};

} // namespace grass
