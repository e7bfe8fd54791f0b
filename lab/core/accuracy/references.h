// SPDX-License-Identifier: MIT
// What beam theory says, in double precision.
#pragma once

#include <cmath>
#include <numbers>

namespace grass::test {

// Returns the load (m/s^2) under which a cantilever with this first frequency (Hz) and length (m) has gamma = density area load
// length^3 / EI.
inline double load_of_gamma(double p_gamma, double p_frequency, double p_length) {
	const double swing = 2.0 * std::numbers::pi * p_frequency / 3.5160152685;
	return p_gamma * swing * swing * p_length;
}

// Returns the heavy elastica theta'' = -gamma (1 - s) cos theta from the clamp to the tip, by Runge-Kutta of fourth order.
// Returns theta'(1); r_drop: of the tip, lengths.
inline double shoot_elastica(double p_gamma, double p_curvature, double &r_drop) {
	constexpr int STEPS = 2000;
	constexpr double H = 1.0 / STEPS;
	const auto slope = [&](double p_s, double p_theta) { return -p_gamma * (1.0 - p_s) * std::cos(p_theta); };
	double theta = 0.0, curvature = p_curvature;
	r_drop = 0.0;
	for (int i = 0; i < STEPS; i++) {
		const double s = i * H;
		const double k1 = curvature, m1 = slope(s, theta);
		const double k2 = curvature + 0.5 * H * m1, m2 = slope(s + 0.5 * H, theta + 0.5 * H * k1);
		const double k3 = curvature + 0.5 * H * m2, m3 = slope(s + 0.5 * H, theta + 0.5 * H * k2);
		const double k4 = curvature + H * m3, m4 = slope(s + H, theta + H * k3);
		const double next = theta + H / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
		r_drop += H / 6.0 * (std::sin(theta) + 4.0 * std::sin(theta + 0.5 * H * k2) + std::sin(next));
		curvature += H / 6.0 * (m1 + 2.0 * m2 + 2.0 * m3 + m4);
		theta = next;
	}
	return curvature;
}

// Returns how far the tip of a horizontal cantilever hangs down, lengths: the curvature at the clamp by bisection.
inline double elastica_drop(double p_gamma) {
	double low = 0.0, high = p_gamma, drop = 0.0;
	for (int i = 0; i < 60; i++) {
		const double middle = 0.5 * (low + high);
		(shoot_elastica(p_gamma, middle, drop) > 0.0 ? high : low) = middle;
	}
	return drop;
}

} // namespace grass::test
