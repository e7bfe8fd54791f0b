// SPDX-License-Identifier: MIT
// Finds why a place of a field's map is bare, or has less grass than it could have: the cause that leaves the least grass.
#pragma once

#include "core/fill/fill_cause.h"

namespace grass {

enum class BareKind {
	GRASS, // nothing reduces the grass
	MAP, // the map has no grass here, neither by hand paint nor by the rule
	PAINTED, // painted by hand
	RULE, // see BareCause::rule
	WORN,
	SHORT, // painted low
	CUT,
	HOLE, // of the terrain
	LEDGE, // the place is on neither side of a ledge
};

struct BareCause {
	BareKind kind = BareKind::GRASS;
	double share = 1.0; // share of the grass that it leaves, 0..1
	double value = 0.0; // CUT: metres
	FillCause rule; // RULE
};

// Returns the cause. p_rule: the rule that fills the map, if any. p_height: of uncut grass there, metres. p_at: x, z in metres.
BareCause find_bare_cause(
		const PaintMap &p_map, const FillRule *p_rule, const FillSources &p_sources, const Eigen::Vector2d &p_at, double p_height);

} // namespace grass
