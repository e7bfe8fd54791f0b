// SPDX-License-Identifier: MIT
// The map under a field: what grows by it, which tiles are bare, which ones wake.
#include "hill_map.h"

#include "core/blades/blade.h"
#include "core/map/map_layers.h"
#include "core/tiles/tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

using namespace grass;
using namespace grass::test;

TEST_CASE("growth: wear presses the grass and thins it out until it is gone [Eq M1]") {
	PaintMap map;
	map.set_base_density(1.0);
	for (const double wear : { 0.2, 0.6, 1.0 }) {
		paint(map, MapTool::FLATTEN, wear, disc(0.0, 0.0, 5.0));
		MapLayers layers({ HILL_GRID });
		layers.update(map, layers.get_region());
		CHECK(layers.sample({ 0.0f, 0.0f }).density == doctest::Approx(1.0 - wear * wear).epsilon(0.01));
		CHECK(layers.sample({ 0.0f, 0.0f }).height == doctest::Approx(1.0 - GRASS_WEAR_PRESSES * wear).epsilon(0.01));
	}
}

TEST_CASE("growth: the share of blades that stand is the density, and nothing stands at 0 [Eq M2]") {
	for (const float density : { 0.0f, 0.25f, 0.5f, 1.0f }) {
		double standing = 0.0;
		for (int n = 0; n < 1000; n++) {
			standing += glsl::grass_presence(density, (float(n) + 0.5f) / 1000.0f) > 0.0f ? 1.0 : 0.0;
		}
		CHECK(standing / 1000.0 == doctest::Approx(std::min(1.0, density / (1.0 - GRASS_SPROUT))).epsilon(0.01));
		CHECK(glsl::grass_presence(1.0f, 0.999f) == doctest::Approx(1.0f).epsilon(0.01));
	}
}

TEST_CASE("growth: a cut leaves every blade as long as it says, and shorter ones alone [Eq M3]") {
	Growth here = glsl::grass_unpainted(1.0f);
	here.cut = 0.2f;
	CHECK(glsl::grass_grown(NO_CLUMP, here, 0.5f).height * 0.5f == doctest::Approx(0.2));
	CHECK(glsl::grass_grown(NO_CLUMP, here, 2.0f).height * 2.0f == doctest::Approx(0.2));
	CHECK(glsl::grass_grown(NO_CLUMP, here, 0.1f).height == 1.0f);
	here.height = 0.25f;
	CHECK(glsl::grass_grown(NO_CLUMP, here, 0.5f).height == 0.25f);
	here.cut = here.height = 0.0f;
	CHECK(glsl::grass_grown(NO_CLUMP, here, 0.5f).height == float(GRASS_STUBBLE)); // a blade of no length has no direction
}

TEST_CASE("growth: blades follow their share of the slope, no farther than the bound that culling uses [Eq M4]") {
	const double slope = 30.0 * std::numbers::pi / 180.0;
	const glsl::vec2 normal(float(std::sin(slope)), 0.0f);
	const auto angle = [&](float p_follow) { return 2.0 * std::atan(double(glsl::grass_ground_tilt(normal, p_follow).x)); };
	CHECK(angle(0.0f) == 0.0);
	CHECK(angle(1.0f) == doctest::Approx(slope));
	CHECK(angle(0.5f) == doctest::Approx(0.5 * slope));
	for (const float follow : { 0.0f, 0.25f, 1.0f }) {
		Growth here = glsl::grass_unpainted(1.0f);
		here.tilt = glsl::grass_ground_tilt(glsl::vec2(0.6f, -0.6f), follow);
		const Eigen::Vector3f up = rest_knot(Eigen::Vector3f::UnitY(), 1, glsl::grass_grown(NO_CLUMP, here, 1.0f));
		CHECK((up - Eigen::Vector3f::UnitY()).norm() <= slope_lean(follow) + 1e-6f);
	}
}

TEST_CASE("tile_cover: a tile is bare where no texel says otherwise, and its ground lies within what it is told") {
	PaintMap map;
	paint(map, MapTool::PAINT, 1.0, disc(5.0, 5.0, 6.0));
	lay_slope(map);
	MapLayers layers({ HILL_GRID, tallest(), 0.0f });
	layers.update(map, layers.get_region());
	const TileCover &cover = *layers.get_cover();
	int bare = 0;
	for (int z = 0; z < 80; z++) {
		for (int x = 0; x < 80; x++) {
			const TileCover::Tile &tile = cover.get(x, z);
			bare += tile.is_bare() ? 1 : 0;
			double most = 0.0;
			for (int n = 0; n < 25; n++) {
				const Eigen::Vector3d at = HILL_GRID.get_centre(x, z) + Eigen::Vector3d((n % 5 - 2) * 0.125, 0.0, (n / 5 - 2) * 0.125);
				const Growth here = layers.sample({ float(at.x()), float(at.z()) });
				most = std::max(most, double(here.density));
				if (!tile.is_bare()) {
					CHECK(here.ground >= tile.low - 1e-4f);
					CHECK(here.ground <= tile.high + 1e-4f);
				}
			}
			CHECK(tile.is_bare() == (most == 0.0));
		}
	}
	const TileCover::Tile &inside = cover.get(50, 50);
	CHECK(inside.grown == doctest::Approx(1.0).epsilon(0.01));
	CHECK(inside.cut > tallest());
	CHECK(inside.slope >= 0.55f);
	CHECK(inside.slope <= 0.8f);
	CHECK(bare == cover.get_bare_count());
	CHECK(double(6400 - bare) * 0.25 == doctest::Approx(std::numbers::pi * 36.0).epsilon(0.2)); // and the tiles on the border
	const BrushResult erased = paint(map, MapTool::ERASE, 0.0, disc(5.0, 5.0, 9.0));
	layers.update(map, { erased.min, erased.max });
	CHECK(cover.get_bare_count() == 6400);
	CHECK(cover.get_low() == 0.0f);
	CHECK(cover.get_high() == 0.0f);
}

TEST_CASE("map_layers: laid out chunk by chunk, with changes in between, it says what it says when laid out at once") {
	PaintMap map;
	paint(map, MapTool::PAINT, 0.6, disc(1.0, -1.0, 18.0));
	lay_slope(map);
	MapLayers layers({ HILL_GRID, tallest(), 0.25f });
	CHECK(layers.get_waiting() == 4);
	CHECK(layers.count_painted(map) == 4);
	CHECK(layers.work(map).layers == std::vector<int>{ 0 });
	CHECK_FALSE(layers.is_waiting_at({ -5.0f, -5.0f }));
	CHECK(layers.is_waiting_at({ 5.0f, 5.0f }));
	for (const double x : { -10.0, 0.5, 10.0 }) { // in a chunk that is done, at a border, in one that waits
		const BrushResult result = paint(map, MapTool::ERASE, 0.0, disc(x, -3.0, 2.0));
		layers.touch({ result.min, result.max });
	}
	CHECK(layers.is_waiting_at({ -5.0f, -5.0f }));
	CHECK_FALSE(layers.is_waiting_at({ 1e9f, 0.0f }));
	MapLayers::Changes changes;
	while (layers.get_waiting() > 0) {
		changes.add(layers.work(map));
	}
	CHECK(changes.tiles == TileRange{ 0, 80, 0, 80 });
	MapLayers fresh({ HILL_GRID, tallest(), 0.25f });
	fresh.update(map, fresh.get_region());
	for (int layer = 0; layer < 4; layer++) {
		CHECK(layers.get_layer(layer).growth == fresh.get_layer(layer).growth);
		CHECK(layers.get_layer(layer).ground == fresh.get_layer(layer).ground);
	}
	CHECK(layers.get_pages() == fresh.get_pages());
	CHECK(std::ranges::equal(layers.get_cover()->get_tiles(), fresh.get_cover()->get_tiles()));
	CHECK(layers.get_cover()->get_bare_count() == fresh.get_cover()->get_bare_count());
	CHECK(layers.work(map).tiles.count() == 0);
}

TEST_CASE("tile_bounds: bare tiles are never met, others where their ground is") {
	PaintMap map;
	map.set_base_density(1.0);
	lay_slope(map);
	paint(map, MapTool::ERASE, 0.0, disc(-10.0, 0.0, 3.0));
	MapLayers layers({ HILL_GRID, tallest(), 0.25f });
	layers.update(map, layers.get_region());
	TileBounds bounds(*shared_patch(), HILL_GRID, ClumpParams(), 0);
	bounds.set_cover(layers.get_cover(), slope_lean(0.25f) * shared_patch()->max_length);
	const auto meets = [&](double p_x, double p_y, double p_z) {
		const TilePlace place = HILL_GRID.get_place({ p_x, 0.0, p_z });
		const Eigen::Vector3d at(p_x, p_y, p_z);
		return bounds.meets(place.x, place.z, { at, at });
	};
	CHECK(meets(10.0, 5.2, 0.0));
	CHECK_FALSE(meets(10.0, 0.2, 0.0)); // below the hill
	CHECK_FALSE(meets(10.0, 8.0, 0.0));
	CHECK_FALSE(meets(-10.0, -5.0, 0.0)); // bare
	CHECK(meets(-15.0, -7.4, 0.0));
	CHECK(bounds.get_low() < -7.0);
	CHECK(bounds.get_height() > 7.0);
}

TEST_CASE("map_layers: tiles wake where bodies touch grass on a hill, and nowhere under it") {
	PaintMap map;
	map.set_base_density(1.0);
	lay_slope(map);
	MapLayers layers({ HILL_GRID, tallest(), 0.25f });
	layers.update(map, layers.get_region());
	auto bounds = std::make_shared<TileBounds>(*shared_patch(), HILL_GRID, ClumpParams(), 0);
	bounds->set_cover(layers.get_cover(), slope_lean(0.25f) * shared_patch()->max_length);
	TileManager tiles;
	tiles.set_grid(HILL_GRID);
	TileParams params;
	params.overhang = bounds->get_overhang();
	params.low = bounds->get_low();
	params.height = bounds->get_height();
	params.is_mapped = true;
	tiles.set_params(params);
	tiles.set_bounds(bounds);
	ColliderShape ball;
	ball.size.x() = 0.2;
	ball.now.position = ball.before.position = { 12.0, 6.1, 0.0 };
	tiles.update(1.0 / 60.0, { &ball, 1 });
	CHECK(tiles.get_statistics().awake > 0);
	CHECK((tiles.get_slots()[0].list.w & GRASS_SLOT_MAPPED) != 0);
	tiles.reset();
	ball.now.position.y() = ball.before.position.y() = 0.2;
	tiles.update(1.0 / 60.0, { &ball, 1 });
	CHECK(tiles.get_statistics().awake == 0);
}
