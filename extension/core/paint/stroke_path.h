// SPDX-License-Identifier: MIT
// The path of a brush over the ground, in steps of even length: the result of a stroke depends neither on the speed of the cursor nor on
// how often the editor reports its place.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace grass {

struct StrokeStep {
	Eigen::Vector2d from, to; // metres
};

class StrokePath {
public:
	static constexpr double SPACING = 0.25; // of the radius: eight steps overlap at each place
	static constexpr int MAX_STEPS = 64; // for each move; a longer move makes the steps longer, not more

	// Returns the step at the place where the stroke begins.
	StrokeStep begin(const Eigen::Vector2d &p_place);
	// Returns the steps towards a place, each p_spacing metres long. The remainder counts with the next move. Places that are not finite
	// make no step.
	std::vector<StrokeStep> move(const Eigen::Vector2d &p_place, double p_spacing);

private:
	Eigen::Vector2d _last = Eigen::Vector2d::Zero(); // end of the last step
};

} // namespace grass
