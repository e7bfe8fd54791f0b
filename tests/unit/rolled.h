// SPDX-License-Identifier: MIT
// A ball that rolls through blades, however many knots they have: what tests that compare chains exchange with each.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace rolled {

struct Roll {
	float speed; // of the ball, m/s
	bool is_leaf; // or a stalk
	float friction;
};

struct Stepping {
	double rate; // steps a second
	int iterations;
	double contact_rate; // Hz
};

// All blades at one time, metres: [blade][place], from place FIRST_PLACE of 15 between root and tip.
using Look = std::vector<Eigen::Vector3f>;
inline constexpr int FIRST_PLACE = 2, LAST_PLACE = 15, PLACES = LAST_PLACE - FIRST_PLACE + 1;

} // namespace rolled
