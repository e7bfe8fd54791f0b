// SPDX-License-Identifier: MIT
// Previews the brush: shows the grass under the cursor as one touch would leave it. Only draws: no map changes, and nothing is saved.
#pragma once

#include "editor/field_stroke.h"

#include <vector>

namespace grass {

class BrushPreview {
public:
	// Shows the preview. p_painted: what a stroke would paint. A field without a map shows nothing.
	void show(const PaintedFields &p_painted, const GrassBrush &p_brush, const GroundPoint &p_point, const StrokeKeys &p_keys);
	void hide();
	int get_count() const; // number of fields that show it

private:
	std::vector<uint64_t> _field_ids; // of fields that may show it
	Eigen::Vector2d _last = Eigen::Vector2d::Zero(); // place: a comb leans the grass in the cursor's direction
};

} // namespace grass
