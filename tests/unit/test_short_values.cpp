// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

TEST_CASE("A failure prints a few lines of a long value, and all of a short one") {
	using doctest::toString;
	CHECK(DOCTEST_STRINGIFY(std::vector<uint16_t>(5000, 7)).size() < 210);
	CHECK(DOCTEST_STRINGIFY(std::string(50000, 'x')).size() < 210);
	CHECK(DOCTEST_STRINGIFY(std::vector<int>{ 1, 2 }) == toString(std::vector<int>{ 1, 2 }));
}
