// SPDX-License-Identifier: MIT
// A picture that a brush leaves on the map: the strength of its effect at each place.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace grass {

class MapStamp {
public:
	static constexpr int MOST = 512; // texels along a side

	MapStamp() = default; // empty
	// p_weights: rows from the top, 0..1; values outside are clamped, NaN becomes 0. If their number is not p_width * p_height, or a side
	// has more texels than MOST, the stamp is empty.
	MapStamp(int p_width, int p_height, std::vector<float> p_weights);

	bool is_empty() const { return _weights.empty(); }
	// Returns the weight, interpolated between the centres of texels. p_place: 0..1 across and down; outside, the weight is 0.
	double get_weight(const Eigen::Vector2d &p_place) const;

private:
	double weight(int p_column, int p_row) const;

	int _width = 0, _height = 0;
	std::vector<float> _weights;
};

} // namespace grass
