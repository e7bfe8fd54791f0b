// SPDX-License-Identifier: MIT
// A hash of what was computed, bit for bit.
#pragma once

#include "core/solver/tile_state.h"

#include <bit>
#include <cstdint>
#include <iomanip>
#include <span>
#include <sstream>
#include <string>

namespace grass::test {

// FNV-1a of the bits of floats.
class BitHash {
public:
	void add(std::span<const float> p_values) {
		for (const float value : p_values) {
			add_bits(std::bit_cast<uint32_t>(value));
		}
	}
	std::string str() const {
		std::ostringstream text;
		text << std::hex << std::setw(16) << std::setfill('0') << _state;
		return text.str();
	}

private:
	void add_bits(uint32_t p_bits) {
		for (int byte = 0; byte < 4; byte++) {
			_state = (_state ^ ((p_bits >> (8 * byte)) & 255u)) * 0x100000001b3u;
		}
	}
	uint64_t _state = 0xcbf29ce484222325u;
};

inline void add_tile(BitHash &r_hash, const TileState &p_tile) {
	r_hash.add({ &p_tile.knots[0][0][0], sizeof(p_tile.knots) / sizeof(float) });
	r_hash.add({ &p_tile.twist[0][0], sizeof(p_tile.twist) / sizeof(float) });
}

} // namespace grass::test
