// SPDX-License-Identifier: MIT
#include "core/paint/brush.h"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

using namespace grass;

namespace {

constexpr double PI = std::numbers::pi;
constexpr double NAN_VALUE = std::numeric_limits<double>::quiet_NaN();

MapShape disc(double p_x, double p_z, double p_radius, double p_hardness = 1.0, Falloff p_falloff = Falloff::LINEAR) {
	return MapShape::stroke({ p_x, p_z }, { p_x, p_z }, p_radius, p_hardness, p_falloff);
}

Brush brush_of(MapTool p_tool, double p_target, double p_strength = 1.0) {
	Brush brush;
	brush.tool = p_tool;
	brush.target = p_target;
	brush.strength = p_strength;
	return brush;
}

} // namespace

TEST_CASE("map_shape: distances to a disc, a stroke and a square are those of geometry") {
	CHECK(disc(1.0, 2.0, 3.0).get_distance({ 1.0, 7.0 }) == doctest::Approx(2.0));
	CHECK(disc(1.0, 2.0, 3.0).get_distance({ 1.0, 2.0 }) == doctest::Approx(-3.0));
	const MapShape stroke = MapShape::stroke({ -2.0, 0.0 }, { 2.0, 0.0 }, 1.0, 1.0, Falloff::LINEAR);
	CHECK(stroke.get_distance({ 0.5, 3.0 }) == doctest::Approx(2.0));
	CHECK(stroke.get_distance({ 5.0, 4.0 }) == doctest::Approx(4.0));
	const Eigen::Vector2d corners[] = { { 1, 1 }, { -1, -1 }, { 1, -1 }, { -1, 1 }, { 0, 0 }, { 0.5, 0.5 }, { 1, 0 } };
	const MapShape square(corners, 0.0);
	CHECK(square.get_distance({ 0.0, 0.25 }) == doctest::Approx(-0.75));
	CHECK(square.get_distance({ 4.0, 5.0 }) == doctest::Approx(5.0));
	CHECK(square.get_weight({ 0.999, 0.999 }) == 1.0);
	CHECK(square.get_weight({ 1.001, 0.0 }) == 0.0);
}

TEST_CASE("map_shape: the border fades from the hard core outwards, as its falloff says") {
	for (const auto &[falloff, half] : { std::pair(Falloff::LINEAR, 0.5), std::pair(Falloff::SMOOTH, 0.5),
				 std::pair(Falloff::SPHERE, std::sqrt(0.75)), std::pair(Falloff::SHARP, 0.25) }) {
		const MapShape shape = disc(0.0, 0.0, 4.0, 0.5, falloff);
		CHECK(shape.get_weight({ 1.99, 0.0 }) == 1.0);
		CHECK(shape.get_weight({ 0.0, 3.0 }) == doctest::Approx(half));
		CHECK(shape.get_weight({ 4.0, 0.0 }) == doctest::Approx(0.0));
		CHECK(shape.get_weight({ 4.01, 0.0 }) == 0.0);
	}
}

TEST_CASE("map_shape: broken numbers make a shape that is nowhere") {
	const Eigen::Vector2d bad[] = { { NAN_VALUE, 0.0 } }, far[] = { { 0.0, 0.0 }, { 1e9, 0.0 } }, good[] = { { 0.0, 0.0 } };
	for (const MapShape &shape : { MapShape(), MapShape(bad, 1.0), MapShape(far, 1.0), MapShape(good, -1.0), MapShape(good, NAN_VALUE),
				 MapShape(good, 1.0, NAN_VALUE), MapShape(std::span<const Eigen::Vector2d>(), 1.0) }) {
		CHECK(shape.is_empty());
		CHECK(shape.get_weight({ 0.0, 0.0 }) == 0.0);
		PaintMap map;
		CHECK(apply_brush(map, shape, brush_of(MapTool::PAINT, 1.0)).changed.empty());
		CHECK(map.is_empty());
	}
}

TEST_CASE("brush: a hard disc paints its area, a stroke its own, and nothing outside") {
	PaintMap map;
	const BrushResult result = apply_brush(map, disc(3.0, -7.0, 10.0), brush_of(MapTool::PAINT, 1.0));
	CHECK(result.amount == doctest::Approx(PI * 100.0).epsilon(0.01)); // the circle runs through 0.5 m texels
	CHECK(result.changed == std::vector<MapKey>{ { -1, -1 }, { -1, 0 }, { 0, -1 }, { 0, 0 } });
	CHECK(map.sample(MAP_DENSITY, 0, { 3.0, -7.0 }) == 1.0);
	CHECK(map.sample(MAP_DENSITY, 0, { 3.0, 4.0 }) == 0.0);
	const BrushResult stroke =
			apply_brush(map, MapShape::stroke({ 100, 100 }, { 140, 100 }, 5.0, 1.0, Falloff::LINEAR), brush_of(MapTool::PAINT, 1.0));
	CHECK(stroke.amount == doctest::Approx(400.0 + PI * 25.0).epsilon(0.01));
}

TEST_CASE("brush: a soft disc paints the volume of a cone") {
	PaintMap map;
	const BrushResult result = apply_brush(map, disc(0.0, 0.0, 12.0, 0.0), brush_of(MapTool::PAINT, 1.0));
	CHECK(result.amount == doctest::Approx(PI * 144.0 / 3.0).epsilon(0.01));
}

TEST_CASE("brush: a step goes its share of the way, and any brush arrives") {
	PaintMap map;
	const MapShape shape = disc(0.0, 0.0, 2.0);
	apply_brush(map, shape, brush_of(MapTool::DENSITY, 1.0, 0.5));
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 0) == 128);
	apply_brush(map, shape, brush_of(MapTool::DENSITY, 0.0, 0.25));
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 0) == 96);
	for (int step = 0; step < 1000; step++) {
		apply_brush(map, shape, brush_of(MapTool::DENSITY, 0.8, 0.01));
	}
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 0) == 204);
	for (int step = 0; step < 1000; step++) {
		apply_brush(map, shape, brush_of(MapTool::ERASE, 1.0, 0.01));
	}
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 0) == 0);
	map.compact();
	CHECK(map.find({ 0, 0 })->channels[MAP_DENSITY] == nullptr);
	CHECK(map.find({ 0, 0 })->channels[MAP_PAINT] != nullptr); // erased by hand: no rule fills it
}

TEST_CASE("brush: paint never lowers, strengths beyond 0 to 1 count as the nearest, NaN does nothing") {
	PaintMap map;
	apply_brush(map, disc(0, 0, 2), brush_of(MapTool::PAINT, 0.9, 50.0));
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 0) == 230);
	CHECK(apply_brush(map, disc(0, 0, 2), brush_of(MapTool::PAINT, 0.3)).changed.empty());
	CHECK(apply_brush(map, disc(0, 0, 2), brush_of(MapTool::ERASE, 0.0, -1.0)).changed.empty());
	CHECK(apply_brush(map, disc(0, 0, 2), brush_of(MapTool::ERASE, 0.0, NAN_VALUE)).changed.empty());
}

TEST_CASE("brush: smoothing keeps a ramp, and spreads a peak over its neighbours by 1 2 1") {
	PaintMap map;
	for (int j = -20; j < 20; j++) {
		for (int i = -20; i < 20; i++) {
			map.set_code(MAP_HEIGHT, 0, i, j, 100 + 2 * i + j);
		}
	}
	Brush smooth = brush_of(MapTool::SMOOTH, 0.0);
	smooth.channel = MAP_HEIGHT;
	CHECK(apply_brush(map, disc(0, 0, 10), smooth).changed.empty());
	smooth.channel = MAP_DENSITY;
	map.set_code(MAP_DENSITY, 0, 0, 0, 160);
	apply_brush(map, disc(0, 0, 3), smooth);
	CHECK(map.get_code(MAP_DENSITY, 0, 0, 0) == 40);
	CHECK(map.get_code(MAP_DENSITY, 0, -1, 0) == 20);
	CHECK(map.get_code(MAP_DENSITY, 0, 1, 1) == 10);
	CHECK(map.get_code(MAP_DENSITY, 0, 2, 0) == 0);
}

TEST_CASE("brush: species keep their borders sharp, mixed by the weight; another pass changes nothing") {
	PaintMap map;
	apply_brush(map, disc(0, 0, 40), brush_of(MapTool::SPECIES, 3.0, 0.25));
	int planted = 0, all = 0;
	for (int j = -25; j < 25; j++) {
		for (int i = -25; i < 25; i++) {
			const int32_t code = map.get_code(MAP_SPECIES, 0, i, j);
			CHECK((code == 0 || code == 3));
			planted += code == 3;
			all++;
		}
	}
	CHECK(double(planted) / all == doctest::Approx(0.25).epsilon(0.1));
	CHECK(apply_brush(map, disc(0, 0, 40), brush_of(MapTool::SPECIES, 3.0, 0.25)).changed.empty());
}

TEST_CASE("brush: a tint has its colour from the first touch on, however weak") {
	PaintMap map;
	Brush tint = brush_of(MapTool::TINT, 1.0, 0.2);
	tint.color = { 1.0, 0.0, 0.4 };
	apply_brush(map, disc(0, 0, 3), tint);
	CHECK(map.get_code(MAP_TINT, 0, 0, 0) == 255);
	CHECK(map.get_code(MAP_TINT, 1, 0, 0) == 0);
	CHECK(map.get_code(MAP_TINT, 2, 0, 0) == 102);
	CHECK(map.get_code(MAP_TINT, 3, 0, 0) == 51);
}

TEST_CASE("brush: combing leans along the stroke, whatever its length") {
	PaintMap map;
	Brush comb = brush_of(MapTool::COMB, 0.5);
	comb.direction = { 30.0, -40.0 };
	apply_brush(map, disc(0, 0, 3), comb);
	CHECK(map.sample(MAP_LEAN, 0, { 0, 0 }) == doctest::Approx(0.3).epsilon(0.02));
	CHECK(map.sample(MAP_LEAN, 1, { 0, 0 }) == doctest::Approx(-0.4).epsilon(0.02));
	comb.direction = { 0.0, 0.0 }; // no way known: back upright
	apply_brush(map, disc(0, 0, 3), comb);
	CHECK(map.sample(MAP_LEAN, 0, { 0, 0 }) == 0.0);
}

TEST_CASE("brush: a cut only shortens, grass grows again, and wear recovers") {
	PaintMap map;
	CHECK(apply_brush(map, disc(0, 0, 4), brush_of(MapTool::CUT, 0.1)).amount ==
			doctest::Approx((0.1 - MAP_UNCUT) * PI * 16).epsilon(0.05));
	CHECK(apply_brush(map, disc(0, 0, 4), brush_of(MapTool::CUT, 0.3)).changed.empty());
	CHECK(map.sample(MAP_CUT, 0, { 0, 0 }) == doctest::Approx(0.1));
	apply_brush(map, disc(0, 0, 4), brush_of(MapTool::REGROW, 0.25));
	CHECK(map.sample(MAP_CUT, 0, { 0, 0 }) == doctest::Approx(0.35));
	apply_brush(map, disc(0, 0, 4), brush_of(MapTool::REGROW, 9.0));
	map.compact();
	CHECK(map.is_empty());
	apply_brush(map, disc(0, 0, 4), brush_of(MapTool::FLATTEN, 0.8));
	CHECK(map.sample(MAP_WEAR, 0, { 0, 0 }) == doctest::Approx(0.8));
	apply_brush(map, disc(0, 0, 4), brush_of(MapTool::RECOVER, 0.2));
	CHECK(map.sample(MAP_WEAR, 0, { 0, 0 }) == doctest::Approx(0.6));
}

TEST_CASE("brush: steps wear a place alike wherever it lies on the grid of texels, and light steps add up") {
	for (const double amount : { 0.03, 0.01, 0.001 }) {
		for (int place = 0; place < 25; place++) {
			PaintMap map;
			const double x = 10.0 + 0.1 * (place % 5), z = -7.0 + 0.1 * (place / 5);
			const MapShape boot = disc(x, z, 0.4, 0.5, Falloff::SMOOTH);
			for (int step = 0; step < 100; step++) {
				apply_brush(map, boot, brush_of(MapTool::FLATTEN, 1.0, amount));
			}
			CAPTURE(x);
			CAPTURE(z);
			CHECK(map.sample(MAP_WEAR, 0, { x, z }) == doctest::Approx(1.0 - std::pow(1.0 - amount, 100)).epsilon(0.05));
		}
	}
}

TEST_CASE("map_shape: the most weight of a square is that of its point nearest to the shape") {
	CHECK(disc(0, 0, 1.0, 0.0).get_most_weight({ 0.75, 0.0 }, 0.25) == doctest::Approx(0.5));
	CHECK(disc(0, 0, 1.0, 0.0).get_most_weight({ 0.75, 0.75 }, 0.25) == doctest::Approx(1.0 - std::sqrt(0.5)));
	CHECK(disc(0, 0, 1.0, 0.0).get_most_weight({ 0.1, -0.2 }, 0.25) == 1.0);
	CHECK(disc(0, 0, 1.0, 0.0).get_most_weight({ 1.26, 0.0 }, 0.25) == 0.0);
	const MapShape stroke = MapShape::stroke({ -2.0, -2.0 }, { 2.0, 2.0 }, 1.0, 0.0, Falloff::LINEAR);
	CHECK(stroke.get_most_weight({ 1.0, -1.0 }, 0.5) == doctest::Approx(1.0 - std::sqrt(0.5)));
	CHECK(stroke.get_most_weight({ 2.75, 2.0 }, 0.25) == doctest::Approx(0.5));
}

TEST_CASE("brush: limits of slope and height leave the rest alone") {
	PaintMap map;
	const double steep = std::sin(40.0 * PI / 180.0);
	for (int j = -10; j < 10; j++) {
		for (int i = -10; i < 10; i++) {
			map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(j + 0.5));
			map.set_code(MAP_NORMAL, 0, i, j, info_of(MAP_NORMAL).code(i < 0 ? 0.0 : steep));
		}
	}
	Brush brush = brush_of(MapTool::PAINT, 1.0);
	brush.limits.slope_max = 35.0;
	// Half of the disc, and of the blended slope the texels with centres at x = 0.25 m.
	CHECK(apply_brush(map, disc(0, 0, 6), brush).amount == doctest::Approx(PI * 36 / 2 + 12 * 0.5).epsilon(0.03));
	CHECK(map.sample(MAP_DENSITY, 0, { -2.0, 0.0 }) == 1.0);
	CHECK(map.sample(MAP_DENSITY, 0, { 2.0, 0.0 }) == 0.0);
	brush.limits = { 35.0, 45.0, 2.0, 16384.0 };
	apply_brush(map, disc(0, 0, 6), brush);
	CHECK(map.sample(MAP_DENSITY, 0, { 2.0, -2.0 }) == 0.0);
	CHECK(map.sample(MAP_DENSITY, 0, { 2.0, 4.0 }) == 1.0);
}

TEST_CASE("brush: what lies out of the map's reach is told, and the rest painted") {
	PaintMap map;
	const double edge = PaintMap::REACH * MAP_CHUNK_SIZE;
	const BrushResult result = apply_brush(map, disc(edge, 0, 4), brush_of(MapTool::PAINT, 1.0));
	CHECK(result.out_of_room);
	CHECK(result.amount == doctest::Approx(PI * 16 / 2).epsilon(0.05));
	CHECK(apply_brush(map, disc(1e7, 0, 4), brush_of(MapTool::PAINT, 1.0)).out_of_room);
	CHECK_FALSE(apply_brush(map, disc(0, 0, 4), brush_of(MapTool::PAINT, 1.0)).out_of_room);
}

TEST_CASE("brush: every chunk that changed is named, and no other") {
	PaintMap map;
	const PaintMap before = map;
	const BrushResult result =
			apply_brush(map, MapShape::stroke({ -200, 5 }, { 150, 90 }, 6, 0.3, Falloff::SMOOTH), brush_of(MapTool::PAINT, 1.0));
	CHECK(result.changed == map.compare(before));
}
