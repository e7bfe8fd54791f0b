// SPDX-License-Identifier: MIT
#include "core/paint/stroke_path.h"

#include <algorithm>
#include <cmath>

namespace grass {

StrokeStep StrokePath::begin(const Eigen::Vector2d &p_place) {
	_last = p_place;
	return { p_place, p_place };
}

std::vector<StrokeStep> StrokePath::move(const Eigen::Vector2d &p_place, double p_spacing) {
	std::vector<StrokeStep> steps;
	const Eigen::Vector2d way = p_place - _last;
	const double distance = way.norm();
	if (!std::isfinite(distance) || !(p_spacing > 0.0)) {
		return steps;
	}
	const double length = std::max(p_spacing, distance / MAX_STEPS);
	// Slightly less than a whole step counts as one, so that rounding does not lose the last of MAX_STEPS.
	const int count = int(std::min(std::floor(distance / length + 1e-9), double(MAX_STEPS)));
	for (int i = 0; i < count; i++) {
		const Eigen::Vector2d next = _last + way * (length / distance);
		steps.push_back({ _last, next });
		_last = next;
	}
	return steps;
}

} // namespace grass
