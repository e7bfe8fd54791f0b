// SPDX-License-Identifier: MIT
#include "core/map/laid_map.h"

namespace grass {

LaidMap::LaidMap(const PaintMap &p_map, const MapPlace &p_place) :
		place(p_place), map(p_map), field(p_place.grid, p_place.tallest, p_place.follow) {
	field.update(map, field.get_region());
}

std::optional<FieldMap> LaidMap::take(const PaintMap &p_map, const MapPlace &p_place) && {
	if (p_place != place) {
		return {};
	}
	if (p_map.get_base_density() != map.get_base_density()) {
		field.touch(field.get_region());
	}
	for (const MapKey &key : p_map.compare(map)) {
		field.touch(MapRegion::of_chunk(key));
	}
	return std::move(field);
}

} // namespace grass
