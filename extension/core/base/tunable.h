// SPDX-License-Identifier: MIT
// A number that a user may set: its name, unit, range and default are defined here once. The node's setter
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
	bool is_whole = false; // an int for scripts and the inspector; what a fraction adds is cut off, as the engine does with an int

	// The nearest allowed value; NaN gives the default.
	double clamp(double p_value) const { return std::isnan(p_value) ? initial : std::clamp(whole(p_value), minimum, maximum); }
	double whole(double p_value) const { return is_whole ? std::trunc(p_value) : p_value; }
	bool allows(double p_value) const { return p_value >= minimum && p_value <= maximum; }
};

} // namespace grass
