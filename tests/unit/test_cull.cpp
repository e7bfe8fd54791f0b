// SPDX-License-Identifier: MIT
// The rules of shaders/lod/cull.glsl, on the CPU's twin.
#include "core/lod/cull.h"

#include "core/base/hash.h"
#include "core/map/map_layers.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

using namespace grass;

namespace {

const TileCull::SlotOf ALL_ASLEEP = [](int) { return GRASS_NO_SLOT; };

// 20 m a side, tiles of 1 m.
CullField make_field(uint32_t p_room = 1024) {
	return { TileGrid::make(20.0, 20.0, 64.0), 0.25f, 0.5f, { 0.01f, 0.5f }, 7, { p_room, p_room } };
}

// In the middle of the field, 1 m above it, looking along -z: 90 degrees high and wide.
ViewCamera make_camera(const Eigen::Vector3f &p_eye = { 0.0f, 1.0f, 0.0f }) {
	const float s = std::sqrt(0.5f);
	const Eigen::Vector3f normals[] = { { 0, 0, 1 }, { 0, 0, -1 }, { s, 0, s }, { -s, 0, s }, { 0, s, s }, { 0, -s, s } };
	const float distances[] = { -0.05f, 100.0f, 0, 0, 0, 0 };
	ViewCamera camera;
	for (size_t i = 0; i < 6; i++) {
		camera.planes[i] << normals[i], normals[i].dot(p_eye) + distances[i];
	}
	camera.eye = p_eye;
	camera.pixel_slope = 0.002f;
	return camera;
}

FieldView make_view() {
	FieldView view;
	view.cameras = { make_camera() };
	return view;
}

using Tiles = std::map<std::pair<int, int>, std::vector<float>>; // an instance by column and row

// In the picture, or in shadows.
Tiles tiles_of(const TileCull &p_cull, bool p_shadows) {
	Tiles tiles;
	for (int level = p_shadows ? GRASS_LOD_LEVELS : 0; level < (p_shadows ? GRASS_ALL_LEVELS : GRASS_LOD_LEVELS); level++) {
		const std::span<const float> all = p_cull.get_instances(level);
		for (size_t at = 0; at < all.size(); at += GRASS_INSTANCE_FLOATS) {
			const auto own = all.subspan(at, GRASS_INSTANCE_FLOATS);
			const bool is_new =
					tiles.insert({ { int(own[INSTANCE_TILE]), int(own[INSTANCE_TILE + 1]) }, { own.begin(), own.end() } }).second;
			CHECK(is_new); // no tile twice
		}
	}
	return tiles;
}

Tiles choose(const CullField &p_field, const FieldView &p_view, bool p_shadows = false, const TileCover *p_cover = nullptr) {
	TileCull cull;
	cull.choose(p_field, p_view, p_cover, ALL_ASLEEP);
	return tiles_of(cull, p_shadows);
}

} // namespace

TEST_CASE("cull: the tiles in the view are drawn, those behind it are not, and fewer blades of far ones") {
	const CullField field = make_field();
	const Tiles tiles = choose(field, make_view());
	CHECK(tiles.contains({ 10, 5 }));
	CHECK_FALSE(tiles.contains({ 10, 15 })); // behind the eye
	CHECK_FALSE(tiles.contains({ 0, 9 })); // beside the view
	CHECK(tiles.at({ 10, 8 })[INSTANCE_BLADES] > tiles.at({ 10, 0 })[INSTANCE_BLADES]);
}

TEST_CASE("cull: an instance holds the tile's place, start, slot and hash as cull.glsl packs them, and a transform that changes nothing") {
	const CullField field = make_field();
	TileCull cull;
	const int tile = field.grid.get_index(10, 5), slot = 3 * GRASS_SLOT_HALF + 5;
	cull.choose(field, make_view(), nullptr, [&](int p_tile) { return p_tile == tile ? slot : GRASS_NO_SLOT; });
	const Tiles tiles = tiles_of(cull, false);
	const std::vector<float> &awake = tiles.at({ 10, 5 }), &asleep = tiles.at({ 10, 4 });
	CHECK(awake[3] == 0.0f);
	CHECK(awake[7] == 0.0f);
	CHECK(awake[11] == 0.0f);
	CHECK(awake[16] == float(grass_tile_start(10, 5, 7) / GRASS_START_STRIDE));
	CHECK(awake[17] == 5.0f);
	CHECK(awake[18] == grass_tile_hash(10, 5, 7));
	const auto covering_of = [](const std::vector<float> &p_tile) {
		return (p_tile[19] - std::floor(p_tile[19])) / GRASS_COVERING_SCALE * GRASS_BLADES_PER_TILE;
	};
	CHECK(std::floor(awake[19]) == 3.0f);
	CHECK(covering_of(awake) == doctest::Approx(awake[INSTANCE_BLADES])); // so near that nothing hides them
	CHECK(asleep[17] == float(GRASS_NO_SLOT));
	CHECK(std::floor(asleep[19]) == 0.0f);
	CHECK(covering_of(asleep) == doctest::Approx(asleep[INSTANCE_BLADES]));
}

TEST_CASE("cull: of several cameras the one that needs most of a tile counts, and all of their tiles are drawn") {
	const CullField field = make_field();
	FieldView near = make_view(), far = make_view(), both = make_view();
	near.cameras = { make_camera({ 0.0f, 1.0f, -2.0f }) };
	far.cameras = { make_camera({ 0.0f, 1.0f, 9.0f }) };
	both.cameras = { far.cameras[0], near.cameras[0] };
	const Tiles of_near = choose(field, near), of_far = choose(field, far), of_both = choose(field, both);
	CHECK(of_far.size() > of_near.size());
	CHECK(of_both.size() == of_far.size()); // what the near one sees, the far one does, too
	CHECK(of_both.at({ 10, 5 }) == of_near.at({ 10, 5 }));
	CHECK(of_both.at({ 10, 5 })[INSTANCE_BLADES] > of_far.at({ 10, 5 })[INSTANCE_BLADES]);
	CHECK(choose(field, FieldView()).empty());
}

TEST_CASE("cull: from a low eye far tiles show fewer blades, or none, as wide as before; from above they show all of them") {
	CullField field = make_field(1 << 20);
	field.grid = TileGrid::make(200.0, 200.0, 64.0);
	FieldView low = make_view(), high = make_view();
	low.cameras = { make_camera({ 0.0f, 1.2f, 99.0f }) };
	low.lod.pixels_min = 0.5f;
	const Tiles seen = choose(field, low);
	CHECK(seen.at({ 100, 197 })[INSTANCE_BLADES] > 60.0f); // two metres away
	double blades = 0.0, covering = 0.0;
	for (int x = 50; x < 150; x++) {
		for (int z = 110; z < 150; z++) {
			const auto tile = seen.find({ x, z });
			if (tile != seen.end()) {
				blades += double(tile->second[INSTANCE_BLADES]);
				covering += double(tile->second[19]) / GRASS_COVERING_SCALE * GRASS_BLADES_PER_TILE;
			}
		}
	}
	CHECK(blades < 0.5 * covering);
	CHECK(blades > 0.05 * covering);
	high.cameras = { make_camera({ 0.0f, 80.0f, 99.0f }) };
	high.lod.pixels_min = 0.5f;
	for (const auto &[place, tile] : choose(field, high)) {
		REQUIRE(tile[19] / GRASS_COVERING_SCALE * GRASS_BLADES_PER_TILE == doctest::Approx(tile[INSTANCE_BLADES]));
	}
}

TEST_CASE("cull: an orthogonal camera needs as many blades near as far") {
	FieldView view = make_view();
	view.cameras[0].pixel_slope = 0.0f;
	view.cameras[0].pixel = 0.001f;
	view.lod.pixels_min = 0.0f;
	for (const auto &[place, tile] : choose(make_field(), view)) {
		CHECK(tile[INSTANCE_BLADES] == float(GRASS_BLADES_PER_TILE));
	}
}

TEST_CASE("cull: tiles cast shadows within the shadow distance, from outside of the view as far as margin and fall say") {
	const CullField field = make_field();
	FieldView view = make_view();
	CHECK(choose(field, view, true).empty()); // distance 0
	view.shadow_distance = 6.0f;
	const Tiles seen = choose(field, view), casting = choose(field, view, true);
	CHECK(casting.contains({ 10, 5 }));
	CHECK_FALSE(casting.contains({ 10, 0 })); // beyond the distance
	for (const auto &[place, tile] : casting) {
		CHECK(seen.contains(place));
	}
	CHECK_FALSE(casting.contains({ 10, 12 })); // behind the eye
	view.shadow_margin = 3.0f;
	CHECK(choose(field, view, true).contains({ 10, 12 }));
	view.shadow_margin = 0.0f;
	view.falls = { { 0.0f, 0.0f, -4.0f } }; // the sun stands behind the eye
	CHECK(choose(field, view, true).contains({ 10, 12 }));
	view.falls = { { 0.0f, 0.0f, 4.0f } };
	CHECK_FALSE(choose(field, view, true).contains({ 10, 12 }));
}

TEST_CASE("cull: bare tiles are neither drawn nor cast shadows") {
	const CullField field = make_field();
	TileCover cover;
	cover.reset(field.grid);
	FieldView view = make_view();
	view.shadow_distance = 6.0f;
	CHECK(choose(field, view, false, &cover).empty());
	CHECK(choose(field, view, true, &cover).empty());
}

TEST_CASE("cull: where room is short the same tiles are left out in every frame, as many as it takes, and the others keep their blades") {
	const FieldView view = make_view();
	TileCull cull;
	cull.choose(make_field(), view, nullptr, ALL_ASLEEP);
	const Tiles all = tiles_of(cull, false);
	CHECK(cull.get_left_out() == std::array<int64_t, 2>{ 0, 0 });
	const uint32_t room = uint32_t(all.size()) - 30;
	cull.choose(make_field(room), view, nullptr, ALL_ASLEEP);
	const Tiles kept = tiles_of(cull, false);
	CHECK(kept.size() <= room);
	CHECK(kept.size() > room / 2);
	CHECK(cull.get_left_out()[0] == int64_t(all.size() - kept.size()));
	for (const auto &[place, tile] : kept) {
		CHECK(all.at(place)[INSTANCE_BLADES] == tile[INSTANCE_BLADES]);
	}
	cull.choose(make_field(room), view, nullptr, ALL_ASLEEP);
	CHECK(tiles_of(cull, false) == kept); // the same ones in every frame
}

TEST_CASE("cull: it counts the blades that it draws") {
	FieldView view = make_view();
	view.shadow_distance = 6.0f;
	TileCull cull;
	cull.choose(make_field(), view, nullptr, ALL_ASLEEP);
	for (const bool shadows : { false, true }) {
		int64_t blades = 0;
		for (const auto &[place, tile] : tiles_of(cull, shadows)) {
			blades += int64_t(std::ceil(tile[INSTANCE_BLADES]));
		}
		CHECK(blades > 0);
		CHECK(cull.get_blades()[shadows ? 1 : 0] == blades);
	}
}
