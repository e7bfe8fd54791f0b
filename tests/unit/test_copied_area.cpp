// SPDX-License-Identifier: MIT
#include "map_scene.h"

#include "core/paint/copied_area.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

namespace {

int same_number(int p_species) {
	return p_species;
}

} // namespace

TEST_CASE("copied_area: it is pasted to the code, shifted by whole metres, and nothing beside it changes") {
	const PaintMap from = make_map(1), before = make_map(2);
	PaintMap map = before;
	const CopiedArea area{ from, { 3.2, -5.6 }, { 7.0, 7.0 }, true };
	paste_area(area, { 40.9, 10.2 }, same_number, map); // by (38, 16)
	size_t wrong = 0, inside = 0;
	for (int n = 0; n < MAP_CHANNELS; n++) {
		const MapChannel channel = MapChannel(n);
		const MapChannelInfo &info = info_of(channel);
		const bool is_ground = channel == MAP_GROUND || channel == MAP_NORMAL || channel == MAP_HOLE || channel == MAP_LEDGE;
		const int in_metre = info.side / 64;
		for (int j = 0; j < 24 * in_metre; j++) {
			for (int i = 28 * in_metre; i < 52 * in_metre; i++) {
				const Eigen::Vector2d source = Eigen::Vector2d(i + 0.5, j + 0.5) * info.texel_size() - Eigen::Vector2d(38, 16);
				const bool is_pasted = !is_ground && (source - area.middle).norm() <= 7.0;
				inside += is_pasted ? 1 : 0;
				for (int component = 0; component < info.components; component++) {
					const int32_t right = is_pasted ? from.get_code(channel, component, i - 38 * in_metre, j - 16 * in_metre)
													: before.get_code(channel, component, i, j);
					wrong += map.get_code(channel, component, i, j) != right ? 1 : 0;
				}
			}
		}
	}
	CHECK(wrong == 0);
	CHECK(inside > 3000);
}

TEST_CASE("copied_area: a rectangle is pasted up to its sides, with the density where nothing was painted") {
	PaintMap from, map;
	from.set_base_density(1.0);
	const CopiedArea area{ from, { 0, 0 }, { 3, 2 }, false };
	CHECK(area.area() == 24.0);
	map.set_code(MAP_TINT, 0, 100, 0, 9);
	paste_area(area, { 100, 0 }, same_number, map);
	CHECK(map.get_code(MAP_DENSITY, 0, 194, -4) == 255);
	CHECK(map.get_code(MAP_DENSITY, 0, 205, 3) == 255);
	for (const auto &[i, j] : { std::pair(193, 0), std::pair(206, 0), std::pair(200, -5), std::pair(200, 4) }) {
		CHECK(map.get_code(MAP_DENSITY, 0, i, j) == 0);
	}
	CHECK_FALSE(map.uses(MAP_TINT)); // as it is at first
}

TEST_CASE("copied_area: species get the numbers that they have here, and those that do not grow here are left out") {
	PaintMap from, map;
	from.set_code(MAP_SPECIES, 0, 0, 0, 1);
	from.set_code(MAP_SPECIES, 0, 1, 0, 2);
	map.set_code(MAP_SPECIES, 0, 10, 0, 7);
	map.set_code(MAP_SPECIES, 0, 11, 0, 7);
	map.set_code(MAP_SPECIES, 0, 12, 0, 7);
	const auto number_here = [](int p_species) { return p_species == 1 ? 4 : (p_species == 2 ? -1 : p_species); };
	paste_area({ from, { 1, 0 }, { 2, 2 }, false }, { 11, 0 }, number_here, map);
	CHECK(map.get_code(MAP_SPECIES, 0, 10, 0) == 4);
	CHECK(map.get_code(MAP_SPECIES, 0, 11, 0) == 7);
	CHECK(map.get_code(MAP_SPECIES, 0, 12, 0) == 0); // mixed there
}
