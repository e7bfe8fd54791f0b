// SPDX-License-Identifier: MIT
#include "core/bodies/hull.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <random>

using namespace grass;

namespace {

using Points = std::vector<Eigen::Vector3d>;

Points make_cube(const Eigen::Vector3d &p_centre, const Eigen::Vector3d &p_half) {
	Points points;
	for (int i = 0; i < 8; i++) {
		points.push_back(p_centre + Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1).cwiseProduct(p_half));
	}
	return points;
}

Points make_ball(int p_count, double p_radius) {
	std::mt19937 random(7);
	std::normal_distribution<double> normal;
	Points points;
	for (int i = 0; i < p_count; i++) {
		points.push_back(Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized() * p_radius);
	}
	return points;
}

// Returns how far p_point (in the points' space) is outside of the hull; negative inside. Metres.
double depth_outside(const Hull &p_hull, const Eigen::Vector3d &p_point) {
	double outside = -1e300;
	for (const Eigen::Vector4f &plane : p_hull.planes) {
		outside = std::max(outside, plane.head<3>().cast<double>().dot(p_point - p_hull.centre) - plane.w());
	}
	return outside;
}

// Every point inside, every plane of unit length and met by a point, the box and the radius around all.
void check_around(const Hull &p_hull, const Points &p_points, double p_tolerance) {
	REQUIRE(p_hull.planes.size() >= 4);
	REQUIRE(p_hull.planes.size() <= size_t(Hull::MAX_PLANES));
	for (const Eigen::Vector3d &point : p_points) {
		CHECK(depth_outside(p_hull, point) <= p_tolerance);
		CHECK(((point - p_hull.centre).cwiseAbs().array() <= p_hull.half_extents.array() + p_tolerance).all());
		CHECK((point - p_hull.centre).norm() <= p_hull.radius + p_tolerance);
	}
	for (const Eigen::Vector4f &plane : p_hull.planes) {
		double gap = 1e300;
		for (const Eigen::Vector3d &point : p_points) {
			gap = std::min(gap, plane.w() - plane.head<3>().cast<double>().dot(point - p_hull.centre));
		}
		CHECK(std::abs(gap) <= p_tolerance);
		CHECK(plane.head<3>().norm() == doctest::Approx(1.0f));
	}
}

} // namespace

TEST_CASE("hull: a cube has 6 planes, wherever it lies and however it is turned") {
	const Eigen::AngleAxisd turns[] = { Eigen::AngleAxisd::Identity(), Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()) };
	for (const Eigen::AngleAxisd &turn : turns) {
		Points points = make_cube({ 0.5, 0.0, -0.2 }, { 0.5, 1.0, 0.25 });
		for (Eigen::Vector3d &point : points) {
			point = (turn * point).cast<float>().cast<double>(); // Godot's points are single precision
		}
		const Hull hull = Hull::make(points);
		CHECK(hull.planes.size() == 6);
		CHECK_FALSE(hull.is_bound);
		CHECK(hull.radius == doctest::Approx(Eigen::Vector3d(0.5, 1.0, 0.25).norm()));
		CHECK(hull.centre.isApprox(turn * Eigen::Vector3d(0.5, 0.0, -0.2), 1e-6));
		check_around(hull, points, 1e-6);
		CHECK(depth_outside(hull, turn * Eigen::Vector3d(1.1, 0.0, -0.2)) == doctest::Approx(0.1).epsilon(1e-4));
	}
}

TEST_CASE("hull: points inside, on faces and on edges, and repeats, change nothing") {
	Points points;
	for (int i = 0; i < 125; i++) {
		points.emplace_back(0.1 * (i % 5), 0.1 * (i / 5 % 5), 0.1 * (i / 25));
	}
	points.insert(points.end(), points.begin(), points.begin() + 100);
	const Hull hull = Hull::make(points);
	CHECK(hull.planes.size() == 6);
	CHECK_FALSE(hull.is_bound);
	check_around(hull, points, 1e-6);
}

TEST_CASE("hull: a tetrahedron has 4 planes, a hexagonal prism 8, and scale does not matter") {
	for (const double scale : { 0.05, 1.0, 500.0 }) {
		const Points tetrahedron = { { 0, 0, 0 }, { scale, 0, 0 }, { 0, scale, 0 }, { 0, 0, scale } };
		const Hull hull = Hull::make(tetrahedron);
		CHECK(hull.planes.size() == 4);
		check_around(hull, tetrahedron, scale * 1e-6);
		Points prism;
		for (int i = 0; i < 12; i++) {
			const double angle = i / 2 * std::acos(0.5);
			prism.emplace_back(scale * std::cos(angle), i % 2 * scale, scale * std::sin(angle));
		}
		CHECK(Hull::make(prism).planes.size() == 8);
		check_around(Hull::make(prism), prism, scale * 1e-6);
	}
}

TEST_CASE("hull: random clouds up to the count of planes have their own faces") {
	for (const int count : { 5, 10, 20, 33 }) {
		const Points points = make_ball(count, 0.7);
		const Hull hull = Hull::make(points);
		CHECK_FALSE(hull.is_bound);
		CHECK(hull.planes.size() == size_t(2 * count - 4)); // Euler: all points on the hull, all faces triangles
		check_around(hull, points, 1e-6);
	}
}

TEST_CASE("hull: a ball of many points becomes a bound, said so, with all inside and not much larger") {
	for (const int count : { 60, 200, 5000 }) {
		const Points points = make_ball(count, 0.7);
		const Hull hull = Hull::make(points);
		CHECK(hull.is_bound);
		CHECK(hull.planes.size() == 26);
		check_around(hull, points, 1e-6);
		std::mt19937 random(8);
		std::normal_distribution<double> normal;
		for (int i = 0; i < 1000; i++) {
			const Eigen::Vector3d outside = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized() * 0.7 * 1.2;
			CHECK(depth_outside(hull, outside) > 0.0);
		}
	}
}

TEST_CASE("hull: flat, straight and single points get a millimetre to each side") {
	const Points square = { { 0, 0.3, 0 }, { 1, 0.3, 0 }, { 1, 0.3, 1 }, { 0, 0.3, 1 }, { 0.5, 0.3, 0.5 } };
	const Points line = { { 0, 0, 0 }, { 0.2, 0.2, 0.2 }, { 1, 1, 1 } };
	const Points place = { { 1, 2, 3 }, { 1, 2, 3 } };
	for (const Points &points : { square, line, place }) {
		const Hull hull = Hull::make(points);
		CHECK(hull.planes.size() == 6);
		for (const Eigen::Vector3d &point : points) {
			CHECK(depth_outside(hull, point) <= 1e-6);
		}
		CHECK(hull.half_extents.minCoeff() >= 0.0009);
	}
	CHECK(depth_outside(Hull::make(square), { 0.5, 0.302, 0.5 }) == doctest::Approx(0.001).epsilon(1e-3));
	CHECK(depth_outside(Hull::make(place), { 1.0, 2.0, 3.01 }) > 0.005);
}

TEST_CASE("hull: nothing, and nothing finite, has no planes; what is not finite is left out") {
	const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
	CHECK(Hull::make({}).planes.empty());
	CHECK(Hull::make(Points{ { nan, 0, 0 }, { 0, infinite, 0 }, { 0, 0, 1e30 } }).planes.empty());
	Points points = make_cube({ 0, 0, 0 }, { 1, 1, 1 });
	points.emplace_back(nan, 0.0, 0.0);
	points.emplace_back(0.0, -infinite, 0.0);
	const Hull hull = Hull::make(points);
	CHECK(hull.planes.size() == 6);
	CHECK(hull.half_extents.isApprox(Eigen::Vector3d::Ones()));
}
