// SPDX-License-Identifier: MIT
// The levels that core/lod/field_levels finds by a field's box against those that TileCull chooses for its tiles.
#include "core/lod/field_levels.h"

#include "core/base/hash.h"
#include "core/map/map_layers.h"
#include "hill_map.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <map>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

const TileCull::SlotOf ALL_ASLEEP = [](int) { return GRASS_NO_SLOT; };

struct Random {
	std::mt19937 engine;
	float operator()(float p_low, float p_high) { return std::uniform_real_distribution<float>(p_low, p_high)(engine); }
	bool coin() { return (engine() & 1) != 0; }
};

CullField make_field(double p_side, float p_length = 0.4f) {
	return { TileGrid::make(p_side, p_side, 256.0), 0.4f, p_length, { 0.006f, 0.8f * p_length }, 7, { 1u << 20, 1u << 20 } };
}

// Returns a camera of 1080 lines that looks at a place, 75 degrees high and wide.
ViewCamera make_camera(const Eigen::Vector3f &p_eye, const Eigen::Vector3f &p_at) {
	const Eigen::Vector3f ahead = (p_at - p_eye).normalized(), right = ahead.cross(Eigen::Vector3f(0.01f, 1.0f, 0.02f)).normalized(),
						  up = right.cross(ahead);
	const float c = std::cos(0.6545f), s = std::sin(0.6545f);
	ViewCamera camera;
	const Eigen::Vector3f normals[] = { -ahead, ahead, c * right - s * ahead, -c * right - s * ahead, c * up - s * ahead,
		-c * up - s * ahead };
	for (size_t i = 0; i < 6; i++) {
		camera.planes[i] << normals[i], normals[i].dot(p_eye) + (i == 0 ? -0.05f : i == 1 ? 1000.0f : 0.0f);
	}
	camera.eye = p_eye;
	camera.pixel_slope = float(2.0 * std::tan(0.6545) / 1080.0);
	return camera;
}

FieldView random_view(Random &r_random, int p_cameras) {
	FieldView view;
	for (int i = 0; i < p_cameras; i++) {
		const float away = std::exp(r_random(-1.0f, 5.0f));
		const Eigen::Vector3f eye(away * r_random(-1.0f, 1.0f), r_random(-0.5f, 1.0f) * away, away * r_random(-1.0f, 1.0f));
		ViewCamera &camera = view.cameras.emplace_back(make_camera(eye, Eigen::Vector3f(r_random(-5, 5), 0.0f, r_random(-5, 5))));
		if (r_random(0.0f, 1.0f) < 0.15f) { // orthogonal
			camera.pixel_slope = 0.0f;
			camera.pixel = r_random(0.001f, 0.1f);
		}
	}
	view.lod.is_carried = r_random.coin();
	view.lod.pixels_min = r_random.coin() ? 1.2f : r_random(0.0f, 4.0f);
	view.lod.error = r_random(0.0f, 2.0f);
	view.lod.far = r_random(20.0f, 200.0f);
	view.shadow_distance = r_random.coin() ? 60.0f : 0.0f;
	view.shadow_margin = 1.0f;
	if (r_random.coin()) {
		view.falls.emplace_back(0.7f, -0.7f, 0.1f);
	}
	return view;
}

struct Drawn {
	int level;
	std::vector<float> numbers;
};
using Tiles = std::map<std::tuple<int, int, bool>, Drawn>; // by column, row, and whether it casts

Tiles choose(const CullField &p_field, const FieldView &p_view, const TileCover *p_cover, LevelSet p_levels) {
	TileCull cull;
	cull.choose(p_field, p_view, p_cover, ALL_ASLEEP, p_levels);
	Tiles tiles;
	for (int level = 0; level < GRASS_ALL_LEVELS; level++) {
		const std::span<const float> all = cull.get_instances(level);
		for (size_t at = 0; at < all.size(); at += GRASS_INSTANCE_FLOATS) {
			const auto own = all.subspan(at, GRASS_INSTANCE_FLOATS);
			tiles[{ int(own[INSTANCE_TILE]), int(own[INSTANCE_TILE + 1]), level >= GRASS_LOD_LEVELS }] = { level,
				{ own.begin(), own.end() } };
		}
	}
	return tiles;
}

// Checks that all tiles are drawn as if there were all levels, with meshes that have as many segments, and enough blades. Returns the
// levels.
LevelSet check_same(const CullField &p_field, const FieldView &p_view, const TileCover *p_cover = nullptr) {
	const LevelSet found = find_levels(p_field, p_view, p_cover != nullptr ? p_cover->get_extremes() : TileCover::FULL);
	const Tiles all = choose(p_field, p_view, p_cover, ALL_LEVELS), some = choose(p_field, p_view, p_cover, found);
	bool are_same = all.size() == some.size(), have_levels = true;
	for (const auto &[place, drawn] : all) {
		const auto same = some.find(place);
		if (same == some.end()) {
			are_same = false;
			continue;
		}
		const LodLevel mesh = get_lod_level(same->second.level), exact = get_lod_level(drawn.level);
		are_same = are_same && same->second.numbers == drawn.numbers && mesh.segments == exact.segments && mesh.blades >= exact.blades;
		have_levels = have_levels && (found >> same->second.level & 1) != 0;
	}
	CHECK(are_same);
	CHECK(have_levels);
	return found;
}

} // namespace

TEST_CASE("levels of a field: its tiles are drawn as if it had all of them, from anywhere") {
	Random random{ std::mt19937(5) };
	for (int i = 0; i < 400; i++) {
		check_same(make_field(random.coin() ? 8.0 : 24.0, random(0.1f, 1.2f)), random_view(random, 1 + i % 3));
	}
}

TEST_CASE("levels of a field: the same on hills, mown, and thin") {
	Random random{ std::mt19937(6) };
	CullField field = make_field(24.0, float(tallest()));
	field.grid = HILL_GRID;
	PaintMap map = paint_varied();
	paint(map, MapTool::CUT, 0.05, disc(4.0, 3.0, 5.0));
	MapLayers layers({ HILL_GRID, tallest(), 0.0f });
	layers.update(map, layers.get_region());
	for (int i = 0; i < 60; i++) {
		check_same(field, random_view(random, 1 + i % 2), layers.get_cover().get());
	}
}

TEST_CASE("levels of a field: a far lawn has few, and none beyond the distance of shadows") {
	const CullField field = make_field(16.0);
	FieldView view;
	view.cameras = { make_camera({ 0.0f, 1.7f, 60.0f }, Eigen::Vector3f::Zero()) };
	view.shadow_distance = 40.0f;
	const LevelSet levels = check_same(field, view);
	CHECK(std::popcount(levels) >= 1);
	CHECK(std::popcount(levels) <= 3);
	CHECK((levels & CASTING_LEVELS) == 0);
	view.shadow_distance = 60.0f;
	CHECK((check_same(field, view) & CASTING_LEVELS) != 0);
	view.cameras = { make_camera({ 0.0f, 1.7f, 60.0f }, Eigen::Vector3f(0.0f, 1.7f, 90.0f)) };
	CHECK((check_same(field, view) & CASTING_LEVELS) == 0); // nothing casts into a view that looks away
	CHECK((find_levels(field, view) & PICTURE_LEVELS) == (levels & PICTURE_LEVELS)); // but the camera may turn
	CHECK(find_levels(field, FieldView()) == 0);
	CHECK(find_levels(field, view, TileCover::Tile()) == 0); // bare
}

TEST_CASE("surfaces: those that are needed, kept while there are few more, and all of them where many are needed") {
	const LevelSet few = 0b1110000, one_less = 0b0110000, other = 0b0011000, half = 0b0010000;
	CHECK(find_surfaces(0, few, PICTURE_LEVELS) == few);
	CHECK(find_surfaces(few, one_less, PICTURE_LEVELS) == few);
	CHECK(find_surfaces(few, half, PICTURE_LEVELS) == half);
	CHECK(find_surfaces(few, other, PICTURE_LEVELS) == other);
	CHECK(find_surfaces(few, 0, PICTURE_LEVELS) == few);
	CHECK(find_surfaces(few | CASTING_LEVELS, few, PICTURE_LEVELS) == few);
	CHECK(find_surfaces(few, PICTURE_LEVELS >> 10, PICTURE_LEVELS) == PICTURE_LEVELS);
	CHECK(find_surfaces(PICTURE_LEVELS, PICTURE_LEVELS >> 10, PICTURE_LEVELS) == PICTURE_LEVELS);
}
