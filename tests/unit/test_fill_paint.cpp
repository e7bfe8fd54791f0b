// SPDX-License-Identifier: MIT
// Rules and hands in one map.
#include "fill_scene.h"

#include "core/paint/brush.h"
#include "core/paint/hand_paint.h"

#include <doctest/doctest.h>

#include <random>

using namespace grass;
using namespace grass::test;

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
