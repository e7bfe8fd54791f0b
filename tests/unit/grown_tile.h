// SPDX-License-Identifier: MIT
// Blades and maps for tests of fields: the default patch, a tile that wakes, strokes of the brush.
#pragma once

#include "core/base/hash.h"
#include "core/base/tile_grid.h"
#include "core/blades/patch.h"
#include "core/paint/brush.h"

#include <memory>

namespace grass::test {

inline std::shared_ptr<const Patch> shared_patch() {
	static const auto patch = std::make_shared<const Patch>(generate_patch(PatchParams()));
	return patch;
}

// Returns the record of a tile of a field with a map that wakes in this step.
inline GrassSlot fresh_slot(const TileGrid &p_grid, int p_x, int p_z, int p_slot = 0) {
	GrassSlot slot;
	slot.tile = { p_x, p_z, p_grid.get_index(p_x, p_z), p_slot };
	slot.list = { grass_tile_start(uint32_t(p_x), uint32_t(p_z), 0), 0, 0, GRASS_SLOT_FRESH | GRASS_SLOT_MAPPED };
	return slot;
}

inline MapShape disc(double p_x, double p_z, double p_radius) {
	return MapShape::stroke({ p_x, p_z }, { p_x, p_z }, p_radius, 1.0, Falloff::LINEAR);
}

inline BrushResult paint(PaintMap &r_map, MapTool p_tool, double p_target, const MapShape &p_shape) {
	Brush brush;
	brush.tool = p_tool;
	brush.target = p_target;
	return apply_brush(r_map, p_shape, brush);
}

} // namespace grass::test
