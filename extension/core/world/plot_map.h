// SPDX-License-Identifier: MIT
// What of a plot's map is its own, to be kept in a file.
#pragma once

#include "core/map/paint_map.h"

namespace grass {

// p_map, without the ground where a terrain tells it anew whenever the plot comes.
inline PaintMap kept_of(PaintMap p_map, bool p_has_terrain) {
	if (p_has_terrain) {
		for (const MapKey &key : p_map.get_keys()) {
			for (const MapChannel channel : { MAP_GROUND, MAP_NORMAL, MAP_HOLE }) {
				p_map.set_texels(key, channel, nullptr);
			}
		}
		p_map.drop_empty();
	}
	return p_map;
}

inline bool is_same(const PaintMap &p_one, const PaintMap &p_other) {
	return p_one.get_base_density() == p_other.get_base_density() && p_one.compare(p_other).empty();
}

} // namespace grass
