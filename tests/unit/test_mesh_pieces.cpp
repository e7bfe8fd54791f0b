// SPDX-License-Identifier: MIT
#include "hulls.h"

#include "core/blades/patch.h"
#include "core/bodies/mesh_pieces.h"
#include "core/tiles/tiles.h"

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

// Returns a curved sheet over the square from (-1, -1) to (1, 1) times p_size.
Corners make_waves(double p_size) {
	constexpr int STEPS = 24;
	const auto at = [p_size](int p_x, int p_z) {
		const double x = 2.0 * p_x / STEPS - 1.0, z = 2.0 * p_z / STEPS - 1.0;
		return Eigen::Vector3d(p_size * Eigen::Vector3d(x, 0.3 * std::sin(4.0 * x) * std::cos(5.0 * z), z));
	};
	Corners corners;
	for (int x = 0; x < STEPS; x++) {
		for (int z = 0; z < STEPS; z++) {
			add_quad({ at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z + 1) }, corners);
		}
	}
	return corners;
}

// Returns a tube of 0.12 around a trefoil knot, 2 m wide.
Corners make_knot() {
	constexpr int AROUND = 8, ALONG = 96;
	constexpr double TURN = 2.0 * std::numbers::pi;
	const auto middle = [](double p_along) {
		const double radius = 0.28 * (2.0 + std::cos(3.0 * p_along));
		return Eigen::Vector3d(radius * std::cos(2.0 * p_along), 0.28 * std::sin(3.0 * p_along), radius * std::sin(2.0 * p_along));
	};
	const auto at = [&](int p_along, int p_around) {
		const double along = TURN * p_along / ALONG, around = TURN * p_around / AROUND;
		const Eigen::Vector3d way = (middle(along + 1e-3) - middle(along)).normalized(), side = way.unitOrthogonal();
		return Eigen::Vector3d(middle(along) + 0.12 * (side * std::cos(around) + way.cross(side) * std::sin(around)));
	};
	Corners corners;
	for (int i = 0; i < ALONG; i++) {
		for (int k = 0; k < AROUND; k++) {
			add_quad({ at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1) }, corners);
		}
	}
	return corners;
}

// Pairs of tiles and colliders, summed over ticks in which they move through grass together, 2 m/s, from a little above the ground.
int count_pairs(const std::vector<ColliderShape> &p_shapes, double p_bottom, double p_turn) {
	static const Patch patch = generate_patch(PatchParams());
	constexpr double STEP = 2.0 / 60.0, ABOVE = 0.02; // metres
	const TileGrid grid = TileGrid::make(20.0, 20.0, 256.0);
	const auto bounds = std::make_shared<TileBounds>(patch, grid, ClumpParams(), 0u);
	TileManager manager;
	TileParams params;
	params.overhang = bounds->get_overhang();
	params.height = bounds->get_height();
	manager.set_grid(grid);
	manager.set_params(params);
	manager.set_bounds(bounds);
	const Quaternion turn(Eigen::AngleAxisd(p_turn, Eigen::Vector3d::UnitY()));
	int pairs = 0;
	for (int i = 0; i < 30; i++) {
		std::vector<ColliderShape> shapes = p_shapes;
		for (ColliderShape &shape : shapes) {
			shape.now.position = turn * shape.now.position + Eigen::Vector3d(STEP * i - 0.5, ABOVE - p_bottom, 0.1);
			shape.before.position = shape.now.position - Eigen::Vector3d(STEP, 0.0, 0.0);
			shape.now.rotation = shape.before.rotation = turn;
		}
		manager.update(1.0 / 60.0, shapes);
		pairs += manager.get_statistics().list_entries;
	}
	return pairs;
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

TEST_CASE("in grass a mesh of 2 m has at most 2.5 times as many pairs of tiles and colliders as the box around it") {
	for (const Corners &mesh : { make_knot(), make_waves(1.0) }) {
		Eigen::AlignedBox3d box;
		for (const Eigen::Vector3d &corner : mesh) {
			box.extend(corner);
		}
		ColliderShape around;
		around.type = GRASS_BOX;
		around.size = 0.5 * box.sizes();
		around.now.position = box.center();
		std::vector<ColliderShape> pieces;
		for (const Hull &hull : MeshPieces::make(mesh)) {
			ColliderShape &piece = pieces.emplace_back();
			piece.type = GRASS_HULL;
			piece.size = hull.half_extents;
			piece.planes = hull.planes;
			piece.now.position = hull.centre;
		}
		CHECK(pieces.size() > 2);
		for (const double turn : { 0.0, 0.5 }) {
			const double bottom = box.min().y();
			CHECK(count_pairs(pieces, bottom, turn) <= 2.5 * count_pairs({ around }, bottom, turn));
		}
	}
}

TEST_CASE("a large mesh has as many pieces as ever: each of them is in few tiles") {
	CHECK(MeshPieces::make(make_waves(10.0)).size() == size_t(MeshPieces::MAX_PIECES));
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
