// SPDX-License-Identifier: MIT
// More knots: never farther from where the chain converges to than fewer, however fast the ball, often the steps and many the iterations.
#include "chain_32.h"
#include "rolled_blades.h"
#include "stress.h"

#include <doctest/doctest.h>

#include <sstream>

using namespace grass;
using namespace grass::test;
using grass_32::test::roll_32_through;

TEST_CASE("stress: the median blade of 32 knots that a ball rolls over is nearer to its limit than that of 16") {
	const float speeds[] = { 5.0f, 0.5f, 1.0f, 2.0f, 3.0f, 8.0f }; // m/s
	constexpr Stepping LIMIT{ 5760.0, 8, CONTACT_RATE.minimum };
	constexpr int WEIGHT = 40; // of a speed, so long does it take: under a sanitizer none is left
	std::string figures[std::size(speeds)]; // shown at the end: doctest's messages are of the main thread
	check_each(sized(WEIGHT, WEIGHT * int(std::size(speeds))) / WEIGHT, [&](int i) {
		std::vector<Look> limits[4], limits_32[4];
		const auto roll_of = [&](int p_kind) { return Roll{ speeds[i], p_kind % 2 == 1, p_kind < 2 ? 0.0f : 0.5f }; };
		for (int kind = 0; kind < 4; kind++) {
			limits[kind] = roll_through(roll_of(kind), LIMIT, 720.0);
			limits_32[kind] = roll_32_through(roll_of(kind), LIMIT, 720.0);
		}
		std::string wrong;
		for (const double rate : { 30.0, 60.0, 144.0 }) {
			for (const int iterations : { 2, 4, 8 }) {
				const Stepping stepping{ rate, iterations, CONTACT_RATE.minimum };
				std::vector<double> errors, errors_32;
				for (int kind = 0; kind < 4; kind++) {
					add_errors(roll_through(roll_of(kind), stepping, rate), limits[kind], size_t(720.0 / rate), errors);
					add_errors(roll_32_through(roll_of(kind), stepping, rate), limits_32[kind], size_t(720.0 / rate), errors_32);
				}
				std::ostringstream text;
				text << speeds[i] << " m/s, " << rate << " steps a second, " << iterations << " iterations: 16 knots " << median_of(errors)
					 << " L (a tenth " << pick(errors, 0.9) << "), 32 knots " << median_of(errors_32) << " L (" << pick(errors_32, 0.9)
					 << ")";
				figures[i] += "\n" + text.str();
				wrong += median_of(errors_32) < median_of(errors) ? "" : text.str() + "; ";
			}
		}
		return wrong;
	});
	for (const std::string &of_speed : figures) {
		if (!of_speed.empty()) {
			MESSAGE(of_speed);
		}
	}
}
