// SPDX-License-Identifier: MIT
// A terrain that is read into a map: heights, holes, textures; what waits, and in which order.
#include "core/fill/terrain_piece.h"
#include "fill_scene.h"

#include "core/fill/fill_cause.h"
#include "core/fill/live_fill.h"
#include "core/map/map_layers.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

using namespace grass;
using namespace grass::test;

namespace {

using SampleAt = std::function<TerrainSample(const Eigen::Vector2d &)>;

TerrainPiece read(const MapRegion &p_region, const SampleAt &p_sample) {
	TerrainPiece piece(p_region);
	while (!piece.is_complete()) {
		std::vector<TerrainSample> samples;
		for (const Eigen::Vector2d &place : piece.get_next()) {
			samples.push_back(p_sample(place));
		}
		piece.put_next(samples);
	}
	return piece;
}

TerrainSample of_height(double p_height) {
	TerrainSample sample;
	sample.height = p_height;
	return sample;
}

int32_t hole_at(const PaintMap &p_map, int p_i, int p_j) {
	return p_map.get_code(MAP_HOLE, 0, p_i, p_j);
}

} // namespace

TEST_CASE("terrain_piece: returns a region's texels and those around, row by row, and lays heights and slopes") {
	TerrainPiece piece({ { 0.0, 0.0 }, { 8.0, 4.0 } });
	const std::vector<Eigen::Vector2d> row = piece.get_next();
	CHECK(row.size() == 10);
	CHECK(row.front() == Eigen::Vector2d(-0.5, -0.5));
	CHECK(row.back() == Eigen::Vector2d(8.5, -0.5));
	int rows = 0;
	const TerrainPiece slope = read({ { 0.0, 0.0 }, { 8.0, 4.0 } }, [&](const Eigen::Vector2d &p_place) {
		rows += p_place.x() < 0.0 ? 1 : 0;
		return of_height(0.5 * p_place.x());
	});
	CHECK(rows == 6);
	PaintMap map;
	CHECK(slope.lay(map).missing == 0);
	CHECK(map.sample(MAP_GROUND, 0, { 2.5, 1.5 }) == doctest::Approx(1.25));
	CHECK(map.sample(MAP_NORMAL, 0, { 0.5, 0.5 }) == doctest::Approx(-0.5 / std::sqrt(1.25)).epsilon(0.01));
	CHECK(map.get_code(MAP_GROUND, 0, 8, 0) == 0); // around the region nothing is laid
}

TEST_CASE("terrain_piece: a row may be read in parts, and no part reaches into the next row") {
	TerrainPiece piece({ { 0.0, 0.0 }, { 8.0, 4.0 } });
	const auto read_next = [&piece] {
		const std::vector<Eigen::Vector2d> places = piece.get_next(4);
		piece.put_next(std::vector<TerrainSample>(places.size()));
		return places;
	};
	CHECK(read_next().size() == 4);
	CHECK(read_next().front() == Eigen::Vector2d(3.5, -0.5));
	CHECK(read_next().size() == 2);
	CHECK(read_next().front() == Eigen::Vector2d(-0.5, 0.5));
	int parts = 4;
	for (; !piece.is_complete(); parts++) {
		read_next();
	}
	CHECK(parts == 18);
}

TEST_CASE("terrain_piece: a region without a texel's centre is complete at once") {
	TerrainPiece piece({ { 0.6, 0.6 }, { 0.9, 5.0 } });
	CHECK(piece.is_complete());
	PaintMap map;
	CHECK(piece.lay(map).changed.empty());
}

TEST_CASE("terrain_piece: a normal that the terrain tells is laid as it is; none, null or pointing down is not") {
	const auto lay_with = [](const Eigen::Vector3d &p_normal) {
		PaintMap map;
		read({ { 0.0, 0.0 }, { 4.0, 4.0 } }, [&](const Eigen::Vector2d &) {
			TerrainSample sample = of_height(1.0);
			sample.normal = p_normal;
			return sample;
		}).lay(map);
		return map.get_code(MAP_NORMAL, 0, 1, 1);
	};
	CHECK(lay_with({ 3.0, 4.0, 0.0 }) == info_of(MAP_NORMAL).code(0.6));
	CHECK(lay_with(Eigen::Vector3d::Zero()) == info_of(MAP_NORMAL).code(0.0));
	CHECK(lay_with({ 0.6, NAN_VALUE, 0.0 }) == info_of(MAP_NORMAL).code(0.0));
	CHECK(lay_with({ 0.6, -0.8, 0.0 }) == info_of(MAP_NORMAL).code(0.0));
}

TEST_CASE("holes: nothing grows in them, whatever is painted, until the terrain has ground there") {
	PaintMap map;
	map.set_base_density(1.0);
	const MapRegion region{ { -8.0, -8.0 }, { 8.0, 8.0 } };
	const auto with_hole = [](const Eigen::Vector2d &p_place) { return of_height(p_place.x() > 2.0 ? NAN_VALUE : 1.0); };
	const LaidGround laid = read(region, with_hole).lay(map);
	CHECK(laid.missing == 6 * 16);
	CHECK(hole_at(map, 1, 0) == 0);
	CHECK(hole_at(map, 2, 0) == 1);
	CHECK(map.get_code(MAP_GROUND, 0, 2, 0) == info_of(MAP_GROUND).code(1.0)); // blades at its rim stay on the ground
	CHECK(map.get_code(MAP_GROUND, 0, 3, 0) == info_of(MAP_GROUND).code(0.0));
	CHECK_FALSE(laid.changed.empty());
	CHECK(read(region, with_hole).lay(map).changed.empty());
	MapLayers layers({ TileGrid::make(16, 16, 100.0) });
	layers.update(map, region);
	CHECK(layers.sample({ 5.0f, 0.0f }).density == 0.0f);
	CHECK(layers.sample({ -5.0f, 0.0f }).density == 1.0f);
	// Ground that is not known leaves holes as they are; a height closes them.
	lay_ground(map, region, [](const Eigen::Vector2d &) { return NAN_VALUE; });
	CHECK(hole_at(map, 5, 0) == 1);
	CHECK_FALSE(lay_ground(map, region, [](const Eigen::Vector2d &) { return 1.0; }).changed.empty());
	CHECK(hole_at(map, 5, 0) == 0);
	layers.update(map, region);
	CHECK(layers.sample({ 5.0f, 0.0f }).density == 1.0f);
}

TEST_CASE("terrain_ids: what has been read is known, and a change is told once") {
	TerrainIds ids;
	CHECK(ids.find({ 0.5, 0.5 }) == nullptr);
	CHECK(ids.set(0, 0, TerrainTexel::of(3, 0, 0)));
	CHECK_FALSE(ids.set(0, 0, TerrainTexel::of(3, 0, 0)));
	CHECK(ids.set(0, 0, TerrainTexel::of(4, 0, 0)));
	CHECK(ids.set(-1, -1, TerrainTexel::of(0, 0, 0))); // known now
	CHECK(ids.find({ 0.5, 0.5 })->base == 4);
	CHECK(ids.find({ -0.5, -0.5 })->base == 0);
	CHECK(ids.find({ 1.5, 0.5 }) == nullptr);
	CHECK(ids.find({ NAN_VALUE, 0.5 }) == nullptr);
	CHECK(TerrainTexel::of(NAN_VALUE, -4.0, 2.0) == TerrainTexel{ 0, 0, 255 });
}

TEST_CASE("fill_rule: grass grows on the textures that it names, by as much as they show") {
	FillRule rule;
	const TerrainTexel half = TerrainTexel::of(1, 2, 0.4);
	CHECK(rule.texture_share(nullptr) == 1.0); // all textures
	rule.texture_ids = { 1 };
	CHECK(rule.texture_share(&half) == doctest::Approx(0.6));
	CHECK(rule.texture_share(nullptr) == 0.0);
	rule.texture_ids = { 2, 5 };
	CHECK(rule.texture_share(&half) == doctest::Approx(0.4));
	rule.texture_ids = { 1, 2 };
	CHECK(rule.texture_share(&half) == doctest::Approx(1.0));
	rule.texture_ids = { 7 };
	CHECK(rule.texture_share(&half) == 0.0);
}

TEST_CASE("fill: textures count only where a terrain tells them, and are named as the cause") {
	auto ids = std::make_shared<TerrainIds>();
	for (int j = -64; j < 64; j++) {
		for (int i = -64; i < 64; i++) {
			ids->set(i, j, TerrainTexel::of(i < 0 ? 1 : 2, 0, 0));
		}
	}
	FillRule rule;
	rule.texture_ids = { 1 };
	FillSources sources;
	CHECK(filled(rule, sources) == doctest::Approx(128.0 * 128.0)); // no terrain
	sources.terrain = ids;
	PaintMap map;
	CHECK(fill_all(map, rule, sources).amount == doctest::Approx(64.0 * 128.0));
	CHECK(density_at(map, -10.0, 0.0) == 1.0);
	CHECK(density_at(map, 10.0, 0.0) == 0.0);
	const FillCause cause = find_fill_cause(map, rule, sources, { 10.0, 0.0 });
	CHECK(cause.condition == FillCondition::TEXTURE);
	CHECK(cause.value == 2.0);
	CHECK(cause.density == 0.0);
	sources.terrain = std::make_shared<TerrainIds>();
	CHECK(find_fill_cause(map, rule, sources, { 10.0, 0.0 }).value == -1.0);
}

TEST_CASE("live_fill: new textures fill again where they are, and only for a rule that asks for them") {
	PaintMap map;
	LiveFill live;
	FillRule rule;
	FillSources sources;
	auto ids = std::make_shared<TerrainIds>();
	sources.terrain = ids;
	const auto refill = [&] {
		live.set(rule, sources, AREA);
		return live.work(map, -1).cells;
	};
	constexpr int64_t CHUNK = 128 * 128;
	CHECK(refill() == 4 * CHUNK);
	live.touch_textures({ { 1.0, 1.0 }, { 5.0, 5.0 } });
	CHECK(refill() == 0);
	rule.texture_ids = { 1 };
	CHECK(refill() == 4 * CHUNK);
	CHECK(density_at(map, 3.0, 3.0) == 0.0);
	ids->set(3, 3, TerrainTexel::of(1, 0, 0));
	live.touch_textures({ { 1.0, 1.0 }, { 5.0, 5.0 } });
	CHECK(refill() == CHUNK);
	CHECK(density_at(map, 3.5, 3.5) == 1.0);
	sources.terrain = nullptr; // another terrain, or none
	CHECK(refill() == 4 * CHUNK);
}

TEST_CASE("terrain_queue: what waits comes once, joined by chunk, the nearest to an eye first") {
	TerrainQueue queue;
	queue.set_area(AREA);
	queue.add({ { 70.0, 0.0 }, { 80.0, 5.0 } });
	CHECK(queue.get_waiting() == 0); // outside
	queue.add({ { NAN_VALUE, 0.0 }, { 80.0, 5.0 } });
	CHECK(queue.get_waiting() == 0);
	queue.add_all();
	CHECK(queue.get_waiting() == 4);
	const std::vector<Eigen::Vector2d> eyes = { { 500.0, -500.0 }, { -20.0, 30.0 } };
	CHECK(*queue.take(eyes) == MapRegion{ { -64.0, 0.0 }, { 0.0, 64.0 } });
	queue.add({ { -30.0, 10.0 }, { -28.0, 12.0 } });
	queue.add({ { -10.0, 20.0 }, { -8.0, 22.0 } });
	CHECK(queue.get_waiting() == 4);
	CHECK(*queue.take(eyes) == MapRegion{ { -30.0, 10.0 }, { -8.0, 22.0 } });
	int left = 0;
	while (queue.take({})) {
		left++;
	}
	CHECK(left == 3);
}

TEST_CASE("terrain_queue: pieces of all chunks lay what one piece of the whole area lays") {
	const auto hill = [](const Eigen::Vector2d &p_place) {
		return of_height(p_place.norm() < 9.0 ? NAN_VALUE : 3.0 * std::sin(0.1 * p_place.x()) + 0.2 * p_place.y());
	};
	PaintMap whole, parts;
	read(AREA, hill).lay(whole);
	TerrainQueue queue;
	queue.set_area(AREA);
	queue.add_all();
	while (const auto region = queue.take({})) {
		read(*region, hill).lay(parts);
	}
	CHECK(whole.compare(parts).empty());
}
