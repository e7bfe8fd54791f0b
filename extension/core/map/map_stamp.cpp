// SPDX-License-Identifier: MIT
#include "core/map/map_stamp.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace grass {

MapStamp::MapStamp(int p_width, int p_height, std::vector<float> p_weights) {
	const bool fits = p_width > 0 && p_height > 0 && p_width <= MOST && p_height <= MOST;
	if (!fits || p_weights.size() != size_t(p_width) * size_t(p_height)) {
		return;
	}
	_width = p_width;
	_height = p_height;
	_weights = std::move(p_weights);
	for (float &weight : _weights) {
		weight = weight > 0.0f ? std::min(weight, 1.0f) : 0.0f;
	}
}

double MapStamp::weight(int p_column, int p_row) const {
	const int column = std::clamp(p_column, 0, _width - 1), row = std::clamp(p_row, 0, _height - 1);
	return double(_weights[size_t(row) * size_t(_width) + size_t(column)]);
}

double MapStamp::get_weight(const Eigen::Vector2d &p_place) const {
	if (is_empty() || !(p_place.array() >= 0.0).all() || !(p_place.array() <= 1.0).all()) {
		return 0.0;
	}
	const double x = p_place.x() * _width - 0.5, y = p_place.y() * _height - 0.5;
	const int column = int(std::floor(x)), row = int(std::floor(y));
	const double across = x - column, down = y - row;
	const double above = weight(column, row) + (weight(column + 1, row) - weight(column, row)) * across;
	const double below = weight(column, row + 1) + (weight(column + 1, row + 1) - weight(column, row + 1)) * across;
	return above + (below - above) * down;
}

} // namespace grass
