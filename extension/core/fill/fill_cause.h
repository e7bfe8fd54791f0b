// SPDX-License-Identifier: MIT
// Finds the condition of a fill rule that leaves the least grass at a place.
#pragma once

#include "core/fill/fill.h"

namespace grass {

enum class FillCondition { DENSITY, MASK, MESH, TEXTURE, SLOPE, HEIGHT, NOISE, OBSTACLE };

struct FillCause {
	FillCondition condition = FillCondition::DENSITY; // the condition that leaves the least
	double share = 1.0; // the share that it leaves, 0..1
	double value = 0.0; // SLOPE: degrees; HEIGHT: metres above the field; TEXTURE: number of the dominant texture, negative: not known yet
	std::shared_ptr<const FillObstacle> obstacle; // OBSTACLE
	double density = 1.0; // the density from the whole rule
};

// Evaluates the rule as fill() does for the texel of density at p_at. p_at: x, z in metres.
FillCause find_fill_cause(const PaintMap &p_map, const FillRule &p_rule, const FillSources &p_sources, const Eigen::Vector2d &p_at);

} // namespace grass
