// SPDX-License-Identifier: MIT
// Finds which squares of tiles may contain a tile that waits for a slot. Such a tile sets a bit, which other squares may share.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace grass {

class QueuedSquares {
public:
	void clear() { _bits.fill(0); }
	// Adds a square. p_x, p_z: its number, see SlotMap.
	void add(int p_x, int p_z) { _bits[bit_of(p_x, p_z) / 64] |= uint64_t(1) << bit_of(p_x, p_z) % 64; }
	bool may_have(int p_x, int p_z) const { return (_bits[bit_of(p_x, p_z) / 64] >> bit_of(p_x, p_z) % 64 & 1) != 0; }

private:
	static constexpr size_t COUNT = 4096;

	static size_t bit_of(int p_x, int p_z) { return (uint32_t(p_x) * 73856093u ^ uint32_t(p_z) * 19349663u) % COUNT; }

	std::array<uint64_t, COUNT / 64> _bits{};
};

} // namespace grass
