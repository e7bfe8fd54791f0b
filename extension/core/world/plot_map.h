// SPDX-License-Identifier: MIT
// The part of a plot's map that is saved to a file.
#pragma once

#include "core/map/paint_map.h"
#include "core/map/read_limits.h"

namespace grass {

// Returns p_map, without its ground if a terrain supplies that whenever the plot loads.
inline PaintMap kept_of(PaintMap p_map, bool p_has_terrain) {
	if (p_has_terrain) {
		for (const MapKey &key : p_map.get_keys()) {
			for (const MapChannel channel : { MAP_GROUND, MAP_NORMAL, MAP_HOLE, MAP_LEDGE }) {
				p_map.set_texels(key, channel, nullptr);
			}
		}
		p_map.drop_empty();
	}
	return p_map;
}

// Removes the chunks that a plot's file may not hold: of a field that a script made larger. Returns how many there were.
inline int64_t crop(PaintMap &r_map, const ReadLimits &p_limits) {
	int64_t count = 0;
	for (const MapKey &key : r_map.get_keys()) {
		if (p_limits.allow(key)) {
			continue;
		}
		for (size_t channel = 0; channel < MAP_CHANNELS; channel++) {
			r_map.set_texels(key, MapChannel(channel), nullptr);
		}
		count++;
	}
	r_map.drop_empty();
	return count;
}

inline bool is_same(const PaintMap &p_one, const PaintMap &p_other) {
	return p_one.get_base_density() == p_other.get_base_density() && p_one.get_ground_grid() == p_other.get_ground_grid() &&
			p_one.compare(p_other).empty();
}

} // namespace grass
