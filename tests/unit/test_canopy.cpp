// SPDX-License-Identifier: MIT
// How much of a view grass hides, against the blades that stand there.
#include "core/field/canopy.h"

#include "grown_tile.h"

#include "core/lod/lod.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace grass;
using namespace grass::test;

namespace {

FieldSetup canopy_setup() {
	FieldSetup setup;
	setup.grid = TileGrid::make(16.0, 16.0, 256.0);
	setup.patch = shared_patch();
	setup.clump = { 1.6f, 0.0f, 0.0f, 0.0f }; // all clumps alike
	return setup;
}

struct CanopyScene {
	FieldSetup setup = canopy_setup();
	Field field;

	CanopyScene() { field.set(setup, field.bounds_of(setup), nullptr, {}, FieldParams()); }
	double hidden(const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_to) const {
		return hidden_share(
				field, [](const Eigen::Vector2f &) { return nullptr; }, p_from, p_to);
	}
	// Returns the optical depth of all blades along a line through all of their height, for each metre of the line's way over the ground
	// times a metre across it: what their segments, turned to all sides, show to the line. From the blades themselves.
	double shown_area(const Eigen::Vector3d &p_line) const {
		double area = 0.0;
		constexpr int TILES = 8;
		for (int tile = 0; tile < TILES; tile++) {
			for (int blade = 0; blade < GRASS_BLADES_PER_TILE; blade++) {
				const auto knots = field.find_knots(number_of(setup.grid.get_index(3 + tile, 5), blade), {});
				for (int k = 1; k < GRASS_KNOTS; k++) {
					const Eigen::Vector3d segment = knots[size_t(k)] - knots[size_t(k - 1)];
					area += segment.cross(p_line).norm();
				}
			}
		}
		const double size = setup.grid.get_tile_size();
		return 2.0 / std::numbers::pi * GRASS_LOD_FULLNESS * setup.patch->mean_width * area / (TILES * size * size);
	}
};

double depth_of(double p_hidden) {
	return -std::log(1.0 - p_hidden);
}

} // namespace

TEST_CASE("canopy: grass hides what its blades hide, looked through from the side, aslant and from above [Eq V1]") {
	const CanopyScene scene;
	const Canopy canopy = canopy_at(scene.field, { 0.3f, 0.2f }, nullptr);
	CHECK(canopy.height == doctest::Approx(scene.setup.patch->mean_height));
	CHECK(canopy.blades == doctest::Approx(256.0));
	for (const Eigen::Vector3d &line : { Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 1, 0).normalized(),
				 Eigen::Vector3d(0.3, -1, 0.2).normalized(), Eigen::Vector3d(0, 1, 0) }) {
		CHECK(canopy_density(canopy, line) * canopy.height == doctest::Approx(scene.shown_area(line)).epsilon(0.12));
	}
}

TEST_CASE("canopy: blades that lean to all sides hide some of each view, those that are all upright nothing from above [Eq V1]") {
	constexpr double HEIGHT = 0.5, BLADES = 200.0, AREA = 0.002;
	const auto across = [&](const Eigen::Vector3d &p_along, const Eigen::Vector3d &p_line) { // the mean sine between blades and the line
		const Canopy canopy{ 0.0, HEIGHT, BLADES, AREA, p_along };
		return canopy_density(canopy, p_line) * HEIGHT / (2.0 / std::numbers::pi * BLADES * AREA);
	};
	const Eigen::Vector3d up(0, 1, 0), side(1, 0, 0);
	CHECK(across(up, up) == doctest::Approx(0.0));
	CHECK(across(up, side) == doctest::Approx(1.0));
	CHECK(across({ 0, 0, 0 }, up) == doctest::Approx(std::sqrt(2.0 / 3.0))); // of directions that are all alike
	CHECK(across({ 0, 0, 0 }, side) == doctest::Approx(std::sqrt(2.0 / 3.0)));
	CHECK(across({ 0, 0.5, 0 }, up) == doctest::Approx(std::sqrt(0.5)));
}

TEST_CASE("canopy: hidden is what the line's way through the grass makes it, in any direction [Eq V2]") {
	const CanopyScene scene;
	const Canopy canopy = canopy_at(scene.field, { 0.0f, 0.0f }, nullptr);
	const double side = canopy_density(canopy, { 1, 0, 0 }), low = 0.5 * canopy.height;
	CHECK(depth_of(scene.hidden({ -2, low, 0 }, { -1, low, 0 })) == doctest::Approx(side));
	CHECK(depth_of(scene.hidden({ 1, low, 1 }, { -2, low, 1 })) == doctest::Approx(3.0 * side));
	CHECK(scene.hidden({ -2, low, 0 }, { 2, low, 0 }) == doctest::Approx(scene.hidden({ 2, low, 0 }, { -2, low, 0 })));
	CHECK(depth_of(scene.hidden({ 0, 5, 0 }, { 0, -1, 0 })) == doctest::Approx(canopy.height * canopy_density(canopy, { 0, 1, 0 })));
	CHECK(depth_of(scene.hidden({ -100, low, 0 }, { 100, low, 0 })) == doctest::Approx(16.0 * side).epsilon(0.02)); // 16 m of grass
	CHECK(scene.hidden({ -2, canopy.height + 0.01, 0 }, { 2, canopy.height + 0.01, 0 }) == 0.0);
	CHECK(scene.hidden({ -2, -0.1, 0 }, { 2, -0.1, 0 }) == 0.0);
	CHECK(scene.hidden({ 1, low, 1 }, { 1, low, 1 }) == 0.0);
	const double whole = scene.hidden({ -6, 1.7, 0 }, { 4, 0.2, 0 }); // eyes look at a lying body, ...
	CHECK(whole > scene.hidden({ -6, 1.7, 0 }, { 4, 0.3, 0 })); // a crouching one
	CHECK(scene.hidden({ -6, 1.7, 0 }, { 4, 1.2, 0 }) == 0.0); // and a standing one
	CHECK(whole < 1.0);
}

TEST_CASE("canopy: the sun reaches tips, less of what is below, and the less the lower it is [Eq B8]") {
	const float cover = 0.9f, shade = 0.8f;
	float before_sun = 0.0f;
	for (const float sine : { 0.1f, 0.3f, 0.7f, 1.0f }) {
		const float path = glsl::grass_sun_path(sine);
		CHECK(glsl::grass_sun_open(glsl::grass_cover_above(cover, 0.0f), path, shade) == 1.0f);
		float before = 1.0f;
		for (const float depth : { 0.3f, 0.6f, 1.0f }) {
			const float open = glsl::grass_sun_open(glsl::grass_cover_above(cover, depth), path, shade);
			CHECK(open < before);
			before = open;
		}
		CHECK(before > before_sun);
		CHECK(before > float(GRASS_CANOPY_SCATTER));
		before_sun = before;
		CHECK(glsl::grass_sun_open(cover, path, 0.0f) == 1.0f);
	}
}

TEST_CASE("canopy: shadow maps of dense grass and of a low sun leave light for contrast [Eq B9]") {
	for (const float cover : { 0.05f, 0.9f, 6.0f }) {
		for (const float sine : { -0.2f, 0.05f, 0.5f, 1.0f }) {
			const float path = glsl::grass_sun_path(sine), width = glsl::grass_shadow_width(cover, path);
			CHECK(width <= 1.0f);
			CHECK(double(glsl::grass_shadow_open(cover, path, width)) > std::exp(-double(GRASS_SHADOW_MEETS)) - 1e-6);
			CHECK((width == 1.0f || path * cover > float(GRASS_SHADOW_MEETS)));
		}
	}
	CHECK(glsl::grass_shadow_open(0.0f, 2.0f, 1.0f) == 1.0f);
}

TEST_CASE("canopy: a blade that stands for others casts a thin shadow where it is seen alone, a wide one in dense grass [Eq B9]") {
	for (const float stands_for : { 0.5f, 1.0f, 3.0f, 20.0f }) {
		const auto width = [&](float p_cover) { return std::max(stands_for, 1.0f) * glsl::grass_shadow_casts(stands_for, p_cover); };
		CHECK(width(0.05f) == doctest::Approx(std::min(std::max(stands_for, 1.0f), float(GRASS_SHADOW_WIDEST_ALONE))));
		CHECK(width(0.9f) >= width(0.05f));
		CHECK(width(6.0f) == doctest::Approx(std::min(std::max(stands_for, 1.0f), float(GRASS_SHADOW_WIDEST))));
	}
}
