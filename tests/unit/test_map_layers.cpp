// SPDX-License-Identifier: MIT
// The map as a field shows it: layers of texels, and what they say at a place.
#include "hill_map.h"

#include "core/map/field_map.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace grass;
using namespace grass::test;

TEST_CASE("map_layers: a layer sampled by itself says what the map says, over chunk borders, too") {
	const PaintMap map = paint_varied();
	MapLayers layers;
	layers.reset(HILL_GRID);
	CHECK(layers.update(map, { { -20, -20 }, { 20, 20 } }) == std::vector<int>{ 0, 1, 2, 3 });
	std::mt19937 random(1);
	std::uniform_real_distribution<float> place(-18.0f, 18.0f);
	for (int n = 0; n < 2000; n++) {
		const Eigen::Vector2f at(place(random), place(random));
		const Growth here = layers.sample(at, 0.0f);
		CHECK(here.density == doctest::Approx(map.sample(MAP_DENSITY, 0, at.cast<double>())).epsilon(0.001));
		CHECK(std::abs(here.height - map.sample(MAP_HEIGHT, 0, at.cast<double>())) < 0.125); // a kink of 1/m, blended at 0.5 m
		CHECK(here.ground == doctest::Approx(0.5 * at.x() + 0.25 * at.y()).epsilon(1e-4));
		CHECK(here.cut == doctest::Approx(MAP_UNCUT));
	}
	CHECK(layers.sample({ 1e9f, 0.0f }, 0.0f).density == 0.0f);
	CHECK(layers.sample({ std::nanf(""), 0.0f }, 0.0f).density == 0.0f);
}

TEST_CASE("map_layers: only what changed is put together again, and only changed layers are named") {
	PaintMap map;
	paint(map, MapTool::PAINT, 1.0, disc(0.0, 0.0, 15.0));
	MapLayers layers;
	layers.reset(HILL_GRID);
	layers.update(map, { { -20, -20 }, { 20, 20 } });
	CHECK(layers.update(map, { { -20, -20 }, { 20, 20 } }).empty());
	const BrushResult result = paint(map, MapTool::ERASE, 0.0, disc(10.0, 10.0, 1.0));
	const std::vector<int> changed = layers.update(map, { result.min, result.max });
	CHECK(changed.size() == 1);
	MapLayers fresh;
	fresh.reset(HILL_GRID);
	fresh.update(map, { { -20, -20 }, { 20, 20 } });
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
	MapLayers layers;
	layers.reset(HILL_GRID);
	layers.update(map, { { -20, -20 }, { 20, 20 } });
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
	MapLayers layers;
	layers.reset(HILL_GRID);
	const MapLayers empty = layers;
	MapLayers around;
	layers.update(map, { { -20, -20 }, { 20, 20 } });
	std::mt19937 random(1);
	std::uniform_real_distribution<float> place(-25.0f, 25.0f);
	for (int n = 0; n < 200; n++) {
		const Eigen::Vector2f at = n == 0 ? Eigen::Vector2f(0.0f, 0.0f) : Eigen::Vector2f(place(random), place(random));
		empty.read(map, at, around);
		const Growth here = around.sample(at, 0.25f), there = layers.sample(at, 0.25f);
		CHECK(here.density == there.density);
		CHECK(here.height == there.height);
		CHECK(here.cut == there.cut);
		CHECK(here.lean == there.lean);
		CHECK(here.tilt == there.tilt);
		CHECK(here.ground == there.ground);
	}
	empty.read(map, { 1e9f, 0.0f }, around);
	CHECK(around.get_count() == 0);
	empty.read(map, { std::nanf(""), 0.0f }, around);
	CHECK(around.get_count() == 0);
}
