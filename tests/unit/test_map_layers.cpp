// SPDX-License-Identifier: MIT
// The map as a field shows it: layers of texels, and what they say at a place.
#include "hill_map.h"

#include "core/map/map_layers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace grass;
using namespace grass::test;

TEST_CASE("map_layers: a layer sampled by itself says what the map says, over chunk borders, too") {
	const PaintMap map = paint_varied();
	MapLayers layers({ HILL_GRID });
	CHECK(layers.update(map, layers.get_region()).layers == std::vector<int>{ 0, 1, 2, 3 });
	std::mt19937 random(1);
	std::uniform_real_distribution<float> place(-18.0f, 18.0f);
	for (int n = 0; n < 2000; n++) {
		const Eigen::Vector2f at(place(random), place(random));
		const Growth here = layers.sample(at);
		CHECK(here.density == doctest::Approx(map.sample(MAP_DENSITY, 0, at.cast<double>())).epsilon(0.001));
		CHECK(std::abs(here.height - map.sample(MAP_HEIGHT, 0, at.cast<double>())) < 0.125); // a kink of 1/m, blended at 0.5 m
		CHECK(here.ground == doctest::Approx(0.5 * at.x() + 0.25 * at.y()).epsilon(1e-4));
		CHECK(here.cut == doctest::Approx(MAP_UNCUT));
	}
	CHECK(layers.sample({ 1e9f, 0.0f }).density == 0.0f);
	CHECK(layers.sample({ std::nanf(""), 0.0f }).density == 0.0f);
}

TEST_CASE("map_layers: only what changed is put together again, and only changed layers are named") {
	PaintMap map;
	paint(map, MapTool::PAINT, 1.0, disc(0.0, 0.0, 15.0));
	MapLayers layers({ HILL_GRID });
	layers.update(map, layers.get_region());
	CHECK(layers.update(map, layers.get_region()).layers.empty());
	const BrushResult result = paint(map, MapTool::ERASE, 0.0, disc(10.0, 10.0, 1.0));
	const std::vector<int> changed = layers.update(map, { result.min, result.max }).layers;
	CHECK(changed.size() == 1);
	MapLayers fresh({ HILL_GRID });
	fresh.update(map, fresh.get_region());
	for (int layer = 0; layer < 4; layer++) {
		CHECK(fresh.get_layer(layer).growth == layers.get_layer(layer).growth);
	}
}

TEST_CASE("map_layers: a tint blends into no tint without a trace of white") {
	PaintMap map;
	Brush tint;
	tint.tool = MapTool::TINT;
	tint.color = { 1.0, 0.4, 0.0 };
	apply_brush(map, MapShape::stroke({ 0, 0 }, { 0, 0 }, 6.0, 0.2, Falloff::LINEAR), tint);
	MapLayers layers({ HILL_GRID });
	layers.update(map, layers.get_region());
	int tinted = 0, weak = 0;
	for (int layer = 0; layer < layers.get_count(); layer++) {
		const std::vector<uint8_t> &texels = layers.get_layer(layer).tint;
		for (size_t t = 0; t < texels.size(); t += 4) { // any mean of texels has the colour that each of them has
			const double strength = texels[t + 3];
			CHECK(std::abs(texels[t] - strength) <= 1.0);
			CHECK(std::abs(texels[t + 1] - 0.4 * strength) <= 1.0);
			CHECK(texels[t + 2] == 0);
			tinted += strength > 0.0 ? 1 : 0;
			weak += strength > 0.0 && strength < 128.0 ? 1 : 0;
		}
	}
	CHECK(tinted > 80);
	CHECK(weak > 20);
}

TEST_CASE("map_layers: what is read around one place is what the layers say there") {
	const PaintMap map = paint_varied();
	const MapPlace field{ HILL_GRID, tallest(), 0.25f };
	MapLayers layers(field), around;
	layers.update(map, layers.get_region());
	std::mt19937 random(1);
	std::uniform_real_distribution<float> place(-25.0f, 25.0f);
	for (int n = 0; n < 200; n++) {
		const Eigen::Vector2f at = n == 0 ? Eigen::Vector2f(0.0f, 0.0f) : Eigen::Vector2f(place(random), place(random));
		around.read(map, field, at);
		const Growth here = around.sample(at), there = layers.sample(at);
		CHECK(here.density == there.density);
		CHECK(here.height == there.height);
		CHECK(here.cut == there.cut);
		CHECK(here.lean == there.lean);
		CHECK(here.tilt == there.tilt);
		CHECK(here.slope == there.slope);
		CHECK(here.ground == there.ground);
	}
	around.read(map, field, { 1e9f, 0.0f });
	CHECK(around.get_count() == 0);
	around.read(map, field, { std::nanf(""), 0.0f });
	CHECK(around.get_count() == 0);
}

namespace {

const MapPlace PLACE{ TileGrid::make(200.0, 140.0, 256.0), 0.6, 0.5f };

PaintMap paint_rows() {
	PaintMap map;
	map.set_base_density(1.0);
	for (int i = -90; i < 90; i++) {
		map.set_code(MAP_DENSITY, 0, i, i / 2, 40);
		map.set_code(MAP_CUT, 0, i, 7, 12);
		map.set_code(MAP_GROUND, 0, i, 3, 2048);
	}
	return map;
}

MapLayers lay_out(const PaintMap &p_map) {
	MapLayers layers(PLACE);
	layers.update(p_map, layers.get_region());
	return layers;
}

void work_off(MapLayers &r_layers, const PaintMap &p_map) {
	while (r_layers.get_waiting() > 0) {
		r_layers.work(p_map);
	}
}

void check_same(const MapLayers &p_one, const MapLayers &p_other) {
	CHECK(std::ranges::equal(p_one.get_cover()->get_tiles(), p_other.get_cover()->get_tiles()));
	REQUIRE(p_one.get_pages() == p_other.get_pages());
	for (int layer = 0; layer < p_one.get_count(); layer++) {
		CHECK(p_one.get_layer(layer).growth == p_other.get_layer(layer).growth);
		CHECK(p_one.get_layer(layer).ground == p_other.get_layer(layer).ground);
	}
}

} // namespace

TEST_CASE("map_layers: nothing waits of a map that is what it was, and of one that changed what differs") {
	const PaintMap before = paint_rows();
	MapLayers layers = lay_out(before);
	layers.touch(before, before);
	CHECK(layers.get_waiting() == 0);
	PaintMap now = before;
	now.set_code(MAP_WEAR, 0, 20, 20, 255);
	layers.touch(before, now);
	CHECK(layers.get_waiting() > 0);
	CHECK(layers.get_waiting() < 16); // not all of its chunks
	work_off(layers, now);
	check_same(layers, lay_out(now));
	PaintMap bare = now;
	bare.set_base_density(0.0);
	layers.touch(now, bare);
	CHECK(layers.get_waiting() == 16);
	work_off(layers, bare);
	CHECK(std::ranges::equal(layers.get_cover()->get_tiles(), lay_out(bare).get_cover()->get_tiles())); // texels beyond the field stay
}

TEST_CASE("map_layers: places differ by the field's tiles, its longest blade, how blades follow slopes, how high thin grass is, and "
		  "species") {
	CHECK(lay_out(paint_rows()).get_place() == PLACE);
	MapPlace grid = PLACE, tallest = PLACE, follow = PLACE, sparse = PLACE, species = PLACE;
	grid.grid = TileGrid::make(200.0, 150.0, 256.0);
	tallest.tallest = 0.7;
	follow.follow = 0.25f;
	sparse.sparse_height = 0.5f;
	species.has_species = true;
	for (const MapPlace &other : { grid, tallest, follow, sparse, species }) {
		CHECK(other != PLACE);
	}
}

TEST_CASE("map_layers: thin grass is lower by sparse_height, and dense grass and that of other fields is not") {
	PaintMap map;
	map.set_base_density(0.25);
	paint(map, MapTool::PAINT, 1.0, disc(0.0, 0.0, 4.0));
	MapPlace place{ HILL_GRID };
	MapLayers whole(place);
	whole.update(map, whole.get_region());
	place.sparse_height = 0.4f;
	MapLayers lower(place);
	lower.update(map, lower.get_region());
	CHECK(whole.sample({ 14.0f, 0.0f }).height == 1.0f);
	CHECK(lower.sample({ 0.0f, 0.0f }).height == 1.0f);
	const float thin = lower.sample({ 14.0f, 0.0f }).height;
	CHECK(thin > 0.4f);
	CHECK(thin < 0.65f);
	CHECK(lower.sample({ 4.0f, 0.0f }).height < 0.98f); // its border
	CHECK(lower.sample({ 4.0f, 0.0f }).height > thin);
}
