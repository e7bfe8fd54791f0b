// SPDX-License-Identifier: MIT
// A field on a hill, for the tests of maps.
#pragma once

#include "grown_tile.h"

#include "core/blades/clump.h"

namespace grass::test {

inline const TileGrid HILL_GRID = TileGrid::make(40.0, 40.0, 256.0); // 80 x 80 tiles of 0.5 m
// Returns the length of the longest blade, metres. A constant would make the patch before the program's other constants exist.
inline double tallest() {
	return double(shared_patch()->max_length) * CLUMP_TALLEST;
}

// A hill: 0.5 m up for each metre along x, and half as steep along z.
inline void lay_slope(PaintMap &r_map) {
	const Eigen::Vector3d normal = Eigen::Vector3d(-0.5, 1.0, -0.25).normalized();
	for (int j = -25; j < 25; j++) {
		for (int i = -25; i < 25; i++) {
			r_map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(0.5 * (i + 0.5) + 0.25 * (j + 0.5)));
			r_map.set_code(MAP_NORMAL, 0, i, j, info_of(MAP_NORMAL).code(normal.x()));
			r_map.set_code(MAP_NORMAL, 1, i, j, info_of(MAP_NORMAL).code(normal.z()));
		}
	}
}

// Of other density, height and ground everywhere.
inline PaintMap paint_varied() {
	PaintMap map;
	paint(map, MapTool::PAINT, 0.6, disc(1.0, -1.0, 12.0));
	paint(map, MapTool::HEIGHT, 0.5, disc(-3.0, 2.0, 9.0));
	lay_slope(map);
	return map;
}

} // namespace grass::test
