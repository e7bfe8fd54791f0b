// SPDX-License-Identifier: MIT
// Where rules leave the ground free: around points and lines, under shapes and meshes.
#include "fill_scene.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

TEST_CASE("fill_obstacle: a line reaches the squares that it comes near to, not all of its box") {
	FillObstacle line = FillObstacle::line({ { -100.0, -100.0 }, { 100.0, 100.0 } });
	line.set_clearance(2.0, 1.0);
	const auto reaches = [&](double p_x, double p_z) { return line.reaches({ p_x, p_z }, { p_x + 64.0, p_z + 64.0 }); };
	CHECK(reaches(0.0, 0.0));
	CHECK(reaches(-64.0, 0.0)); // a corner
	CHECK_FALSE(reaches(-100.0, 30.0));
	CHECK_FALSE(reaches(200.0, 200.0));
	CHECK_FALSE(FillObstacle::line({}).reaches({ 0.0, 0.0 }, { 64.0, 64.0 }));
}

TEST_CASE("fill: a distance is kept from points and lines, and grass comes back gradually") {
	FillObstacle tree = FillObstacle::line({ { 3.0, -2.0 } });
	tree.set_clearance(6.0, 0.0);
	CHECK(filled({}, sources_of({ tree })) == doctest::Approx(16384.0 - PI * 36.0).epsilon(0.001));
	FillObstacle road = FillObstacle::line({ { -30.0, 0.0 }, { 0.0, 0.0 }, { 0.0, 30.0 } });
	road.set_clearance(3.0, 2.0);
	PaintMap map;
	fill_all(map, {}, sources_of({ tree, road }));
	CHECK(density_at(map, -15.0, 2.5) == 0.0);
	CHECK(density_at(map, -15.0, 4.0) == doctest::Approx(0.5).epsilon(0.03));
	CHECK(density_at(map, -15.0, 5.6) == 1.0);
	CHECK(density_at(map, -2.5, 20.0) == 0.0);
	CHECK(density_at(map, 3.0, -4.0) == 0.0);
}

TEST_CASE("fill: solid shapes exclude what they stand on, turned and scaled") {
	const auto hole = [](const FillObstacle &p_obstacle) { return 16384.0 - filled({}, sources_of({ p_obstacle })); };
	const ColliderShape box = shape_of(GRASS_BOX, { 5.0, 1.0, 2.0 });
	CHECK(hole(FillObstacle::solid(box, pose_of({ 8, 0.5, 4 }), 1.0)) == doctest::Approx(40.0).epsilon(0.01));
	CHECK(hole(FillObstacle::solid(box, pose_of({ 8, 0.5, 4 }, 0.7), 1.0)) == doctest::Approx(40.0).epsilon(0.02));
	CHECK(hole(FillObstacle::solid(box, pose_of({ 8, 0.5, 4 }, 0.7, { 2, 1, 2 }), 1.0)) == doctest::Approx(160.0).epsilon(0.01));
	const ColliderShape cylinder = shape_of(GRASS_CYLINDER, { 6.0, 2.0, 0.0 });
	CHECK(hole(FillObstacle::solid(cylinder, pose_of({ 0, 0, 0 }), 1.0)) == doctest::Approx(PI * 36.0).epsilon(0.01));
	// A ball of 10 m: the column of 4 m above ground meets it as widely as it is at 4 m, 6 m below its centre.
	const ColliderShape ball = shape_of(GRASS_SPHERE, { 10.0, 0.0, 0.0 });
	CHECK(hole(FillObstacle::solid(ball, pose_of({ 0, 10, 0 }), 4.0)) == doctest::Approx(PI * 64.0).epsilon(0.02));
	const ColliderShape capsule = shape_of(GRASS_CAPSULE, { 2.0, 3.0, 0.0 });
	const Eigen::Affine3d lying = Eigen::Translation3d(0, 1, 0) * Eigen::AngleAxisd(0.5 * PI, Eigen::Vector3d::UnitZ());
	CHECK(hole(FillObstacle::solid(capsule, lying, 1.0)) == doctest::Approx(4.0 * 6.0 + PI * 4.0).epsilon(0.02));
	ColliderShape hull = shape_of(GRASS_HULL, { 4.0, 4.0, 4.0 });
	hull.planes = { { 1, 0, 0, 4 }, { -1, 0, 0, 4 }, { 0, 0, 1, 4 }, { 0, 0, -1, 4 }, { 0, 1, 0, 4 }, { 0, -1, 0, 4 } };
	CHECK(hole(FillObstacle::solid(hull, pose_of({ 0, 0, 0 }), 1.0)) == doctest::Approx(64.0));
	CHECK(hole(FillObstacle::solid(box, pose_of({ NAN_VALUE, 0, 0 }), 1.0)) == 0.0);
	CHECK(hole(FillObstacle::solid(box, pose_of({ 0, 0, 0 }, 0.0, { 0, 1, 1 }), 1.0)) == 0.0);
}

TEST_CASE("fill: a shape counts where it comes near the ground there, not above and not below") {
	const ColliderShape slab = shape_of(GRASS_BOX, { 5.0, 0.05, 5.0 }); // thin: it may lie anywhere in the column
	const auto excludes = [&](double p_y) {
		return FillObstacle::solid(slab, pose_of({ 0, p_y, 0 }), 1.0).get_share({ { 0.0, 0.0 }, 20.0 }) == 0.0;
	};
	CHECK_FALSE(excludes(19.6));
	for (const double y : { 19.8, 19.95, 20.0, 20.1, 20.33, 20.52, 20.77, 21.0 }) {
		INFO("at ", y);
		CHECK(excludes(y));
	}
	CHECK_FALSE(excludes(21.2)); // a bridge
}

TEST_CASE("fill: outlines may be hollow, and fade outwards") {
	// A U of 12 x 12 m with a bay of 4 x 8 m.
	FillObstacle u = FillObstacle::outline({ { 0, 0 }, { 12, 0 }, { 12, 12 }, { 8, 12 }, { 8, 4 }, { 4, 4 }, { 4, 12 }, { 0, 12 } });
	CHECK(16384.0 - filled({}, sources_of({ u })) == doctest::Approx(144.0 - 32.0));
	CHECK(u.get_share({ { 6.0, 8.0 }, 0.0 }) == 1.0);
	CHECK(u.get_share({ { 2.0, 8.0 }, 50.0 }) == 0.0);
	u.set_clearance(0.0, 2.0);
	CHECK(u.get_share({ { -1.0, 6.0 }, 0.0 }) == doctest::Approx(0.5));
	CHECK(u.get_share({ { -2.5, 6.0 }, 0.0 }) == 1.0);
	CHECK(FillObstacle::outline({ { 0, 0 }, { 1, 1 } }).is_nowhere());
	CHECK(FillObstacle::outline({ { 0, 0 }, { 1, 1 }, { NAN_VALUE, 0 } }).is_nowhere());
}

TEST_CASE("fill: a mesh excludes the ground that its faces lie on, whatever way they turn") {
	const std::vector<Eigen::Vector3d> faces = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 0, 10 }, { 10, 0, 10 }, { 0, 0, 0 }, { 0, 0, 10 }, //
		{ 20, 0, 0 }, { 20, 9, 0 }, { 20, 0, 9 }, // a wall
		{ -30, 5, -30 }, { -20, 5, -30 }, { -20, 5, -20 } }; // a roof
	FillObstacle floor = FillObstacle::mesh(faces, 1.0);
	CHECK(16384.0 - filled({}, sources_of({ floor })) == doctest::Approx(100.0).epsilon(0.02));
	CHECK(floor.get_share({ { 5.0, 5.0 }, 0.0 }) == 0.0);
	CHECK(floor.get_share({ { 20.0, 40.0 }, 0.0 }) == 1.0);
	CHECK(floor.get_share({ { -22.0, -28.0 }, 0.0 }) == 1.0);
	CHECK(FillObstacle::mesh(faces, 6.0).get_share({ { -22.0, -28.0 }, 0.0 }) == 0.0);
	floor.set_clearance(1.0, 2.0);
	CHECK(floor.get_share({ { 5.0, -0.9 }, 0.0 }) == 0.0);
	CHECK(floor.get_share({ { 5.0, -2.0 }, 0.0 }) == doctest::Approx(0.5));
}
