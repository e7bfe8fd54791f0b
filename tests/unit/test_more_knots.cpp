// SPDX-License-Identifier: MIT
// More knots bring single blades nearer to what METHOD_DIRECT converges to, as more steps do.
#include <doctest/doctest.h>

#include "chain_32.h"
#include "rolled_blades.h"

using namespace grass;
using namespace grass::test;

namespace {

constexpr Roll ROLLS[] = { { 0.0f, false, 0.0f }, { 0.0f, false, 0.5f }, { 0.0f, true, 0.0f }, { 0.0f, true, 0.5f } };
constexpr Stepping LIMIT{ 1440.0, 4, CONTACT_RATE.minimum }; // a multiple of every rate below

} // namespace

TEST_CASE("METHOD_DIRECT: blades of 32 knots that a ball rolls over are nearer to where they converge to than those of 16, to that and to "
		  "where those converge to") {
	const std::pair<float, double> cases[] = { { 0.5f, 144.0 }, { 3.0f, 60.0 }, { 5.0f, 60.0 } }; // m/s, steps a second
	for (const auto &[speed, rate] : cases) {
		CAPTURE(speed);
		std::vector<double> fine, coarse, coarse_from_fine, limits;
		for (Roll roll : ROLLS) {
			roll.speed = speed;
			const Stepping usual{ rate, int(ITERATIONS.initial), CONTACT_RATE.initial };
			const std::vector<Look> fine_limit = grass_32::test::roll_32_through(roll, LIMIT, rate);
			const std::vector<Look> coarse_looks = roll_through(roll, usual, rate);
			add_errors(grass_32::test::roll_32_through(roll, usual, rate), fine_limit, 1, fine);
			const std::vector<Look> coarse_limit = roll_through(roll, LIMIT, rate);
			add_errors(coarse_looks, coarse_limit, 1, coarse);
			add_errors(coarse_limit, fine_limit, 1, limits);
			add_errors(coarse_looks, fine_limit, 1, coarse_from_fine);
		}
		CAPTURE(rate);
		MESSAGE(speed << " m/s: where 16 knots converge to is " << median_of(limits) << " L from where 32 do");
		CHECK(median_of(fine) < 0.95 * median_of(coarse));
		CHECK(median_of(fine) < 0.95 * median_of(coarse_from_fine));
	}
}
