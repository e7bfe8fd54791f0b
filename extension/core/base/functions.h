// SPDX-License-Identifier: MIT
// Replaces functions whose last bit differs between C libraries and processors, for everything that shapes and moves blades. These use only
// operations that round the same way everywhere.
#pragma once

#include <cmath>
#include <numbers>

namespace grass {

inline constexpr double DEGREE = std::numbers::pi / 180.0; // radians

// Returns the sine of an angle in radians, up to about 1e6. Reduces it to the nearest half turn, then sums the series: sin(x + n pi) =
// (-1)^n sin x.
inline double sine(double p_angle) {
	constexpr double PI = std::numbers::pi;
	const double half_turns = std::floor(p_angle / PI + 0.5);
	const double x = p_angle - half_turns * PI;
	const double square = x * x;
	double term = x;
	double sum = x;
	for (int n = 2; n <= 20; n += 2) {
		term *= -square / double(n * (n + 1));
		sum += term;
	}
	const bool odd = half_turns - 2.0 * std::floor(half_turns * 0.5) > 0.5;
	return odd ? -sum : sum;
}
inline double cosine(double p_angle) {
	return sine(p_angle + 0.5 * std::numbers::pi);
}

// Reduces the power to the nearest multiple of log 2, then sums the series: exp(x + n log 2) = 2^n exp(x).
inline double exponential(double p_power) {
	constexpr double LOG_2 = std::numbers::ln2;
	const double twos = std::floor(p_power / LOG_2 + 0.5);
	const double x = p_power - twos * LOG_2;
	double term = 1.0;
	double sum = 1.0;
	for (int n = 1; n <= 18; n++) {
		term *= x / double(n);
		sum += term;
	}
	return std::ldexp(sum, int(std::fmax(std::fmin(twos, 2000.0), -2000.0)));
}
inline double hyperbolic_cosine(double p_x) {
	return 0.5 * (exponential(p_x) + exponential(-p_x));
}
inline double hyperbolic_sine(double p_x) {
	if (!(std::fabs(p_x) < 1.0)) {
		return 0.5 * (exponential(p_x) - exponential(-p_x));
	}
	double term = p_x; // the difference of exponentials would lose small values
	double sum = p_x;
	for (int n = 2; n <= 16; n += 2) {
		term *= p_x * p_x / double(n * (n + 1));
		sum += term;
	}
	return sum;
}

} // namespace grass
