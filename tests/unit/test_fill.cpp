// SPDX-License-Identifier: MIT
// Where rules let grass grow.
#include "fill_scene.h"
#include "on_threads.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double CELLS_A_CHUNK = 128.0 * 128.0;

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

TEST_CASE("fill: what plants lets grass grow whatever the conditions say; only obstacles take of it") {
	FillObstacle hedge = FillObstacle::line({ { -30.0, 0.0 }, { 30.0, 0.0 } });
	hedge.set_clearance(2.0, 4.0);
	hedge.set_planting(true);
	FillObstacle yard = FillObstacle::solid(shape_of(GRASS_BOX, { 5.0, 1.0, 5.0 }), pose_of({ 20.0, 0.0, 0.0 }), 1.0);
	const FillRule rule = rule_of({ { FILL_DENSITY, 0.2 }, { FILL_NOISE_COVER, 0.5 } });
	PaintMap without, with;
	fill_all(without, rule);
	const FillSources sources = sources_of({ hedge, yard });
	const FillResult result = fill_all(with, rule, sources);
	CHECK(density_at(with, 0.0, 0.0) == 1.0);
	CHECK(density_at(with, -10.0, 1.5) == 1.0);
	CHECK(density_at(with, 20.0, 1.0) == 0.0); // the yard
	for (double z = -40.0; z < 40.0; z += 1.25) {
		CHECK(density_at(with, 3.25, z) >= density_at(without, 3.25, z) - 1e-9);
		if (std::abs(z) > 7.0) {
			CHECK(density_at(with, 3.25, z) == density_at(without, 3.25, z));
		}
	}
	// Half of the fade counts: 60 m of 4 + 4 m, and the round ends.
	FillSources lone = sources_of({ hedge });
	const double area = filled(rule_of({ { FILL_DENSITY, 0.0 } }), lone);
	CHECK(area == doctest::Approx(60.0 * 8.0 + PI * 16.8).epsilon(0.02)); // integral of the smooth fade around a point: 16.8 pi
	CHECK(result.cells == 256 * 256);
}
