// SPDX-License-Identifier: MIT
#include "hulls.h"

#include "core/bodies/soft_parts.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace grass;
using namespace grass::test;

namespace {

struct Sheet {
	std::vector<Eigen::Vector3d> points;
	std::vector<int> faces;
};

// p_side points to a side, 1 m wide, in the plane y = 0.
Sheet make_cloth(int p_side) {
	Sheet cloth;
	for (int i = 0; i < p_side * p_side; i++) {
		cloth.points.emplace_back(double(i % p_side) / (p_side - 1), 0.0, double(i / p_side) / (p_side - 1));
	}
	for (int z = 0; z + 1 < p_side; z++) {
		for (int x = 0; x + 1 < p_side; x++) {
			const int a = z * p_side + x, b = a + 1, c = a + p_side, d = c + 1;
			cloth.faces.insert(cloth.faces.end(), { a, b, c, b, d, c });
		}
	}
	return cloth;
}

// Of radius 1, with a seam at which points stand twice.
Sheet make_ball(int p_rings, int p_segments) {
	Sheet ball;
	for (int ring = 0; ring <= p_rings; ring++) {
		for (int i = 0; i <= p_segments; i++) {
			const double polar = std::numbers::pi * ring / p_rings, around = 2.0 * std::numbers::pi * (i % p_segments) / p_segments;
			const double radius = ring % p_rings == 0 ? 0.0 : std::sin(polar); // a pole is one place
			ball.points.emplace_back(radius * std::cos(around), std::cos(polar), radius * std::sin(around));
			if (ring < p_rings && i < p_segments) {
				const int a = ring * (p_segments + 1) + i, b = a + 1, c = a + p_segments + 1, d = c + 1;
				ball.faces.insert(ball.faces.end(), { a, b, c, b, d, c });
			}
		}
	}
	return ball;
}

std::vector<Eigen::Vector3d> places_of(const SoftParts &p_parts, const std::vector<Eigen::Vector3d> &p_points) {
	std::vector<Eigen::Vector3d> places;
	for (const int point : p_parts.get_points()) {
		places.push_back(p_points[size_t(point)]);
	}
	return places;
}

} // namespace

TEST_CASE("a cloth has parts that follow it") {
	const Sheet cloth = make_cloth(9);
	const SoftParts parts(cloth.points, cloth.faces);
	CHECK(parts.get_count() == SoftParts::MAX_PARTS);
	CHECK(parts.get_points().size() == cloth.points.size());
	std::vector<Eigen::Vector3d> hung = cloth.points;
	for (Eigen::Vector3d &place : hung) { // hangs through, 0.3 m in the middle
		place.y() = 5.0 - 0.3 * std::sin(std::numbers::pi * place.x());
	}
	std::vector<Hull> hulls;
	parts.bound(places_of(parts, hung), hulls);
	REQUIRE(hulls.size() == size_t(SoftParts::MAX_PARTS));
	for (const Eigen::Vector3d &place : hung) {
		CHECK(outside_of(hulls, place) < -0.9 * SoftParts::MARGIN);
	}
	CHECK(outside_of(hulls, { 0.5, 4.8, 0.5 }) > 0.03); // above the middle: a box around all of it would hold that
	CHECK(outside_of(hulls, { 0.5, 4.65, 0.5 }) > 0.03); // and below
}

TEST_CASE("a closed body presses with what it encloses") {
	const Sheet ball = make_ball(12, 24);
	const SoftParts parts(ball.points, ball.faces);
	CHECK(parts.get_count() == SoftParts::MAX_PARTS);
	CHECK(parts.get_points().size() == 2 + 11 * 24); // each place once
	std::vector<Hull> hulls;
	parts.bound(places_of(parts, ball.points), hulls);
	for (int i = 0; i < 1000; i++) { // a spiral through the ball
		const double polar = std::numbers::pi * (i + 0.5) / 1000.0, around = 0.7 * i;
		const Eigen::Vector3d towards(std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around));
		for (const double radius : { 0.1, 0.5, 0.97 }) {
			CHECK(outside_of(hulls, radius * towards) < 0.0);
		}
		CHECK(outside_of(hulls, 1.3 * towards) > 0.0);
	}
}

TEST_CASE("small, large and broken bodies") {
	const Sheet triangle = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } }, { 0, 1, 2 } };
	CHECK(SoftParts(triangle.points, triangle.faces).get_count() == 1);
	const Sheet large = make_cloth(65);
	const SoftParts thinned(large.points, large.faces);
	CHECK(thinned.get_points().size() <= size_t(SoftParts::MAX_PARTS * SoftParts::MAX_POINTS));
	std::vector<Hull> hulls;
	thinned.bound(places_of(thinned, large.points), hulls);
	for (const Eigen::Vector3d &place : large.points) {
		CHECK(outside_of(hulls, place) < 0.1); // some spacings of its points, 16 mm each
	}
	CHECK(SoftParts({}, {}).get_count() == 0);
	CHECK(SoftParts(triangle.points, std::vector<int>{ 0, 1, 7, -1, 0, 1, 1, 1, 2 }).get_count() == 0);
	const Sheet cloth = make_cloth(9);
	std::vector<Eigen::Vector3d> torn = cloth.points;
	torn[0].x() = std::numeric_limits<double>::quiet_NaN();
	const SoftParts parts(cloth.points, cloth.faces);
	parts.bound(places_of(parts, torn), hulls);
	CHECK(outside_of(hulls, { 1.0, 0.0, 1.0 }) == std::numeric_limits<double>::infinity()); // no hull has planes
	parts.bound(std::vector<Eigen::Vector3d>(3), hulls); // not its points
	CHECK(hulls[0].planes.empty());
}
