// SPDX-License-Identifier: MIT
#include "on_threads.h"

#include "core/fill/fill.h"
#include "core/paint/brush.h"
#include "core/paint/hand_paint.h"

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <numbers>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double PI = std::numbers::pi;
constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();
constexpr double CELLS_A_CHUNK = 128.0 * 128.0;

const MapRegion AREA{ { -64.0, -64.0 }, { 64.0, 64.0 } }; // four chunks

FillRule rule_of(std::initializer_list<std::pair<FillParamId, double>> p_params) {
	FillRule rule;
	for (const auto &[param, value] : p_params) {
		rule.params[size_t(param)] = value;
	}
	return rule;
}

FillResult fill_all(PaintMap &r_map, const FillRule &p_rule, const FillSources &p_sources = {}, const MapRegion &p_area = AREA) {
	return fill(r_map, chunks_in(p_area), p_area, &p_rule, p_sources);
}

// Square metres of full grass.
double filled(const FillRule &p_rule, const FillSources &p_sources = {}) {
	PaintMap map;
	return fill_all(map, p_rule, p_sources).amount;
}

FillSources sources_of(std::vector<FillObstacle> p_obstacles) {
	FillSources sources;
	for (const FillObstacle &obstacle : p_obstacles) {
		sources.obstacles.push_back(std::make_shared<const FillObstacle>(obstacle));
	}
	return sources;
}

// Ground of a height and a slope along x and z at each place.
void lay(PaintMap &r_map, const std::function<double(const Eigen::Vector2d &)> &p_height) {
	constexpr double STEP = 1e-4;
	for (int j = -70; j < 70; j++) {
		for (int i = -70; i < 70; i++) {
			const Eigen::Vector2d at(i + 0.5, j + 0.5);
			const auto slope = [&](const Eigen::Vector2d &p_way) {
				return (p_height(at + STEP * p_way) - p_height(at - STEP * p_way)) / (2.0 * STEP);
			};
			const Eigen::Vector3d normal = Eigen::Vector3d(-slope({ 1, 0 }), 1.0, -slope({ 0, 1 })).normalized();
			r_map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(p_height(at)));
			r_map.set_code(MAP_NORMAL, 0, i, j, info_of(MAP_NORMAL).code(normal.x()));
			r_map.set_code(MAP_NORMAL, 1, i, j, info_of(MAP_NORMAL).code(normal.z()));
		}
	}
}

ColliderShape shape_of(int p_type, const Eigen::Vector3d &p_size) {
	ColliderShape shape;
	shape.type = p_type;
	shape.size = p_size;
	return shape;
}

Eigen::Affine3d pose_of(const Eigen::Vector3d &p_at, double p_turn = 0.0, const Eigen::Vector3d &p_scale = Eigen::Vector3d::Ones()) {
	return Eigen::Translation3d(p_at) * Eigen::AngleAxisd(p_turn, Eigen::Vector3d::UnitY()) * Eigen::Scaling(p_scale);
}

double density_at(const PaintMap &p_map, double p_x, double p_z) {
	return p_map.sample(MAP_DENSITY, 0, { p_x, p_z });
}

} // namespace

TEST_CASE("fill: a rule that asks nothing fills its area and no more, each cell once") {
	PaintMap map;
	const MapRegion area{ { -10.0, 5.0 }, { 30.0, 70.0 } };
	const FillResult result = fill_all(map, rule_of({ { FILL_DENSITY, 0.6 } }), {}, area);
	CHECK(result.amount == doctest::Approx(0.6 * 40.0 * 65.0));
	CHECK(result.cells == 80 * 130);
	CHECK(result.changed == std::vector<MapKey>{ { -1, 0 }, { -1, 1 }, { 0, 0 }, { 0, 1 } });
	CHECK(map.get_code(MAP_DENSITY, 0, -20, 10) == 153);
	CHECK(map.get_code(MAP_DENSITY, 0, -21, 10) == 0);
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 139) == 153);
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 140) == 0);
}

TEST_CASE("fill: an area that is empty, broken or out of reach has the chunks that exist") {
	CHECK(chunks_in(MapRegion()).empty());
	CHECK(chunks_in(MapRegion{ { NAN_VALUE, 0.0 }, { 5.0, 5.0 } }).empty());
	CHECK(chunks_in(MapRegion{ { 0.0, 0.0 }, { 64.0, 64.0 } }).size() == 1);
	CHECK(chunks_in(MapRegion{ { 16000.0, 0.0 }, { 1e9, 1.0 } }).size() == 6);
}

TEST_CASE("fill: slope on a cone, whose sides are as steep everywhere") {
	const auto filled_cone = [](std::initializer_list<std::pair<FillParamId, double>> p_params) {
		PaintMap map;
		lay(map, [](const Eigen::Vector2d &p_at) { return -p_at.norm() * std::tan(PI / 6.0); }); // 30 degrees
		return fill_all(map, rule_of(p_params)).amount / (128.0 * 128.0);
	};
	CHECK(filled_cone({ { FILL_SLOPE_MAX, 32.0 } }) == doctest::Approx(1.0).epsilon(0.001));
	CHECK(filled_cone({ { FILL_SLOPE_MAX, 20.0 }, { FILL_SLOPE_FADE, 9.0 } }) < 0.003); // the tip is flat
	CHECK(filled_cone({ { FILL_SLOPE_MAX, 25.0 }, { FILL_SLOPE_FADE, 10.0 } }) == doctest::Approx(0.5).epsilon(0.05));
	CHECK(filled_cone({ { FILL_SLOPE_MIN, 28.0 }, { FILL_SLOPE_FADE, 0.0 } }) == doctest::Approx(1.0).epsilon(0.003));
	CHECK(filled_cone({ { FILL_SLOPE_MIN, 35.0 }, { FILL_SLOPE_FADE, 10.0 } }) == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("fill: height on a cone fills a ring") {
	PaintMap map;
	lay(map, [](const Eigen::Vector2d &p_at) { return 30.0 - p_at.norm(); });
	const double ring = fill_all(map, rule_of({ { FILL_HEIGHT_MIN, 10.0 }, { FILL_HEIGHT_MAX, 20.0 }, { FILL_HEIGHT_FADE, 0.0 } })).amount;
	CHECK(ring == doctest::Approx(PI * (20.0 * 20.0 - 10.0 * 10.0)).epsilon(0.01));
	CHECK(density_at(map, 15.0, 0.0) == 1.0);
	CHECK(density_at(map, 0.0, 8.0) == 0.0);
	// Faded over 2 m on both sides; the smooth step has its half in the middle.
	fill_all(map, rule_of({ { FILL_HEIGHT_MIN, 10.0 }, { FILL_HEIGHT_MAX, 20.0 }, { FILL_HEIGHT_FADE, 2.0 } }));
	CHECK(density_at(map, 9.0, 0.0) == doctest::Approx(0.5).epsilon(0.1));
	CHECK(density_at(map, 0.0, -21.0) == doctest::Approx(0.5).epsilon(0.1));
}

TEST_CASE("fill: without ground the field is level, at its own height") {
	CHECK(filled(rule_of({ { FILL_SLOPE_MIN, 20.0 } })) == 0.0);
	CHECK(filled(rule_of({ { FILL_HEIGHT_MAX, -5.0 } })) == 0.0);
	CHECK(filled(rule_of({ { FILL_HEIGHT_MIN, -5.0 }, { FILL_SLOPE_MAX, 10.0 } })) == 128.0 * 128.0);
}

TEST_CASE("fill: noise leaves the share of the ground that it is told to, hard or soft") {
	for (const double cover : { 0.15, 0.5, 0.8 }) {
		for (const double fade : { 0.0, 0.5, 1.0 }) {
			INFO("cover ", cover, " fade ", fade);
			const double share =
					filled(rule_of({ { FILL_NOISE_COVER, cover }, { FILL_NOISE_SIZE, 3.0 }, { FILL_NOISE_FADE, fade } })) / (128.0 * 128.0);
			CHECK(share == doctest::Approx(cover).epsilon(0.12));
		}
	}
	CHECK(filled(rule_of({ { FILL_NOISE_COVER, 0.0 } })) == 0.0);
}

TEST_CASE("fill: a seed gives the same noise every time, another seed another") {
	FillRule rule = rule_of({ { FILL_NOISE_COVER, 0.5 } });
	PaintMap one, same, other;
	fill_all(one, rule);
	fill_all(same, rule_of({ { FILL_DENSITY, 0.3 } })); // whatever was there before
	fill_all(same, rule);
	CHECK(one.compare(same).empty());
	CHECK(fill_all(one, rule).changed.empty());
	rule.seed = 1;
	fill_all(other, rule);
	CHECK(one.compare(other).size() == 4);
	CHECK(fill_noise({ 3.0, 700.0 }, 8.0, 5) != fill_noise({ 3.0 + 64.0 * 8.0, 700.0 }, 8.0, 5)); // does not repeat
	double least = 1.0, most = 0.0, furthest = 0.0;
	for (int n = 0; n < 20000; n++) {
		const double noise = fill_noise({ 0.31 * n, 7.0 }, 8.0, 2), next = fill_noise({ 0.31 * n + 0.01, 7.0 }, 8.0, 2);
		least = std::min(least, noise);
		most = std::max(most, noise);
		furthest = std::max(furthest, std::abs(next - noise));
	}
	CHECK(least < 0.02);
	CHECK(most > 0.98);
	CHECK(furthest < 0.02); // without steps
}

TEST_CASE("fill: a mask is laid over its rectangle, blended, and nothing grows beside it") {
	FillRule rule;
	rule.has_mask = true;
	CHECK(filled(rule) == 0.0); // no picture yet
	auto mask = std::make_shared<FillMask>();
	mask->width = 2;
	mask->height = 1;
	mask->texels = { 0, 255 };
	rule.mask = mask;
	CHECK(filled(rule) == 0.0); // nowhere
	rule.mask_min = { -20.0, 0.0 };
	rule.mask_max = { 20.0, 10.0 };
	PaintMap map;
	CHECK(fill_all(map, rule).amount == doctest::Approx(200.0).epsilon(0.01));
	CHECK(density_at(map, -15.0, 5.0) == 0.0);
	CHECK(density_at(map, 0.0, 5.0) == doctest::Approx(0.5).epsilon(0.02));
	CHECK(density_at(map, 15.0, 5.0) == 1.0);
	CHECK(density_at(map, 25.0, 5.0) == 0.0);
	rule.inverts_mask = true;
	fill_all(map, rule);
	CHECK(density_at(map, -15.0, 5.0) == 1.0);
	CHECK(density_at(map, 5.0, 5.0) == doctest::Approx(0.25).epsilon(0.05));
	CHECK(density_at(map, 25.0, 5.0) == 0.0);
	mask->texels.resize(1); // damaged
	rule.inverts_mask = false;
	CHECK(filled(rule) == 0.0);
}

TEST_CASE("fill: a coloured mesh says where grass grows; of two above each other the higher one") {
	FillSources sources;
	sources.has_mesh = true;
	CHECK(filled({}, sources) == 0.0);
	auto mesh = std::make_shared<FillMesh>();
	const auto quad = [&](double p_left, double p_right, double p_y, double p_share_left, double p_share_right) {
		const FillMesh::Corner a{ { p_left, p_y, -20.0 }, p_share_left }, b{ { p_right, p_y, -20.0 }, p_share_right },
				c{ { p_right, p_y, 20.0 }, p_share_right }, d{ { p_left, p_y, 20.0 }, p_share_left };
		mesh->add(a, b, c);
		mesh->add(c, d, a);
	};
	quad(-30.0, 30.0, 0.0, 0.0, 1.0);
	sources.mesh = mesh;
	PaintMap map;
	CHECK(fill_all(map, {}, sources).amount == doctest::Approx(0.5 * 60.0 * 40.0).epsilon(0.01));
	CHECK(density_at(map, 15.0, 0.0) == doctest::Approx(0.75).epsilon(0.01));
	CHECK(density_at(map, 35.0, 0.0) == 0.0);
	quad(-10.0, 10.0, 5.0, 1.0, 1.0);
	quad(-10.0, 10.0, -5.0, 0.0, 0.0);
	fill_all(map, {}, sources);
	CHECK(density_at(map, 0.0, 0.0) == 1.0);
	CHECK(density_at(map, 15.0, 0.0) == doctest::Approx(0.75).epsilon(0.01));
	const int64_t count = mesh->get_triangle_count();
	mesh->add({ { NAN_VALUE, 0, 0 }, 1.0 }, { { 1, 0, 0 }, 1.0 }, { { 0, 0, 1 }, 1.0 });
	mesh->add({ { 0, 0, 0 }, 1.0 }, { { 1e9, 0, 0 }, 1.0 }, { { 0, 0, 1 }, 1.0 });
	mesh->add({ { 0, 0, 0 }, 1.0 }, { { 0, 5, 0 }, 1.0 }, { { 9, 0, 0 }, 1.0 }); // a wall
	CHECK(mesh->get_triangle_count() == count);
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

TEST_CASE("fill: what hands painted stays, and the rule shows as far as paint lets it") {
	PaintMap map;
	const FillRule full, half = rule_of({ { FILL_DENSITY, 0.5 } }), none = rule_of({ { FILL_DENSITY, 0.0 } });
	fill_all(map, none);
	Brush brush;
	brush.tool = MapTool::PAINT;
	brush.target = 0.8;
	apply_brush(map, MapShape::stroke({ 20, 0 }, { 20, 0 }, 5.0, 1.0, Falloff::LINEAR), brush);
	brush.tool = MapTool::ERASE;
	apply_brush(map, MapShape::stroke({ -20, 0 }, { -20, 0 }, 8.0, 0.5, Falloff::LINEAR), brush);
	brush.tool = MapTool::PAINT;
	brush.target = 0.2;
	fill_all(map, full);
	apply_brush(map, MapShape::stroke({ 0, 30 }, { 0, 30 }, 5.0, 1.0, Falloff::LINEAR), brush); // leaves more as it is
	const PaintMap painted = map;
	for (const auto &[rule, density] : { std::pair(&none, 0.0), std::pair(&half, 0.5), std::pair(&full, 1.0) }) {
		fill_all(map, *rule);
		CHECK(density_at(map, 20.0, 0.0) == doctest::Approx(0.8)); // over nothing, and now under more
		CHECK(density_at(map, -20.0, 0.0) == 0.0);
		CHECK(density_at(map, -14.0, 0.0) == doctest::Approx(0.5 * density).epsilon(0.03)); // the soft border
		CHECK(density_at(map, 0.0, 30.0) == 1.0); // found and left at 1: held
		CHECK(density_at(map, 40.0, 40.0) == doctest::Approx(density).epsilon(0.01));
	}
	CHECK(map.compare(painted).empty()); // back to where it was, however often
	fill(map, chunks_in(AREA), AREA, nullptr, {});
	CHECK(density_at(map, 20.0, 0.0) == doctest::Approx(0.8));
	CHECK(density_at(map, 40.0, 40.0) == 0.0);
}

TEST_CASE("fill: paint over a rule is what the brush made of it, stroke after stroke") {
	std::mt19937 random(3);
	std::uniform_real_distribution<double> number(0.0, 1.0);
	for (int32_t rule = 0; rule <= 255; rule += 17) {
		HandPaint paint;
		int32_t shown = rule;
		for (int stroke = 0; stroke < 40; stroke++) {
			const int32_t aim = int32_t(255.0 * number(random));
			const double weight = number(random) * number(random);
			shown = toward(shown, aim, weight);
			paint = paint.brushed(aim, weight);
			CHECK(std::abs(paint.over(rule) - shown) <= 3);
		}
		CHECK(HandPaint().brushed(rule, 1.0) == HandPaint{ rule, 255 });
		CHECK(HandPaint().brushed(rule, 0.0) == HandPaint());
	}
}

TEST_CASE("fill: chunks that become as bare as the map's base are given back") {
	PaintMap map;
	fill_all(map, {});
	CHECK(map.get_chunks().size() == 4);
	const FillResult result = fill(map, chunks_in(AREA), AREA, nullptr, {});
	CHECK(result.amount == doctest::Approx(-16384.0));
	map.compact();
	CHECK(map.is_empty());
	map.set_base_density(1.0);
	CHECK(fill_all(map, {}).changed.empty()); // as it is
	CHECK(map.is_empty());
}

TEST_CASE("fill: many threads write what one writes") {
	FillRule rule = rule_of({ { FILL_NOISE_COVER, 0.5 } });
	PaintMap one, other;
	const MapRegion area{ { -500, -500 }, { 500, 500 } };
	const FillResult serial = fill_all(one, rule, {}, area);
	CHECK(serial.cells == 2000 * 2000);
	const FillResult parallel = fill(other, chunks_in(area), area, &rule, {}, on_threads);
	CHECK(one.compare(other).empty());
	CHECK(parallel.changed == serial.changed);
	CHECK(double(serial.changed.size()) * CELLS_A_CHUNK >= double(serial.cells));
}
