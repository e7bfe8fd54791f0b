// SPDX-License-Identifier: MIT
#include "map_scene.h"

#include "core/map/map_merge.h"

#include <doctest/doctest.h>

#include <random>

using namespace grass;
using namespace grass::test;

namespace {

bool are_same(const PaintMap &p_a, const PaintMap &p_b) {
	return write_map(p_a, RUNS) == write_map(p_b, RUNS);
}

// Changes texels of every channel in columns of one parity, so that two of them share no texel.
PaintMap painted(const PaintMap &p_map, uint32_t p_seed, int p_parity) {
	PaintMap map = p_map;
	std::mt19937 random(p_seed);
	for (int n = 0; n < 4000; n++) {
		const MapChannel channel = MapChannel(random() % MAP_CHANNELS);
		const MapChannelInfo &info = info_of(channel);
		const int i = int(random() % uint32_t(2 * info.side)) * 2 - 2 * info.side + p_parity;
		map.set_code(channel, int(random() % uint32_t(info.components)), i, int(random() % uint32_t(2 * info.side)) - info.side,
				int32_t(random() % 300));
	}
	return map;
}

// The merge as its definition says it.
int32_t merged_code(
		const PaintMap &p_base, const PaintMap &p_theirs, const PaintMap &p_mine, MapChannel p_channel, int p_component, int p_i, int p_j) {
	bool is_theirs = false;
	for (int c = 0; c < info_of(p_channel).components; c++) {
		is_theirs = is_theirs || p_theirs.get_code(p_channel, c, p_i, p_j) != p_base.get_code(p_channel, c, p_i, p_j);
	}
	return (is_theirs ? p_theirs : p_mine).get_code(p_channel, p_component, p_i, p_j);
}

} // namespace

TEST_CASE("map_merge: texels that only one side changed come from that side") {
	for (uint32_t seed = 1; seed < 4; seed++) {
		const PaintMap base = make_map(seed), mine = painted(base, 10 + seed, 0), theirs = painted(base, 20 + seed, 1);
		PaintMap merged = mine, other_way = theirs;
		const MapMerge merge = merge_maps(base, theirs, merged);
		CHECK(merge.reason == "");
		CHECK(merge.conflicts.empty());
		CHECK(merge.texels > 1000);
		CHECK(merge.changed == merged.compare(mine));
		CHECK_FALSE(merge.has_base_changed);
		CHECK(merge_maps(base, mine, other_way).conflicts.empty());
		CHECK(are_same(merged, other_way));
		size_t wrong = 0;
		for (int n = 0; n < MAP_CHANNELS; n++) {
			const MapChannel channel = MapChannel(n);
			const int side = info_of(channel).side;
			for (int j = -side; j < side; j += 3) {
				for (int i = -side; i < side; i++) {
					wrong += merged.get_code(channel, 0, i, j) != merged_code(base, theirs, mine, channel, 0, i, j) ? 1 : 0;
				}
			}
		}
		CHECK(wrong == 0);
	}
}

TEST_CASE("map_merge: a conflict names its texels, and the side that is preferred stays") {
	const PaintMap base = make_map(7);
	PaintMap mine = base, theirs = base;
	for (const int i : { -70, -69, -66 }) {
		theirs.set_code(MAP_TINT, 1, i, 5, 11);
		mine.set_code(MAP_TINT, 2, i, 5, 12); // another component of the same texel
	}
	theirs.set_code(MAP_DENSITY, 0, 300, 300, 77);
	mine.set_code(MAP_DENSITY, 0, 300, 300, 77); // both the same
	theirs.set_code(MAP_GROUND, 0, 500, -500, 123456);
	for (const bool prefers_theirs : { false, true }) {
		PaintMap merged = mine;
		const MapMerge merge = merge_maps(base, theirs, merged, prefers_theirs);
		REQUIRE(merge.conflicts.size() == 1);
		const MergeConflict &conflict = merge.conflicts[0];
		CHECK(conflict.key == MapKey{ -2, 0 });
		CHECK(conflict.channel == MAP_TINT);
		CHECK(conflict.texels == 3);
		CHECK(conflict.region.min == Eigen::Vector2d(-70, 5));
		CHECK(conflict.region.max == Eigen::Vector2d(-65, 6));
		CHECK(merge.texels == (prefers_theirs ? 4 : 1));
		CHECK(merged.get_code(MAP_TINT, 1, -69, 5) == (prefers_theirs ? theirs : mine).get_code(MAP_TINT, 1, -69, 5));
		CHECK(merged.get_code(MAP_TINT, 2, -69, 5) == (prefers_theirs ? theirs : mine).get_code(MAP_TINT, 2, -69, 5));
		CHECK(merged.get_code(MAP_GROUND, 0, 500, -500) == 123456);
	}
}

TEST_CASE("map_merge: without changes on one side the other is the result") {
	const PaintMap base = make_map(3), changed = painted(base, 4, 0);
	PaintMap merged = base;
	CHECK(merge_maps(base, changed, merged).conflicts.empty());
	CHECK(are_same(merged, changed));
	CHECK(merge_maps(base, base, merged).texels == 0);
	CHECK(are_same(merged, changed));
	PaintMap cleared = base;
	cleared.clear();
	merged = changed;
	CHECK(merge_maps(changed, cleared, merged).conflicts.empty()); // they cleared it
	CHECK(merged.is_empty());
	merged = changed;
	const MapMerge from_nothing = merge_maps(PaintMap(), changed, merged); // both added the same file
	CHECK(from_nothing.conflicts.empty());
	CHECK(are_same(merged, changed));
}

TEST_CASE("map_merge: the base density merges with the texels that it covers") {
	PaintMap base, mine, theirs;
	theirs.set_base_density(1.0);
	mine.set_code(MAP_DENSITY, 0, 3, 4, 100);
	PaintMap merged = mine;
	MapMerge merge = merge_maps(base, theirs, merged);
	CHECK(merge.has_base_changed);
	CHECK(merge.conflicts.empty());
	CHECK(merged.get_base_density() == 1.0);
	CHECK(merged.get_code(MAP_DENSITY, 0, 3, 4) == 100);
	CHECK(merged.get_code(MAP_DENSITY, 0, 4, 4) == 255); // beside it
	CHECK(merged.get_code(MAP_DENSITY, 0, 400, 4) == 255);
	merged = theirs; // and the other way round
	merge = merge_maps(base, mine, merged);
	CHECK(merge.conflicts.empty());
	CHECK(merged.get_code(MAP_DENSITY, 0, 3, 4) == 100);
	CHECK(merged.get_code(MAP_DENSITY, 0, 4, 4) == 255);
	mine.set_base_density(0.5);
	for (const bool prefers_theirs : { false, true }) {
		merged = mine;
		merge = merge_maps(base, theirs, merged, prefers_theirs);
		CHECK(merge.is_base_in_conflict);
		CHECK(merge.has_base_changed == prefers_theirs);
		CHECK(merged.get_base_density() == (prefers_theirs ? theirs : mine).get_base_density());
	}
}

TEST_CASE("map_merge: a map that would be too large is refused, and nothing changes") {
	const PaintMap base;
	PaintMap mine, theirs;
	for (int x = -64; x < 64; x++) {
		for (int z = -64; z < 64; z++) {
			mine.set_code(MAP_HOLE, 0, 64 * x, 64 * z, 1);
		}
	}
	theirs.set_code(MAP_HOLE, 0, 64 * 100, 0, 1);
	const PaintMap before = mine;
	const MapMerge full = merge_maps(base, theirs, mine);
	CHECK(full.reason.find("at most 16384") != std::string::npos);
	CHECK(full.changed.empty());
	CHECK(mine.compare(before).empty());
	ReadLimits limits;
	limits.map_bytes = 1000;
	limits.map_hint = " (the setting)";
	PaintMap small;
	CHECK(merge_maps(base, theirs, small, false, limits).reason ==
			"would take 1 MB of memory, but a map may take at most 1 MB (the setting)");
	CHECK(small.is_empty());
}

TEST_CASE("map_merge: an undone step takes back its own texels, whoever painted since") {
	const PaintMap before = make_map(5), mine = painted(before, 6, 0), both = painted(mine, 7, 1), others = painted(before, 7, 1);
	PaintMap undone = both;
	CHECK(merge_maps(mine, before, undone).conflicts.empty());
	CHECK(are_same(undone, others));
	CHECK(merge_maps(before, mine, undone).conflicts.empty()); // redone
	CHECK(are_same(undone, both));
}

TEST_CASE("map_merge: what others painted over a step stays when it is undone") {
	PaintMap before;
	before.set_base_density(1.0);
	PaintMap mine = before;
	mine.set_code(MAP_DENSITY, 0, 3, 3, 10);
	mine.set_code(MAP_DENSITY, 0, 4, 3, 10);
	PaintMap map = mine;
	map.set_code(MAP_DENSITY, 0, 4, 3, 20);
	(void)merge_maps(mine, before, map);
	CHECK(map.get_code(MAP_DENSITY, 0, 3, 3) == 255);
	CHECK(map.get_code(MAP_DENSITY, 0, 4, 3) == 20);
	map.set_code(MAP_DENSITY, 0, 4, 3, 255);
	map.compact();
	CHECK(map.is_empty());
}

TEST_CASE("map_merge: an undone base density leaves what was painted on it") {
	PaintMap bare, full;
	full.set_base_density(1.0);
	PaintMap map = full;
	map.set_code(MAP_DENSITY, 0, 3, 3, 10); // another scene erases there
	(void)merge_maps(full, bare, map);
	CHECK(map.get_base_density() == 0.0);
	CHECK(map.get_code(MAP_DENSITY, 0, 3, 3) == 10);
	CHECK(map.get_code(MAP_DENSITY, 0, 4, 3) == 0);
}

TEST_CASE("map_merge: only chunks that differ are copied, and what is restored shares its texels") {
	const PaintMap before = make_map(8);
	PaintMap mine = before;
	mine.set_code(MAP_WEAR, 0, 5, 5, 77);
	const MapKey touched{ 0, 0 };
	PaintMap map = mine;
	(void)merge_maps(mine, before, map);
	size_t copied = 0;
	for (const auto &[key, chunk] : map.get_chunks()) {
		for (size_t channel = 0; channel < MAP_CHANNELS; channel++) {
			copied += chunk.channels[channel] != before.find(key)->channels[channel] ? 1 : 0;
		}
	}
	CHECK(before.find(touched) != nullptr);
	CHECK(copied == 0);
}
