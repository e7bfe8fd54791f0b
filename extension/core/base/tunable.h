// SPDX-License-Identifier: MIT
// A number that a user may set: its name, unit, range and default are defined here once. The node's setter clamps with it; the inspector's
// hint and the default in the class reference are made from it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace grass {

struct Tunable {
	const char *name; // the property's name
	const char *unit; // as the inspector shows it after the number; "" if it has none
	double minimum, maximum; // the range for which the solver and the renderer are tested
	double step; // the inspector's step
	double initial; // the default
	bool is_whole = false; // an int for scripts and the inspector; a fraction is cut off, as the engine does with an int

	// Returns the nearest allowed value; NaN gives the default.
	double clamp(double p_value) const { return std::isnan(p_value) ? initial : std::clamp(whole(p_value), minimum, maximum); }
	double whole(double p_value) const { return is_whole ? std::trunc(p_value) : p_value; }
	bool allows(double p_value) const { return p_value >= minimum && p_value <= maximum; }
};

// Returns the defaults of a table.
template <size_t N> constexpr std::array<double, N> initial_of(const std::array<Tunable, N> &p_table) {
	std::array<double, N> values{};
	std::ranges::transform(p_table, values.begin(), &Tunable::initial);
	return values;
}

} // namespace grass
