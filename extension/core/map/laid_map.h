// SPDX-License-Identifier: MIT
// A map that another thread laid out for a field that will show it: the map as it was, and its layers and cover.
#pragma once

#include "core/map/field_map.h"

#include <optional>

namespace grass {

// The properties of a field that determine how a map is laid out for it.
struct MapPlace {
	TileGrid grid;
	double tallest = 0.0; // metres, of the longest blade
	float follow = 0.0f; // FOLLOW_SLOPE
	bool operator==(const MapPlace &) const = default;
};

struct LaidMap {
	LaidMap(const PaintMap &p_map, const MapPlace &p_place);

	// Returns the layers and cover for p_map, if they fit p_place, else nothing. Later changes of p_map wait to be laid out.
	std::optional<FieldMap> take(const PaintMap &p_map, const MapPlace &p_place) &&;
	size_t get_memory_usage() const { return field.get_memory_usage(); } // bytes, without the map's

	MapPlace place;
	PaintMap map; // shares its texels
	FieldMap field;
};

} // namespace grass
