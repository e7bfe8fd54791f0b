// SPDX-License-Identifier: MIT
// What is filled again when something changes, counted in cells.
#include "core/fill/live_fill.h"
#include "core/paint/brush.h"

#include <doctest/doctest.h>

using namespace grass;

namespace {

constexpr int64_t CHUNK = 128 * 128; // cells
const MapRegion AREA{ { -256.0, -256.0 }, { 256.0, 256.0 } }; // 64 chunks

std::shared_ptr<const FillObstacle> tree_at(double p_x, double p_z) {
	FillObstacle tree = FillObstacle::line({ { p_x, p_z } });
	tree.set_clearance(2.0, 1.0);
	return std::make_shared<const FillObstacle>(tree);
}

double density_at(const PaintMap &p_map, double p_x, double p_z) {
	return p_map.sample(MAP_DENSITY, 0, { p_x, p_z });
}

struct Scene {
	PaintMap map;
	LiveFill live;
	FillRule rule;
	FillSources sources;

	FillResult refill(int p_count = -1) {
		live.set(rule, sources, AREA);
		return live.work(map, p_count);
	}
};

} // namespace

TEST_CASE("live_fill: fills once, and then nothing as long as nothing changes") {
	Scene scene;
	CHECK_FALSE(scene.live.is_set());
	CHECK(scene.refill().cells == 64 * CHUNK);
	CHECK(scene.refill().cells == 0);
	scene.rule.params[FILL_DENSITY] = 0.5;
	const FillResult result = scene.refill();
	CHECK(result.cells == 64 * CHUNK);
	CHECK(result.changed.size() == 64);
	CHECK(scene.refill().cells == 0);
}

TEST_CASE("live_fill: work is done in portions, and each portion comes once") {
	Scene scene;
	scene.live.set(scene.rule, scene.sources, AREA);
	size_t changed = 0;
	int portions = 0;
	while (scene.live.get_waiting() > 0) {
		const FillResult result = scene.live.work(scene.map, 5);
		CHECK(result.cells <= 5 * CHUNK);
		changed += result.changed.size();
		portions++;
	}
	CHECK(changed == 64);
	CHECK(portions == 13);
	scene.rule.params[FILL_DENSITY] = 0.5;
	scene.refill(5);
	scene.rule.params[FILL_DENSITY] = 0.25; // before the portions are done: all anew, with the last rule only
	CHECK(scene.refill().cells == 64 * CHUNK);
	CHECK(density_at(scene.map, -200.0, -200.0) == doctest::Approx(0.25).epsilon(0.01));
}

TEST_CASE("live_fill: an obstacle that moves concerns the chunks that it leaves and comes to") {
	Scene scene;
	const auto still = tree_at(-100.0, -100.0);
	scene.sources.obstacles = { still, tree_at(10.0, 10.0) };
	scene.refill();
	CHECK(density_at(scene.map, 10.0, 10.0) == 0.0);
	scene.sources.obstacles[1] = tree_at(150.0, 20.0);
	CHECK(scene.refill().cells == 2 * CHUNK);
	CHECK(density_at(scene.map, 10.0, 10.0) == 1.0);
	CHECK(density_at(scene.map, 150.0, 20.0) == 0.0);
	scene.sources.obstacles[1] = tree_at(5000.0, 20.0); // out of the field
	CHECK(scene.refill().cells == CHUNK);
	scene.sources.obstacles = { still };
	CHECK(scene.refill().cells == 0);
	scene.sources.has_mesh = true;
	CHECK(scene.refill().cells == 64 * CHUNK);
	CHECK(density_at(scene.map, 0.0, 0.0) == 0.0);
}

TEST_CASE("live_fill: strokes fill nothing again; new ground does where the rule asks for it") {
	Scene scene;
	scene.rule.params[FILL_SLOPE_MAX] = 30.0;
	scene.refill();
	Brush brush;
	brush.tool = MapTool::ERASE;
	const BrushResult stroke = apply_brush(scene.map, MapShape::stroke({ 30, 30 }, { 30, 30 }, 4.0, 1.0, Falloff::LINEAR), brush);
	scene.live.touch(scene.map, stroke.changed, false);
	CHECK(scene.refill().cells == 0);
	const auto tilt = [&](int p_i, int p_j) {
		scene.map.set_code(MAP_NORMAL, 0, p_i, p_j, info_of(MAP_NORMAL).highest);
		const MapKey key[] = { key_of(MAP_NORMAL, p_i, p_j) };
		scene.live.touch(scene.map, key, false);
	};
	tilt(70, 10);
	CHECK(scene.refill().cells == 9 * CHUNK); // with those that the ground blends into
	CHECK(density_at(scene.map, 70.5, 10.5) < 0.1);
	CHECK(density_at(scene.map, 30.0, 30.0) == 0.0); // erased by hand
	scene.rule = FillRule();
	scene.refill();
	tilt(70, 20);
	CHECK(scene.refill().cells == 0);
}

TEST_CASE("live_fill: what comes from a snapshot is filled by the rule of now") {
	Scene scene;
	scene.refill();
	const PaintMap before = scene.map;
	scene.rule.params[FILL_DENSITY] = 0.5;
	scene.refill();
	const std::vector<MapKey> changed = scene.map.compare(before);
	scene.map = before;
	scene.live.touch(scene.map, changed, true);
	CHECK(scene.refill().cells == 64 * CHUNK);
	CHECK(density_at(scene.map, 3.0, 3.0) == doctest::Approx(0.5).epsilon(0.01));
	const MapKey outside[] = { { 100, 100 } };
	scene.live.touch(scene.map, outside, true);
	CHECK(scene.live.get_waiting() == 0);
}

TEST_CASE("live_fill: without its rule the map is what it was, but for paint") {
	Scene scene;
	scene.refill();
	Brush brush;
	apply_brush(scene.map, MapShape::stroke({ 30, 30 }, { 30, 30 }, 4.0, 1.0, Falloff::LINEAR), brush);
	const FillResult result = scene.live.remove(scene.map);
	CHECK(result.changed.size() == 64);
	CHECK_FALSE(scene.live.is_set());
	CHECK(density_at(scene.map, 30.0, 30.0) == 1.0);
	CHECK(density_at(scene.map, 60.0, 30.0) == 0.0);
	CHECK(scene.live.remove(scene.map).changed.empty());
}

TEST_CASE("live_fill: a rule that forbids all leaves nothing along the border, wherever that lies") {
	for (const double half : { 64.0, 16.0, 6.65, 32.2 }) {
		CAPTURE(half);
		PaintMap map;
		map.set_base_density(1.0);
		FillRule rule;
		rule.params[FILL_DENSITY] = 0.0;
		const MapRegion area{ { -half, -half }, { half, half } };
		LiveFill live;
		live.set(rule, {}, area);
		const FillResult filled = live.work(map, -1);
		for (double along = -half; along <= half; along += 0.37) {
			for (const double side : { -half, half }) {
				CHECK(density_at(map, along, side) == 0.0);
				CHECK(density_at(map, side, along) == 0.0);
			}
		}
		CHECK(density_at(map, half + 2.0, 0.0) == 1.0);
		CHECK(double(filled.cells) * 0.25 == doctest::Approx(4.0 * half * half).epsilon(0.05)); // the rim is not counted
		live.remove(map);
		map.compact();
		CHECK(map.is_empty());
	}
}

TEST_CASE("live_fill: without a rule only the places of obstacles change, and grass comes back where they were") {
	Scene scene;
	scene.map.set_base_density(0.5);
	FillRule noise;
	noise.params[FILL_DENSITY] = 0.25;
	fill(scene.map, chunks_in({ { 64.0, 0.0 }, { 128.0, 64.0 } }), AREA, &noise, {}); // what GrassMap.fill() left, for good
	scene.rule.params[FILL_DENSITY] = scene.map.get_base_density();
	scene.rule.only_at_obstacles = true;
	CHECK(scene.refill().cells == 0);
	scene.sources.obstacles = { tree_at(32.0, 32.0), tree_at(80.0, 32.0) };
	CHECK(scene.refill().cells == 2 * CHUNK);
	CHECK(density_at(scene.map, 32.25, 32.25) == 0.0);
	CHECK(density_at(scene.map, 80.25, 32.25) == 0.0);
	CHECK(density_at(scene.map, 40.25, 32.25) == doctest::Approx(0.5).epsilon(0.01));
	CHECK(density_at(scene.map, 90.25, 32.25) == doctest::Approx(0.25).epsilon(0.01));
	scene.sources.obstacles = { tree_at(40.0, 32.0) };
	scene.live.set(scene.rule, scene.sources, AREA);
	scene.live.work(scene.map, 1); // in two portions
	scene.live.set(scene.rule, scene.sources, AREA);
	scene.live.work(scene.map, 1);
	CHECK(scene.live.get_waiting() == 0);
	CHECK(density_at(scene.map, 32.25, 32.25) == doctest::Approx(0.5).epsilon(0.01));
	CHECK(density_at(scene.map, 80.25, 32.25) == doctest::Approx(0.5).epsilon(0.01)); // the base density: of the other nothing is known
	CHECK(density_at(scene.map, 40.25, 32.25) == 0.0);
	CHECK(density_at(scene.map, 90.25, 32.25) == doctest::Approx(0.25).epsilon(0.01));
}

TEST_CASE("live_fill: without a rule grass comes back below a solid once the ground is too low for it") {
	Scene scene;
	scene.map.set_base_density(1.0);
	scene.rule.only_at_obstacles = true;
	ColliderShape box;
	box.type = GRASS_BOX;
	box.size = { 4.0, 1.0, 4.0 };
	scene.sources.obstacles = { std::make_shared<const FillObstacle>(
			FillObstacle::solid(box, Eigen::Affine3d(Eigen::Translation3d(32.0, 0.5, 32.0)), 1.0)) };
	scene.refill();
	CHECK(density_at(scene.map, 32.25, 32.25) == 0.0);
	for (int j = 0; j < 64; j++) {
		for (int i = 0; i < 64; i++) {
			scene.map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(-5.0));
		}
	}
	const MapKey chunk{ 0, 0 };
	scene.live.touch(scene.map, { &chunk, 1 }, false);
	scene.live.work(scene.map, -1);
	CHECK(density_at(scene.map, 32.25, 32.25) == 1.0);
}
