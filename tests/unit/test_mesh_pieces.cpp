// SPDX-License-Identifier: MIT
#include "hulls.h"

#include "core/bodies/mesh_pieces.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace grass;
using namespace grass::test;

namespace {

using Corners = std::vector<Eigen::Vector3d>;

void add_quad(const std::array<Eigen::Vector3d, 4> &p_quad, Corners &r_corners) {
	for (const size_t corner : { 0, 1, 2, 0, 2, 3 }) {
		r_corners.push_back(p_quad[corner]);
	}
}

Corners make_box(const Eigen::Vector3d &p_low, const Eigen::Vector3d &p_high) {
	Corners corners;
	for (int axis = 0; axis < 3; axis++) {
		const int u = (axis + 1) % 3, v = (axis + 2) % 3;
		for (const Eigen::Vector3d &side : { p_low, p_high }) {
			std::array<Eigen::Vector3d, 4> quad;
			for (size_t i = 0; i < 4; i++) {
				quad[i][axis] = side[axis];
				quad[i][u] = i == 1 || i == 2 ? p_high[u] : p_low[u];
				quad[i][v] = i >= 2 ? p_high[v] : p_low[v];
			}
			add_quad(quad, corners);
		}
	}
	return corners;
}

// Around y: the middle of its tube at radius 1, the tube 0.25 thick to each side.
Corners make_ring() {
	const auto at = [](int p_around, int p_tube) {
		const double around = 2.0 * std::numbers::pi * p_around / 32, tube = 2.0 * std::numbers::pi * p_tube / 12;
		const double radius = 1.0 + 0.25 * std::cos(tube);
		return Eigen::Vector3d(radius * std::cos(around), 0.25 * std::sin(tube), radius * std::sin(around));
	};
	Corners corners;
	for (int i = 0; i < 32; i++) {
		for (int k = 0; k < 12; k++) {
			add_quad({ at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1) }, corners);
		}
	}
	return corners;
}

double farthest_corner(const std::vector<Hull> &p_hulls, const Corners &p_corners) {
	double most = -std::numeric_limits<double>::infinity();
	for (const Eigen::Vector3d &corner : p_corners) {
		most = std::max(most, outside_of(p_hulls, corner));
	}
	return most;
}

} // namespace

TEST_CASE("a convex mesh is one piece, however it is turned") {
	const Corners box = make_box({ -0.5, -0.2, -1.0 }, { 0.5, 0.2, 1.0 });
	for (const double angle : { 0.0, 0.3, 0.8 }) {
		const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
		Corners turned;
		for (const Eigen::Vector3d &corner : box) {
			turned.emplace_back(turn * corner);
		}
		const std::vector<Hull> hulls = MeshPieces::make(turned);
		REQUIRE(hulls.size() == 1);
		CHECK(hulls[0].planes.size() == 6);
		CHECK(std::abs(farthest_corner(hulls, turned)) < 1e-5);
	}
}

TEST_CASE("an angle is two pieces") {
	Corners corners = make_box({ 0, 0, 0 }, { 2, 0.4, 1 });
	const Corners upright = make_box({ 0, 0.4, 0 }, { 0.4, 2, 1 });
	corners.insert(corners.end(), upright.begin(), upright.end());
	const std::vector<Hull> hulls = MeshPieces::make(corners);
	CHECK(hulls.size() >= 2);
	CHECK(hulls.size() <= 3);
	CHECK(farthest_corner(hulls, corners) < 1e-5);
	CHECK(outside_of(hulls, { 1.0, 0.2, 0.5 }) < -0.1);
	CHECK(outside_of(hulls, { 0.2, 1.0, 0.5 }) < -0.1);
	CHECK(outside_of(hulls, { 1.2, 1.2, 0.5 }) > 0.3); // in the corner
}

TEST_CASE("a ring keeps its hole") {
	const Corners ring = make_ring();
	const std::vector<Hull> hulls = MeshPieces::make(ring);
	CHECK(hulls.size() > 3);
	CHECK(hulls.size() <= size_t(MeshPieces::MAX_PIECES));
	CHECK(farthest_corner(hulls, ring) < 1e-4);
	CHECK(outside_of(hulls, { 0, 0, 0 }) > 0.3); // the hole's radius is 0.75
	for (int i = 0; i < 100; i++) {
		const double around = 2.0 * std::numbers::pi * i / 100;
		CHECK(outside_of(hulls, { std::cos(around), 0.0, std::sin(around) }) < 0.0);
		CHECK(outside_of(hulls, { 1.6 * std::cos(around), 0.0, 1.6 * std::sin(around) }) > 0.0);
	}
}

TEST_CASE("a sheet that encloses nothing is covered") {
	Corners sheet;
	for (int i = 0; i < 16; i++) { // half a pipe, 1 m long
		const auto at = [](int p_step, double p_along) {
			return Eigen::Vector3d(std::cos(std::numbers::pi * p_step / 16), -std::sin(std::numbers::pi * p_step / 16), p_along);
		};
		add_quad({ at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1) }, sheet);
	}
	const std::vector<Hull> hulls = MeshPieces::make(sheet);
	CHECK(hulls.size() > 3);
	CHECK(farthest_corner(hulls, sheet) < 1e-5);
	CHECK(outside_of(hulls, { 0, -0.3, 0.5 }) > 0.1);
}

TEST_CASE("odd meshes") {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	CHECK(MeshPieces::make(Corners{}).empty());
	CHECK(MeshPieces::make(Corners(2, Eigen::Vector3d::Zero())).empty());
	CHECK(MeshPieces::make(Corners{ { 0, 0, 0 }, { 1, nan, 0 }, { 0, 0, 1 } }).empty());
	CHECK(MeshPieces::make(Corners{ { 0, 0, 0 }, { 1e30, 0, 0 }, { 0, 0, 1 } }).empty());
	CHECK(MeshPieces::make(Corners(3 * (MeshPieces::MAX_FACES + 1), Eigen::Vector3d::Ones())).empty());
	CHECK(MeshPieces::make(Corners(3, Eigen::Vector3d::Ones())).size() == 1); // a point
	CHECK(MeshPieces::make(Corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } }).size() == 1);
}

TEST_CASE("the same mesh has the same pieces, made once") {
	const Corners ring = make_ring();
	const MeshPieces::Future first = MeshPieces::begin(ring), second = MeshPieces::begin(ring);
	CHECK(&first.get() == &second.get());
	CHECK(first.get().size() == MeshPieces::make(ring).size());
	for (int i = 0; i < 20; i++) { // others push it out, and who holds it keeps it
		CHECK(MeshPieces::begin(make_box({ 0, 0, 0 }, { 1, 1, 1.0 + i })).get().size() == 1);
	}
	CHECK(&MeshPieces::begin(ring).get() != &first.get());
}
