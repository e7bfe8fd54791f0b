// SPDX-License-Identifier: MIT
#include "core/lod/simulation_budget.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// The change of a step, as a share of how far the time is from the aim. Times are known some frames late: larger numbers swing.
constexpr double GAIN = 0.05;

} // namespace

void SimulationBudget::advance(double p_budget, double p_time) {
	if (!(p_budget > 0.0) || !std::isfinite(p_budget)) {
		_count = 0;
		_coarseness = std::max(_coarseness * (1.0f - FASTEST), 1.0f);
		return;
	}
	if (!(p_time > 0.0) || !std::isfinite(p_time)) {
		return;
	}
	_times[_count++ % TIMES] = p_time;
	if (_count < TIMES) {
		return;
	}
	const double share = median() / p_budget;
	if (std::abs(share - AIM) <= BAND) {
		return;
	}
	const float change = float(std::clamp(GAIN * std::log(share / AIM), -double(FASTEST), double(FASTEST)));
	_coarseness = std::clamp(_coarseness * (1.0f + change), 1.0f, MOST);
}

double SimulationBudget::median() const {
	std::array<double, TIMES> sorted = _times;
	std::ranges::nth_element(sorted, sorted.begin() + TIMES / 2);
	return sorted[TIMES / 2];
}

} // namespace grass
