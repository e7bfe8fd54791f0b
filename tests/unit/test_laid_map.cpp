// SPDX-License-Identifier: MIT
// A map that was laid out beforehand shows what one that is laid out now does, also where the map changed in between.
#include "core/map/laid_map.h"

#include <doctest/doctest.h>

using namespace grass;

namespace {

const MapPlace PLACE{ TileGrid::make(200.0, 140.0, 256.0), 0.6, 0.5f };

PaintMap painted() {
	PaintMap map;
	map.set_base_density(1.0);
	for (int i = -90; i < 90; i++) {
		map.set_code(MAP_DENSITY, 0, i, i / 2, 40);
		map.set_code(MAP_CUT, 0, i, 7, 12);
		map.set_code(MAP_GROUND, 0, i, 3, 2048);
	}
	return map;
}

void check_same(const FieldMap &p_one, const FieldMap &p_other) {
	REQUIRE(p_one.get_cover()->get_tiles().size() == p_other.get_cover()->get_tiles().size());
	CHECK(std::ranges::equal(p_one.get_cover()->get_tiles(), p_other.get_cover()->get_tiles()));
	REQUIRE(p_one.get_layers().get_pages() == p_other.get_layers().get_pages());
	for (int layer = 0; layer < p_one.get_layers().get_count(); layer++) {
		CHECK(p_one.get_layers().get_layer(layer).growth == p_other.get_layers().get_layer(layer).growth);
		CHECK(p_one.get_layers().get_layer(layer).ground == p_other.get_layers().get_layer(layer).ground);
	}
}

FieldMap laid_now(const PaintMap &p_map) {
	FieldMap field(PLACE.grid, PLACE.tallest, PLACE.follow);
	field.update(p_map, field.get_region());
	return field;
}

} // namespace

TEST_CASE("laid map: nothing waits, and it is what is laid out now") {
	const PaintMap map = painted();
	const std::optional<FieldMap> field = LaidMap(map, PLACE).take(map, PLACE);
	REQUIRE(field);
	CHECK(field->get_waiting() == 0);
	check_same(*field, laid_now(map));
}

TEST_CASE("laid map: what changed since waits") {
	PaintMap map = painted();
	LaidMap laid(map, PLACE);
	map.set_code(MAP_WEAR, 0, 20, 20, 255);
	std::optional<FieldMap> field = std::move(laid).take(map, PLACE);
	REQUIRE(field);
	CHECK(field->get_waiting() > 0);
	CHECK(field->get_waiting() < 12); // not all of its chunks
	while (field->get_waiting() > 0) {
		field->work(map);
	}
	check_same(*field, laid_now(map));
}

TEST_CASE("laid map: of no use to another field") {
	const PaintMap map = painted();
	MapPlace other = PLACE;
	other.tallest = 0.7;
	CHECK_FALSE(LaidMap(map, PLACE).take(map, other));
	other = PLACE;
	other.grid = TileGrid::make(200.0, 150.0, 256.0);
	CHECK_FALSE(LaidMap(map, PLACE).take(map, other));
}
