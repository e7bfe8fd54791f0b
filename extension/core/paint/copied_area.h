// SPDX-License-Identifier: MIT
// What is painted in an area, copied to be pasted elsewhere, into the same map or another one. Ground is not copied: it lies where it is.
#pragma once

#include "core/map/paint_map.h"

#include <functional>

namespace grass {

struct CopiedArea {
	static constexpr double LARGEST = 65536.0; // m^2 that are pasted at once: some tenths of a second

	PaintMap map; // shares its texels with the one that it was copied from
	Eigen::Vector2d middle = Eigen::Vector2d::Zero(), half = Eigen::Vector2d::Zero(); // metres in that map
	bool is_round = false; // an ellipse; else a rectangle

	double area() const { return 4.0 * half.prod(); } // m^2 of its rectangle; 0: nothing was copied
	bool contains(const Eigen::Vector2d &p_place) const;
};

// Pastes the area around p_middle, shifted by whole metres, so that texels fall on texels and nothing is blurred. p_species: returns the
// number that a species has here, 0: none in particular; negative: it does not grow here, so the place keeps its species.
void paste_area(const CopiedArea &p_area, const Eigen::Vector2d &p_middle, const std::function<int(int)> &p_species, PaintMap &r_map);

} // namespace grass
