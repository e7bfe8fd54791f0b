// SPDX-License-Identifier: MIT
// Which condition of a fill rule leaves the least grass at a place.
#pragma once

#include "core/fill/fill.h"

namespace grass {

enum class FillCondition { DENSITY, MASK, MESH, TEXTURE, SLOPE, HEIGHT, NOISE, OBSTACLE };

struct FillCause {
	FillCondition condition = FillCondition::DENSITY; // that leaves the least
	double share = 1.0; // that it leaves, 0..1
	double value = 0.0; // SLOPE: degrees; HEIGHT: metres above the field; TEXTURE: the number that shows most, negative: not known yet
	std::shared_ptr<const FillObstacle> obstacle; // OBSTACLE
	double density = 1.0; // that the whole rule gives the place
};

// As fill() writes the texel of density at p_at. p_at: x, z in metres.
FillCause find_fill_cause(const PaintMap &p_map, const FillRule &p_rule, const FillSources &p_sources, const Eigen::Vector2d &p_at);

} // namespace grass
