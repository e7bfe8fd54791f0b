// SPDX-License-Identifier: MIT
#include "core/map/map_shape.h"
#include "core/paint/brush.h"

#include <doctest/doctest.h>

#include <limits>
#include <memory>
#include <numbers>

using namespace grass;

namespace {

// Full in the right half, nothing in the left one.
std::shared_ptr<const MapStamp> right_half() {
	std::vector<float> weights(64 * 64);
	for (size_t i = 0; i < weights.size(); i++) {
		weights[i] = i % 64 < 32 ? 0.0f : 1.0f;
	}
	return std::make_shared<const MapStamp>(64, 64, weights);
}

} // namespace

TEST_CASE("map_stamp: texels have their own weight in their middle, what is between them is between, and outside is nothing") {
	const MapStamp stamp(2, 2, { 0.0f, 1.0f, 0.5f, 0.25f });
	CHECK(stamp.get_weight({ 0.25, 0.25 }) == 0.0);
	CHECK(stamp.get_weight({ 0.75, 0.25 }) == 1.0);
	CHECK(stamp.get_weight({ 0.25, 0.75 }) == 0.5);
	CHECK(stamp.get_weight({ 0.5, 0.25 }) == doctest::Approx(0.5));
	CHECK(stamp.get_weight({ 0.5, 0.5 }) == doctest::Approx(0.4375));
	CHECK(stamp.get_weight({ 1.0, 0.0 }) == 1.0);
	CHECK(stamp.get_weight({ 1.01, 0.5 }) == 0.0);
	CHECK(stamp.get_weight({ std::numeric_limits<double>::quiet_NaN(), 0.5 }) == 0.0);
}

TEST_CASE("map_stamp: weights beyond 0..1 are clamped, and what does not fit its size is nowhere") {
	const MapStamp wild(3, 1, { -1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() });
	CHECK(wild.get_weight({ 0.1, 0.5 }) == 0.0);
	CHECK(wild.get_weight({ 0.5, 0.5 }) == 0.0);
	CHECK(wild.get_weight({ 0.9, 0.5 }) == 1.0);
	CHECK(MapStamp(2, 2, { 1.0f }).is_empty());
	CHECK(MapStamp(0, 0, {}).is_empty());
	CHECK(MapStamp(MapStamp::MOST + 1, 1, std::vector<float>(MapStamp::MOST + 1, 1.0f)).is_empty());
	CHECK(MapStamp(2, 2, { 1.0f }).get_weight({ 0.5, 0.5 }) == 0.0);
}

TEST_CASE("map_shape: a stamp fills a square around its middle, and turns with it") {
	const MapShape shape = MapShape::stamped({ 10.0, 20.0 }, 2.0, 0.0, right_half());
	CHECK(shape.get_min().isApprox(Eigen::Vector2d(8.0, 18.0)));
	CHECK(shape.get_max().isApprox(Eigen::Vector2d(12.0, 22.0)));
	CHECK(shape.get_weight({ 11.0, 20.0 }) == 1.0);
	CHECK(shape.get_weight({ 9.0, 20.0 }) == 0.0);
	CHECK(shape.get_weight({ 11.9, 21.9 }) == 1.0); // the corner, which a disc has not
	CHECK(shape.get_weight({ 12.1, 20.0 }) == 0.0);
	const MapShape turned = MapShape::stamped({ 10.0, 20.0 }, 2.0, 0.5 * std::numbers::pi, right_half());
	CHECK(turned.get_weight({ 10.0, 21.0 }) == 1.0); // from x towards z
	CHECK(turned.get_weight({ 10.0, 19.0 }) == 0.0);
	CHECK(MapShape::stamped({ 0.0, 0.0 }, 2.0, std::numeric_limits<double>::quiet_NaN(), right_half()).is_empty());
	CHECK(MapShape::stamped({ 0.0, 0.0 }, 0.0, 0.0, right_half()).is_empty());
}

TEST_CASE("brush: a stamp paints what it shows, in the strength of the brush") {
	PaintMap map;
	Brush brush;
	brush.tool = MapTool::DENSITY;
	brush.target = 1.0;
	brush.strength = 0.5;
	const BrushResult result = apply_brush(map, MapShape::stamped({ 0.0, 0.0 }, 4.0, 0.0, right_half()), brush);
	CHECK(map.sample(MAP_DENSITY, 0, { 2.0, 0.0 }) == doctest::Approx(0.5).epsilon(0.01));
	CHECK(map.sample(MAP_DENSITY, 0, { -2.0, 0.0 }) == 0.0);
	CHECK(result.amount == doctest::Approx(0.5 * 4.0 * 8.0).epsilon(0.05)); // square metres of full grass
}
