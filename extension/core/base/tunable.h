// SPDX-License-Identifier: MIT
// A number that a user may set: its name, unit, range and default stand here once. The node's setter
// clamps with it, the inspector's hint and the class reference's default are made from it.
#pragma once

#include <algorithm>
#include <cmath>

namespace grass {

struct Tunable {
	const char *name; // the property's name
	const char *unit; // as the inspector shows it behind the number; "" if it has none
	double minimum, maximum; // what the solver and the renderer are tested for
	double step; // the inspector's step
	double initial; // the default

	// The nearest allowed value; NaN gives the default.
	double clamp(double p_value) const { return std::isnan(p_value) ? initial : std::clamp(p_value, minimum, maximum); }
	bool allows(double p_value) const { return p_value >= minimum && p_value <= maximum; }
};

} // namespace grass
