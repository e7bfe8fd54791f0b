// SPDX-License-Identifier: MIT
// A map laid out for a field that is yet to show it, by another thread: the map as it was, and its layers and cover.
#pragma once

#include "core/map/field_map.h"

#include <optional>

namespace grass {

// What of a field decides how a map is laid out for it.
struct MapPlace {
	TileGrid grid;
	double tallest = 0.0; // metres, of the longest blade
	float follow = 0.0f; // FOLLOW_SLOPE
	bool operator==(const MapPlace &) const = default;
};

struct LaidMap {
	LaidMap(const PaintMap &p_map, const MapPlace &p_place);

	// Its layers and cover for p_map, if they fit p_place: what p_map changed since waits to be laid out. Empty where they do not fit.
	std::optional<FieldMap> take(const PaintMap &p_map, const MapPlace &p_place) &&;
	size_t get_memory_usage() const { return field.get_memory_usage(); } // bytes, without the map's

	MapPlace place;
	PaintMap map; // shares its texels
	FieldMap field;
};

} // namespace grass
