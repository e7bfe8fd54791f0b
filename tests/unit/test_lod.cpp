// SPDX-License-Identifier: MIT
#include "core/lod/lod.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

using namespace grass;

namespace {

const BladeSize BLADE{ 0.015f, 0.5f };
constexpr float PIXEL_SLOPE = 0.00142f; // metres in a pixel a metre away: 1080 lines, 75 degrees

// Returns what a tile needs at p_distance.
LodNeed need_at(const LodParams &p_params, float p_distance) {
	LodNeed need;
	need.add(p_params, BLADE, p_distance, 0.05f, PIXEL_SLOPE * p_distance);
	return need;
}

} // namespace

TEST_CASE("lod: L(z) is the paper's line, full at the near plane, never below an eighth") {
	CHECK(grass_lod_blades(0.1f, 0.1f, 100.0f) == 64.0f);
	CHECK(grass_lod_blades(0.0f, 0.1f, 100.0f) == 64.0f);
	CHECK(grass_lod_blades(40.1f, 0.1f, 100.0f) == doctest::Approx((1.0 - 7.0 * 40.0 / 800.0) * 64.0));
	CHECK(grass_lod_blades(100.1f, 0.1f, 100.0f) == doctest::Approx(8.0));
	CHECK(grass_lod_blades(1e9f, 0.1f, 100.0f) == 8.0f);
	float before = 64.0f;
	for (int i = 0; i < 1000; i++) {
		const float blades = grass_lod_blades(0.15f * float(i), 0.1f, 100.0f);
		CHECK(blades <= before);
		before = blades;
	}
}

TEST_CASE("lod: blades that would be thinner than pixels are fewer, and cover as much") {
	CHECK(grass_lod_blades_of_width(0.015f, 0.0f) == 64.0f);
	CHECK(grass_lod_blades_of_width(0.015f, 0.005f) == 64.0f);
	CHECK(grass_lod_blades_of_width(0.015f, 100.0f) == 1.0f);
	for (const float least : { 0.01f, 0.02f, 0.05f, 0.2f }) {
		const float blades = grass_lod_blades_of_width(0.015f, least);
		CHECK(blades * least == doctest::Approx(64.0 * 0.015 * GRASS_LOD_FACING));
	}
}

TEST_CASE("lod: the level's mesh always holds the blades, has the segments, and is the smallest such one") {
	for (const auto &[first, end] : { std::pair(0, GRASS_LOD_LEVELS), std::pair(GRASS_LOD_LEVELS, GRASS_ALL_LEVELS) }) {
		for (const int segments : { 1, 2, 3, 5, 7, 15 }) {
			if (segments > get_lod_level(first).segments) {
				continue;
			}
			for (float blades = 1.0f; blades <= 64.0f; blades += 0.25f) {
				const int level = find_lod_level(blades, segments, first, end, ALL_LEVELS);
				REQUIRE(level >= first);
				REQUIRE(level < end);
				const LodLevel mesh = get_lod_level(level);
				REQUIRE(mesh.segments == segments);
				REQUIRE(float(mesh.blades) >= blades);
				const bool has_smaller = level + 1 < end && get_lod_level(level + 1).segments == segments;
				REQUIRE((!has_smaller || float(get_lod_level(level + 1).blades) < blades));
			}
		}
	}
}

TEST_CASE("lod: with the distance blades and segments fall and never jump") {
	const LodParams params;
	LodNeed before = need_at(params, 0.1f);
	CHECK(before.blades == doctest::Approx(64.0).epsilon(0.01));
	CHECK(grass_lod_segments(before.segments) == 15);
	for (int i = 1; i < 8000; i++) {
		const LodNeed need = need_at(params, 0.1f + 0.05f * float(i));
		REQUIRE(need.blades <= before.blades);
		REQUIRE(need.segments <= before.segments);
		REQUIRE(before.blades - need.blades < 1.0f);
		const int segments = grass_lod_segments(need.segments), segments_before = grass_lod_segments(before.segments);
		const float morph = grass_lod_morph(need.segments, segments), morph_before = grass_lod_morph(before.segments, segments_before);
		if (segments == segments_before) {
			REQUIRE(morph >= morph_before);
		} else { // the rows have met where the coarser mesh takes over, and it begins unchanged
			REQUIRE(morph_before > 0.9f);
			REQUIRE(morph < 0.1f);
		}
		before = need;
	}
	CHECK(grass_lod_segments(before.segments) == 1);
	CHECK(before.blades < 4.0f);
}

TEST_CASE("lod: what the tile shows is whole at both ends and rises with what it needs") {
	for (const float hash : { 0.0f, 0.3f, 0.999f }) {
		CHECK(grass_lod_shown(64.0f, hash) == 64.0f);
		CHECK(grass_lod_shown(1.0f, hash) == 1.0f);
		float before = 1.0f;
		for (float blades = 1.0f; blades <= 64.0f; blades += 0.125f) {
			const float shown = grass_lod_shown(blades, hash);
			CHECK(shown >= before);
			CHECK(std::abs(shown - blades) <= 0.5f);
			before = shown;
		}
	}
}

TEST_CASE("lod: of tiles of less than one blade so many show one, and each comes and goes by degrees") {
	for (const float blades : { 0.05f, 0.3f, 0.7f, 0.99f }) {
		double shown = 0.0;
		for (int i = 0; i < 2048; i++) {
			shown += double(grass_lod_shown(blades, float(i) / 2048.0f)) / 2048.0;
		}
		CHECK(shown == doctest::Approx(blades).epsilon(0.1));
	}
	for (const float hash : { 0.0f, 0.3f, 0.999f }) {
		CHECK(grass_lod_shown(0.0f, hash) == 0.0f);
		float before = 0.0f;
		for (float blades = 0.0f; blades <= 1.0f; blades += 0.01f) {
			const float shown = grass_lod_shown(blades, hash);
			CHECK(shown >= before);
			CHECK(shown - before < 0.0801f);
			before = shown;
		}
		CHECK(before > 0.99f);
	}
}

// Light that comes through grass along a line of sight, for blades that stand anywhere: by counting.
TEST_CASE("lod: what is left out is hidden: less than 3 % of the ground shows through what is drawn, or as much as without") {
	const float width = 0.015f, length = 0.5f, side = 0.5f, cover = grass_lod_cover(width, length, side);
	CHECK(cover == doctest::Approx(64.0 * 0.64 * 0.705 * 0.015 * 0.5 / 0.25));
	for (const float above : { 0.1f, 1.2f, 4.0f, 30.0f }) {
		float before = 1.0f;
		for (float away = 0.5f; away < 400.0f; away *= 1.1f) {
			const float share = grass_lod_in_sight(cover, away, above, length, 0.0f);
			const double meets = double(cover) * std::min(away / above, away / length); // blades along the line, on average
			CHECK(share <= before);
			CHECK(std::exp(-share * meets) <= std::max(0.03, std::exp(-meets)));
			CHECK((meets > double(GRASS_LOD_DEPTH)) == (share < 1.0f));
			before = share;
		}
	}
}

TEST_CASE("lod: a slope that faces the eye shows more, thin grass all of it, and nobody below or inside the grass loses what is near") {
	const float cover = grass_lod_cover(0.015f, 0.5f, 0.5f);
	const float level = grass_lod_in_sight(cover, 80.0f, 1.2f, 0.5f, 0.0f);
	CHECK(level < 0.1f);
	CHECK(grass_lod_in_sight(cover, 80.0f, 1.2f, 0.5f, 0.1f) > 5.0f * level);
	CHECK(grass_lod_in_sight(cover, 80.0f, 1.2f, 0.5f, 1.0f) == 1.0f);
	CHECK(grass_lod_in_sight(0.04f * cover, 80.0f, 1.2f, 0.5f, 0.0f) == 1.0f);
	CHECK(grass_lod_in_sight(0.0f, 80.0f, 1.2f, 0.5f, 0.0f) == 1.0f);
	CHECK(grass_lod_in_sight(cover, 0.0f, 1.2f, 0.5f, 0.0f) == 1.0f); // straight down
	for (const float above : { -50.0f, -1.0f, 0.0f }) {
		CHECK(grass_lod_in_sight(cover, 0.5f, above, 0.5f, 0.0f) == 1.0f);
		const float far = grass_lod_in_sight(cover, 100.0f, above, 0.5f, 0.0f);
		CHECK(far > 0.0f);
		CHECK(far < 0.1f);
	}
	CHECK(grass_lod_in_sight(cover, 10.0f, 100.0f, 0.5f, 1.0f) == 1.0f); // against a steep slope, from its front
}

TEST_CASE("lod: without a least width and an error it is switched off") {
	LodParams params;
	params.far = 1e30f;
	params.pixels_min = params.error = 0.0f;
	const LodNeed need = need_at(params, 5000.0f);
	CHECK(need.blades == 64.0f);
	CHECK(grass_lod_segments(need.segments) == 15);
}

TEST_CASE("lod: the camera that needs most counts") {
	LodNeed both = need_at(LodParams(), 80.0f);
	both.add(LodParams(), BLADE, 3.0f, 0.05f, 3.0f * PIXEL_SLOPE);
	both.add(LodParams(), BLADE, 40.0f, 0.05f, 40.0f * PIXEL_SLOPE);
	CHECK(both.blades == need_at(LodParams(), 3.0f).blades);
	CHECK(both.segments == need_at(LodParams(), 3.0f).segments);
}

TEST_CASE("lod: blades in shadows are fine beside the eye and coarse where shadows end [Eq L14]") {
	const float coarse = LodParams().shadow_coarseness;
	CHECK(grass_lod_shadow(coarse, 1.0f, 60.0f) < 0.6f * coarse);
	CHECK(grass_lod_shadow(coarse, 60.0f, 60.0f) > 2.0f * coarse);
	CHECK(grass_lod_shadow(coarse, 1e9f, 60.0f) == grass_lod_shadow(coarse, 60.0f, 60.0f));
	CHECK(grass_lod_shadow(1.0f, 0.1f, 60.0f) == 1.0f); // never finer than the picture
	CHECK(std::isfinite(grass_lod_shadow(coarse, 1.0f, 0.0f)));
	const LodParams near = LodParams().of_shadows(5.0f, 60.0f);
	CHECK(need_at(near, 5.0f).blades > 1.3f * need_at(LodParams(), 5.0f * LodParams().shadow_coarseness).blades);
	CHECK(near.far == LodParams().far);
}

TEST_CASE("lod: fine shadows beside the eye cost no more than even ones would") {
	for (const float reach : { 30.0f, 60.0f, 100.0f }) {
		double vertices = 0.0, evenly = 0.0;
		for (float distance = 0.25f; distance < reach; distance += 0.25f) {
			const auto cost = [&](const LodParams &p_params) {
				const LodNeed need = need_at(p_params, distance);
				return double(distance * need.blades * float(2 * std::min(grass_lod_segments(need.segments), 3) + 1));
			};
			LodParams even;
			even.pixels_min *= even.shadow_coarseness;
			even.error *= even.shadow_coarseness;
			vertices += cost(LodParams().of_shadows(distance, reach));
			evenly += cost(even);
		}
		CAPTURE(reach);
		CHECK(vertices < evenly);
	}
}

TEST_CASE("lod: parameters are mended") {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	const LodParams params = LodParams{ nan, -1.0f, nan, -5.0f }.sanitised();
	CHECK(params.far == 0.001f);
	CHECK(params.error == 0.0f);
	CHECK(params.pixels_min == 0.0f);
	CHECK(params.shadow_coarseness == 1.0f);
}

TEST_CASE("lod: ranks that have room hold no more tiles than there is room for, and the next one would") {
	std::mt19937 random(6);
	std::array<uint32_t, GRASS_RANKS> tiles{};
	CHECK(grass_lod_ranks(tiles, 0) == GRASS_RANKS); // nothing needs no room
	for (int i = 0; i < 200; i++) {
		for (uint32_t &count : tiles) {
			count = random() % 5;
		}
		const uint32_t room = random() % 300, ranks = grass_lod_ranks(tiles, room);
		REQUIRE(std::accumulate(tiles.begin(), tiles.begin() + ranks, 0u) <= room);
		REQUIRE((ranks == GRASS_RANKS || std::accumulate(tiles.begin(), tiles.begin() + ranks + 1, 0u) > room));
	}
}

TEST_CASE("lod: finely drawn tiles rank before all of one segment, whose blades grow with what is left out") {
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const bool is_fine = get_lod_level(level).segments > 1;
		for (const uint32_t turn : { 0u, 31u, 63u }) {
			REQUIRE((grass_lod_rank(level, turn) < GRASS_TURNS) == is_fine);
			REQUIRE(grass_lod_rank(level, turn) % GRASS_TURNS == turn);
		}
	}
	CHECK(grass_lod_left_out(GRASS_RANKS) == 0.0f);
	CHECK(grass_lod_left_out(GRASS_TURNS + 48) == 0.25f);
	CHECK(grass_lod_left_out(GRASS_TURNS + 1) == 0.75f); // four times as wide at most
}
