// SPDX-License-Identifier: MIT
// Compute passes as the library holds them: SPIR-V with each word as its difference from a guess, a third of the bytes. The build packs
// them (tools/build/packed_pass.py).
//
// All numbers have seven bits a byte, the lowest first; the highest bit says that more follow.
//
//   words of the pass
//   the first five words, as they are
//   how many kinds of operations follow; for each: its number, and the guesses for its words, two bits each
//   each operation: its number, how many words it has with the first, and those behind the first as differences
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace grass {

// Returns the words of a pass. Empty if the bytes are not those of one.
std::vector<uint32_t> unpack_pass(std::span<const uint8_t> p_packed);

} // namespace grass
