// SPDX-License-Identifier: MIT
// Heights of the ground at the centres of a block of texels and of the texels around it: the source of a part of the map's ground.
#pragma once

#include "core/map/map_channels.h"
#include "core/paint/ground_places.h"

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <vector>

namespace grass {

inline constexpr double GROUND_TEXEL = info_of(MAP_GROUND).texel_size();

class HeightBlock {
public:
	// p_margin: texels around those from p_first to p_last.
	HeightBlock(const Eigen::Array2i &p_first, const Eigen::Array2i &p_last, int p_margin) :
			_first(p_first - p_margin),
			_width(p_last.x() - p_first.x() + 1 + 2 * p_margin),
			_depth(p_last.y() - p_first.y() + 1 + 2 * p_margin) {
		_heights.reserve(size_t(_width) * size_t(_depth));
	}
	bool is_complete() const { return count() == int64_t(_width) * _depth; }
	// Returns the centre of the texel whose height comes next.
	Eigen::Vector2d next() const { return centre(_first.x() + int(count()) % _width, _first.y() + int(count()) / _width); }
	void put(double p_height) { _heights.push_back(p_height); }
	static Eigen::Vector2d centre(int p_i, int p_j) { return { (p_i + 0.5) * GROUND_TEXEL, (p_j + 0.5) * GROUND_TEXEL }; }

	double at(int p_i, int p_j) const { return _heights[size_t(p_j - _first.y()) * size_t(_width) + size_t(p_i - _first.x())]; }
	int64_t count() const { return int64_t(_heights.size()); }
	// The texels of the margin are among these.
	Eigen::Array2i get_first() const { return _first; }
	Eigen::Array2i get_size() const { return { _width, _depth }; }

	// Returns the mean height of a texel's neighbours; not finite if none has a height.
	double beside(int p_i, int p_j) const {
		double sum = 0.0;
		int count = 0;
		for (int j = p_j - 1; j <= p_j + 1; j++) {
			for (int i = p_i - 1; i <= p_i + 1; i++) {
				const double height = at(i, j);
				sum += std::isfinite(height) ? height : 0.0;
				count += std::isfinite(height) ? 1 : 0;
			}
		}
		return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
	}

	Eigen::Vector3d normal(int p_i, int p_j) const {
		const auto slope = [&](int p_di, int p_dj) {
			const double ahead = at(p_i + p_di, p_j + p_dj), behind = at(p_i - p_di, p_j - p_dj), here = at(p_i, p_j);
			const int sides = (std::isfinite(ahead) ? 1 : 0) + (std::isfinite(behind) ? 1 : 0);
			return sides == 0 ? 0.0
							  : ((std::isfinite(ahead) ? ahead : here) - (std::isfinite(behind) ? behind : here)) / (sides * GROUND_TEXEL);
		};
		return Eigen::Vector3d(-slope(1, 0), 1.0, -slope(0, 1)).normalized();
	}

private:
	Eigen::Array2i _first;
	int _width, _depth;
	std::vector<double> _heights;
};

} // namespace grass
