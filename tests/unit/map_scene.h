// SPDX-License-Identifier: MIT
// A map of random codes, and a codec that needs no engine.
#pragma once

#include "core/map/map_file.h"

#include <cstring>
#include <random>

namespace grass::test {

// Runs of equal bytes as (count, byte).
inline MapBytes pack_runs(std::span<const uint8_t> p_bytes) {
	MapBytes packed;
	for (size_t i = 0; i < p_bytes.size();) {
		size_t run = 1;
		while (run < 255 && i + run < p_bytes.size() && p_bytes[i + run] == p_bytes[i]) {
			run++;
		}
		packed.push_back(uint8_t(run));
		packed.push_back(p_bytes[i]);
		i += run;
	}
	return packed;
}

inline bool unpack_runs(std::span<const uint8_t> p_packed, std::span<uint8_t> r_bytes) {
	size_t at = 0;
	for (size_t i = 0; i + 1 < p_packed.size(); i += 2) {
		if (p_packed[i] > r_bytes.size() - at) {
			return false;
		}
		std::memset(r_bytes.data() + at, p_packed[i + 1], p_packed[i]);
		at += p_packed[i];
	}
	return at == r_bytes.size() && p_packed.size() % 2 == 0;
}

inline const MapCodec RUNS{ pack_runs, unpack_runs };

inline PaintMap make_map(uint32_t p_seed) {
	PaintMap map;
	map.set_base_density(0.25);
	std::mt19937 random(p_seed);
	for (int n = 0; n < 3000; n++) {
		const MapChannel channel = MapChannel(random() % MAP_CHANNELS);
		const MapChannelInfo &info = info_of(channel);
		const int side = 2 * info.side;
		const int32_t code = info.bytes == 4 ? int32_t(random()) : int32_t(random() % 256);
		map.set_code(channel, int(random() % uint32_t(info.components)), int(random() % uint32_t(2 * side)) - side,
				int(random() % uint32_t(2 * side)) - side, code);
	}
	map.compact();
	return map;
}

} // namespace grass::test
