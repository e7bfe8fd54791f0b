// SPDX-License-Identifier: MIT
// What the editor's brush rests on: even steps, held keys, the ring.
#include "core/paint/brush_keys.h"
#include "core/paint/brush_params.h"
#include "core/paint/brush_ring.h"
#include "core/paint/stroke_path.h"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>

using namespace grass;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr Tunable RADIUS = BRUSH_PARAMS[BRUSH_RADIUS], STRENGTH = BRUSH_PARAMS[BRUSH_STRENGTH];

std::vector<StrokeStep> drawn(const std::vector<Vector2d> &p_places, double p_radius) {
	StrokePath path;
	std::vector<StrokeStep> steps{ path.begin(p_places[0]) };
	for (size_t i = 1; i < p_places.size(); i++) {
		for (const StrokeStep &step : path.move(p_places[i], StrokePath::SPACING * p_radius)) {
			steps.push_back(step);
		}
	}
	return steps;
}

Brush brush_of(MapTool p_tool, double p_target = 0.5) {
	Brush brush;
	brush.tool = p_tool;
	brush.target = p_target;
	return brush;
}

// Returns the channel's first component in the middle of a brush that was applied often.
double painted(PaintMap &r_map, const Brush &p_brush, int p_times = 40) {
	const Vector2d place(10.0, 10.0);
	for (int i = 0; i < p_times; i++) {
		apply_brush(r_map, MapShape::stroke(place, place, 4.0, 0.9, Falloff::SMOOTH), p_brush);
	}
	return r_map.sample(channel_of(p_brush), 0, place);
}

} // namespace

TEST_CASE("stroke: steps are even and join, however the cursor came") {
	const std::vector<StrokeStep> once = drawn({ { 0, 0 }, { 10, 0 } }, 2.0);
	std::vector<Vector2d> many{ { 0, 0 } };
	for (int i = 1; i <= 300; i++) {
		many.push_back({ i / 30.0, 0.0 });
	}
	const std::vector<StrokeStep> slowly = drawn(many, 2.0);
	REQUIRE(once.size() == 21); // the first touch, and one each half metre
	REQUIRE(slowly.size() >= 20);
	REQUIRE(slowly.size() <= 21);
	CHECK(once[0].from == once[0].to);
	for (size_t i = 1; i < slowly.size(); i++) {
		CHECK((slowly[i].from - slowly[i - 1].to).norm() < 1e-12);
		CHECK((once[i].from - once[i - 1].to).norm() < 1e-12);
		CHECK((once[i].to - once[i].from).norm() == doctest::Approx(0.5));
		CHECK((slowly[i].to - slowly[i].from).norm() == doctest::Approx(0.5).epsilon(0.07)); // waits for the next event
	}
}

TEST_CASE("stroke: less than a step waits for the next move") {
	StrokePath path;
	path.begin({ 1, 1 });
	CHECK(path.move({ 1.2, 1 }, StrokePath::SPACING).empty());
	CHECK(path.move({ 1.1, 1 }, StrokePath::SPACING).empty());
	CHECK(path.move({ 1.3, 1 }, StrokePath::SPACING).size() == 1);
}

TEST_CASE("stroke: a leap makes long steps, not endlessly many") {
	StrokePath path;
	path.begin({ 0, 0 });
	const std::vector<StrokeStep> steps = path.move({ 0, 5000 }, StrokePath::SPACING * 0.1);
	REQUIRE(steps.size() == size_t(StrokePath::MAX_STEPS));
	CHECK((steps.back().to - Vector2d(0, 5000)).norm() < 1e-6);
}

TEST_CASE("stroke: what is nowhere makes no step and does not spread") {
	StrokePath path;
	path.begin({ 0, 0 });
	CHECK(path.move({ std::nan(""), 0 }, StrokePath::SPACING).empty());
	CHECK(path.move({ std::numeric_limits<double>::infinity(), 0 }, StrokePath::SPACING).empty());
	CHECK(path.move({ 1, 0 }, std::nan("")).empty());
	CHECK(path.move({ 1, 0 }, 0.0).empty());
	CHECK(path.move({ 0, 0 }, StrokePath::SPACING).empty());
	CHECK(path.move({ 1, 0 }, StrokePath::SPACING).size() == 4);
}

TEST_CASE("brush keys: the opposite of each tool takes back what the tool did") {
	for (const MapTool tool : { MapTool::PAINT, MapTool::DENSITY, MapTool::HEIGHT, MapTool::SPECIES, MapTool::TINT, MapTool::COMB,
				 MapTool::CUT, MapTool::FLATTEN }) {
		INFO("tool ", int(tool));
		PaintMap map;
		Brush brush = brush_of(tool, tool == MapTool::SPECIES ? 3.0 : 0.5);
		brush.direction = { 1.0, 0.0 };
		brush.color = { 1.0, 0.0, 0.0 };
		const int component = tool == MapTool::TINT ? 3 : 0; // how much of the tint shows
		const double before = map.sample(channel_of(brush), component, { 10, 10 });
		painted(map, brush);
		CHECK(map.sample(channel_of(brush), component, { 10, 10 }) != before);
		painted(map, opposite_of(brush));
		CHECK(map.sample(channel_of(brush), component, { 10, 10 }) == before);
	}
	CHECK(opposite_of(brush_of(MapTool::ERASE)).tool == MapTool::PAINT);
	CHECK(opposite_of(brush_of(MapTool::SMOOTH)).tool == MapTool::SMOOTH);
	CHECK(opposite_of(opposite_of(brush_of(MapTool::CUT))).tool == MapTool::CUT);
}

TEST_CASE("brush keys: smoothing works on what the tool paints") {
	for (const MapTool tool : { MapTool::PAINT, MapTool::ERASE, MapTool::HEIGHT, MapTool::TINT, MapTool::COMB, MapTool::CUT }) {
		const Brush smooth = smoothing_of(brush_of(tool));
		CHECK(smooth.tool == MapTool::SMOOTH);
		CHECK(channel_of(smooth) == channel_of(brush_of(tool)));
	}
	CHECK(smoothing_of(brush_of(MapTool::SPECIES)).tool == MapTool::SPECIES);
}

TEST_CASE("brush keys: a notch is felt everywhere and leads back") {
	double radius = RADIUS.minimum;
	int notches = 0;
	for (; radius < RADIUS.maximum && notches < 100; notches++) {
		const double next = nudged(RADIUS, radius, 1);
		CHECK(next > radius);
		CHECK(next <= std::max(1.2 * radius, radius + 1.001 * RADIUS.step));
		radius = next;
	}
	CHECK(notches < 60); // from end to end by hand
	CHECK(nudged(RADIUS, radius, 1) == RADIUS.maximum);
	for (; radius > RADIUS.minimum; notches--) {
		const double next = nudged(RADIUS, radius, -1);
		REQUIRE(next < radius);
		radius = next;
	}
	CHECK(nudged(RADIUS, radius, -1) == RADIUS.minimum);
	CHECK(nudged(STRENGTH, 0.5, 1) == doctest::Approx(0.55));
	CHECK(nudged(STRENGTH, 0.98, 1) == 1.0);
	CHECK(nudged(STRENGTH, std::nan(""), -1) == doctest::Approx(STRENGTH.initial - 0.05));
}

TEST_CASE("ring: places lie on the circle, evenly") {
	const std::vector<Vector2d> places = circle_places({ 3, -2 }, 5.0, 48);
	REQUIRE(places.size() == 48);
	for (size_t i = 0; i < places.size(); i++) {
		CHECK((places[i] - Vector2d(3, -2)).norm() == doctest::Approx(5.0));
		CHECK((places[(i + 1) % 48] - places[i]).norm() == doctest::Approx(10.0 * std::sin(std::numbers::pi / 48)));
	}
}

TEST_CASE("ring: the disc's triangles cover it once") {
	const std::vector<Vector2d> places = disc_places({ 3, -2 }, 5.0, 4, 32);
	REQUIRE(places.size() == 1 + 4 * 32);
	const std::vector<int> triangles = disc_triangles(4, 32);
	double area = 0.0;
	for (size_t i = 0; i < triangles.size(); i += 3) {
		const Vector2d a = places[size_t(triangles[i])], b = places[size_t(triangles[i + 1])], c = places[size_t(triangles[i + 2])];
		const double twice = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
		CHECK(twice > 0.0); // all the same way round
		area += 0.5 * twice;
	}
	CHECK(area == doctest::Approx(0.5 * 32 * 25.0 * std::sin(2.0 * std::numbers::pi / 32))); // of the polygon
}

TEST_CASE("ring: the band is as wide as asked, seen from the eye") {
	std::vector<Vector3d> loop;
	for (const Vector2d &place : circle_places({ 0, 0 }, 2.0, 64)) {
		loop.push_back({ place.x(), 0.3 * place.x(), place.y() });
	}
	const Vector3d eye(4, 10, -7);
	const std::vector<Vector3d> band = ring_band(loop, eye, 0.004);
	REQUIRE(band.size() == 6 * loop.size());
	for (size_t i = 0; i < loop.size(); i++) {
		const Vector3d one = (band[6 * i] - eye).normalized(), other = (band[6 * i + 1] - eye).normalized();
		CHECK((one - other).norm() == doctest::Approx(0.004).epsilon(0.001));
		CHECK((0.5 * (band[6 * i] + band[6 * i + 1]) - loop[i]).norm() < 1e-12);
	}
}

TEST_CASE("ring: what has no direction has no width, and nothing is NaN") {
	const std::vector<Vector3d> still(8, Vector3d(1, 2, 3));
	for (const Vector3d &vertex : ring_band(still, { 1, 2, 3 }, 0.01)) {
		CHECK(vertex == Vector3d(1, 2, 3));
	}
	CHECK(ring_band({}, { 0, 0, 0 }, 0.01).empty());
}
