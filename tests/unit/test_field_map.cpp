// SPDX-License-Identifier: MIT
#include "core/plants/field_blades.h"

#include "core/base/hash.h"
#include "core/blades/blade.h"
#include "core/paint/brush.h"
#include "core/solver/simulate.h"
#include "core/tiles/tiles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <random>

using namespace grass;

namespace {

const TileGrid GRID = TileGrid::make(40.0, 40.0, 256.0); // 80 x 80 tiles of 0.5 m

std::shared_ptr<const Patch> shared_patch() {
	static const auto patch = std::make_shared<const Patch>(generate_patch(PatchParams()));
	return patch;
}

const double TALLEST = double(shared_patch()->max_length) * CLUMP_TALLEST;

MapShape disc(double p_x, double p_z, double p_radius) {
	return MapShape::stroke({ p_x, p_z }, { p_x, p_z }, p_radius, 1.0, Falloff::LINEAR);
}

BrushResult paint(PaintMap &r_map, MapTool p_tool, double p_target, const MapShape &p_shape) {
	Brush brush;
	brush.tool = p_tool;
	brush.target = p_target;
	return apply_brush(r_map, p_shape, brush);
}

// A hill: 0.5 m up for each metre along x, and half as steep along z.
void lay_slope(PaintMap &r_map) {
	const Eigen::Vector3d normal = Eigen::Vector3d(-0.5, 1.0, -0.25).normalized();
	for (int j = -25; j < 25; j++) {
		for (int i = -25; i < 25; i++) {
			r_map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(0.5 * (i + 0.5) + 0.25 * (j + 0.5)));
			r_map.set_code(MAP_NORMAL, 0, i, j, info_of(MAP_NORMAL).code(normal.x()));
			r_map.set_code(MAP_NORMAL, 1, i, j, info_of(MAP_NORMAL).code(normal.z()));
		}
	}
}

GrassSlot slot_of(int p_x, int p_z, int p_slot = 0) {
	GrassSlot slot;
	slot.tile = { p_x, p_z, GRID.get_index(p_x, p_z), p_slot };
	slot.list = { grass_tile_start(uint32_t(p_x), uint32_t(p_z), 0), 0, 0, GRASS_SLOT_FRESH | GRASS_SLOT_MAPPED };
	return slot;
}

// Of other density, height and ground everywhere.
PaintMap paint_varied() {
	PaintMap map;
	paint(map, MapTool::PAINT, 0.6, disc(1.0, -1.0, 12.0));
	paint(map, MapTool::HEIGHT, 0.5, disc(-3.0, 2.0, 9.0));
	lay_slope(map);
	return map;
}

// An awake tile on a slope that is grown over.
struct SlopeTile {
	PaintMap map;
	FieldMap field{ GRID, TALLEST, 1.0f };
	CpuPool pool{ shared_patch(), 4 };
	GrassSlot slot = slot_of(50, 30);
	StepInput input;

	SlopeTile() {
		map.set_base_density(1.0);
		lay_slope(map);
		field.update(map, field.get_region());
		input.step.field = { float(GRID.get_tile_size()), float(GRID.get_tiles_x()), float(GRID.get_tiles_z()), float(GRASS_KNOTS) };
		input.slots = { &slot, 1 };
	}
	FieldBlades get_blades() const { return FieldBlades(GRID, shared_patch(), ClumpParams(), 0, nullptr, &field); }
	void cut_to_10_cm() {
		paint(map, MapTool::CUT, 0.1, disc(5.0, -5.0, 6.0));
		field.update(map, field.get_region());
	}
};

} // namespace

TEST_CASE("map_layers: a layer sampled by itself says what the map says, over chunk borders, too") {
	const PaintMap map = paint_varied();
	MapLayers layers;
	layers.reset(GRID);
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
	layers.reset(GRID);
	layers.update(map, { { -20, -20 }, { 20, 20 } });
	CHECK(layers.update(map, { { -20, -20 }, { 20, 20 } }).empty());
	const BrushResult result = paint(map, MapTool::ERASE, 0.0, disc(10.0, 10.0, 1.0));
	const std::vector<int> changed = layers.update(map, { result.min, result.max });
	CHECK(changed.size() == 1);
	MapLayers fresh;
	fresh.reset(GRID);
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
	layers.reset(GRID);
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

TEST_CASE("growth: wear presses the grass and thins it out until it is gone [Eq M1]") {
	PaintMap map;
	map.set_base_density(1.0);
	for (const double wear : { 0.2, 0.6, 1.0 }) {
		paint(map, MapTool::FLATTEN, wear, disc(0.0, 0.0, 5.0));
		MapLayers layers;
		layers.reset(GRID);
		layers.update(map, { { -20, -20 }, { 20, 20 } });
		CHECK(layers.sample({ 0.0f, 0.0f }, 0.0f).density == doctest::Approx(1.0 - wear * wear).epsilon(0.01));
		CHECK(layers.sample({ 0.0f, 0.0f }, 0.0f).height == doctest::Approx(1.0 - GRASS_WEAR_PRESSES * wear).epsilon(0.01));
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
	FieldMap field(GRID, TALLEST, 0.0f);
	field.update(map, field.get_region());
	const TileCover &cover = *field.get_cover();
	int bare = 0;
	for (int z = 0; z < 80; z++) {
		for (int x = 0; x < 80; x++) {
			const TileCover::Tile &tile = cover.get(x, z);
			bare += tile.is_bare() ? 1 : 0;
			double most = 0.0;
			for (int n = 0; n < 25; n++) {
				const Eigen::Vector3d at = GRID.get_centre(x, z) + Eigen::Vector3d((n % 5 - 2) * 0.125, 0.0, (n / 5 - 2) * 0.125);
				const Growth here = field.get_layers().sample({ float(at.x()), float(at.z()) }, 0.0f);
				most = std::max(most, double(here.density));
				if (!tile.is_bare()) {
					CHECK(here.ground >= tile.low - 1e-4f);
					CHECK(here.ground <= tile.high + 1e-4f);
				}
			}
			CHECK(tile.is_bare() == (most == 0.0));
		}
	}
	CHECK(bare == cover.get_bare_count());
	CHECK(double(6400 - bare) * 0.25 == doctest::Approx(std::numbers::pi * 36.0).epsilon(0.2)); // and the tiles on the border
	const BrushResult erased = paint(map, MapTool::ERASE, 0.0, disc(5.0, 5.0, 9.0));
	field.update(map, { erased.min, erased.max });
	CHECK(cover.get_bare_count() == 6400);
	CHECK(cover.get_low() == 0.0f);
	CHECK(cover.get_high() == 0.0f);
}

TEST_CASE("field_map: laid out chunk by chunk, with changes in between, it says what it says when laid out at once") {
	PaintMap map;
	paint(map, MapTool::PAINT, 0.6, disc(1.0, -1.0, 18.0));
	lay_slope(map);
	FieldMap field(GRID, TALLEST, 0.25f);
	CHECK(field.get_waiting() == 4);
	CHECK(field.count_painted(map) == 4);
	CHECK(field.work(map).layers == std::vector<int>{ 0 });
	CHECK_FALSE(field.is_waiting_at({ -5.0f, -5.0f }));
	CHECK(field.is_waiting_at({ 5.0f, 5.0f }));
	for (const double x : { -10.0, 0.5, 10.0 }) { // in a chunk that is done, at a border, in one that waits
		const BrushResult result = paint(map, MapTool::ERASE, 0.0, disc(x, -3.0, 2.0));
		field.touch({ result.min, result.max });
	}
	CHECK(field.is_waiting_at({ -5.0f, -5.0f }));
	CHECK_FALSE(field.is_waiting_at({ 1e9f, 0.0f }));
	FieldMap::Changes changes;
	while (field.get_waiting() > 0) {
		changes.add(field.work(map));
	}
	CHECK(changes.tiles == TileRange{ 0, 80, 0, 80 });
	FieldMap fresh(GRID, TALLEST, 0.25f);
	fresh.update(map, fresh.get_region());
	for (int layer = 0; layer < 4; layer++) {
		CHECK(field.get_layers().get_layer(layer).growth == fresh.get_layers().get_layer(layer).growth);
		CHECK(field.get_layers().get_layer(layer).ground == fresh.get_layers().get_layer(layer).ground);
	}
	CHECK(field.get_layers().get_pages() == fresh.get_layers().get_pages());
	CHECK(std::ranges::equal(field.get_cover()->get_tiles(), fresh.get_cover()->get_tiles()));
	CHECK(field.get_cover()->get_bare_count() == fresh.get_cover()->get_bare_count());
	CHECK(field.work(map).tiles.count() == 0);
}

TEST_CASE("map_layers: what is read around one place is what the layers say there") {
	const PaintMap map = paint_varied();
	MapLayers layers;
	layers.reset(GRID);
	const MapLayers empty = layers;
	layers.update(map, { { -20, -20 }, { 20, 20 } });
	std::mt19937 random(1);
	std::uniform_real_distribution<float> place(-25.0f, 25.0f);
	for (int n = 0; n < 200; n++) {
		const Eigen::Vector2f at = n == 0 ? Eigen::Vector2f(0.0f, 0.0f) : Eigen::Vector2f(place(random), place(random));
		const Growth here = empty.read(map, at).sample(at, 0.25f), there = layers.sample(at, 0.25f);
		CHECK(here.density == there.density);
		CHECK(here.height == there.height);
		CHECK(here.cut == there.cut);
		CHECK(here.lean == there.lean);
		CHECK(here.tilt == there.tilt);
		CHECK(here.ground == there.ground);
	}
	CHECK(empty.read(map, { 1e9f, 0.0f }).get_count() == 0);
	CHECK(empty.read(map, { std::nanf(""), 0.0f }).get_count() == 0);
}

TEST_CASE("tile_bounds: bare tiles are never met, others where their ground is") {
	PaintMap map;
	map.set_base_density(1.0);
	lay_slope(map);
	paint(map, MapTool::ERASE, 0.0, disc(-10.0, 0.0, 3.0));
	FieldMap field(GRID, TALLEST, 0.25f);
	field.update(map, field.get_region());
	TileBounds bounds(*shared_patch(), GRID, ClumpParams(), 0);
	bounds.set_cover(field.get_cover(), slope_lean(0.25f) * shared_patch()->max_length);
	const auto meets = [&](double p_x, double p_y, double p_z) {
		const TilePlace place = GRID.get_place({ p_x, 0.0, p_z });
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

TEST_CASE("field_map: an awake tile stands as its blades grow, and stands so again when the map changes below it") {
	SlopeTile tile;
	const FieldBlades blades = tile.get_blades();
	const ClumpParams clump;
	tile.input.step.clump = { clump.size, clump.height, clump.lean, clump.tint };
	const auto check = [&] {
		const SlotGrowth growth = blades.grow(tile.slot);
		tile.input.growth = { &growth, 1 };
		tile.pool.step(tile.input);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const FieldBlades::Pose pose = blades.get_pose(50, 30, b);
			const vec4 &packed = growth.blades[size_t(b)];
			CHECK(packed == vec4{ pose.clump.height, pose.clump.lean.x, pose.clump.lean.y, pose.ground });
		}
		std::vector<uint16_t> row(size_t(GRASS_POOL_BLADES_PER_ROW) * GRASS_KNOTS * 4);
		tile.pool.pack_row(0, row);
		return row;
	};
	for (const uint16_t offset : check()) {
		CHECK(offset == 0); // at rest, whatever rest is
	}
	tile.cut_to_10_cm();
	tile.slot.list.w = GRASS_SLOT_FRESH | GRASS_SLOT_MAPPED;
	check();
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const std::vector<Eigen::Vector3f> knots = tile.pool.get_knots(0, b);
		float length = 0.0f;
		for (int k = 1; k < GRASS_KNOTS; k++) {
			length += (knots[size_t(k)] - knots[size_t(k - 1)]).norm();
		}
		CHECK(length == doctest::Approx(0.1).epsilon(0.02));
	}
}

TEST_CASE("field_map: an awake blade that is cut keeps its shape and its speed, in proportion [Eq M6]") {
	SlopeTile tile;
	const FieldBlades blades = tile.get_blades();
	SlotGrowth growth = blades.grow(tile.slot);
	tile.input.growth = { &growth, 1 };
	tile.pool.step(tile.input);

	constexpr float LEAN = 0.3f; // metres a knot
	std::vector<std::vector<Eigen::Vector3f>> bent;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		std::vector<Eigen::Vector3f> knots = tile.pool.get_knots(0, b);
		const float segment = (knots[3] - knots[2]).norm();
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			knots[size_t(k)] = knots[size_t(k - 1)] + segment * Eigen::Vector3f(LEAN, 1.0f, 0.1f * float(k)).normalized();
		}
		tile.pool.set_knots(0, b, knots, knots);
		bent.push_back(knots);
	}
	tile.cut_to_10_cm();
	tile.slot.list.w = GRASS_SLOT_MAPPED;
	growth = blades.grow(tile.slot);
	tile.pool.step(tile.input); // no time passes
	int cut = 0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const std::vector<Eigen::Vector3f> knots = tile.pool.get_knots(0, b);
		const std::vector<Eigen::Vector3f> &before = bent[size_t(b)];
		const float ratio = (knots[1] - knots[0]).norm() / (before[1] - before[0]).norm();
		cut += ratio < 0.5f ? 1 : 0;
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			CHECK((knots[size_t(k)] - before[size_t(k)] * ratio).norm() < 2e-3f * (before[15]).norm());
		}
	}
	CHECK(cut > 32);
}

TEST_CASE("field_map: tiles wake where bodies touch grass on a hill, and nowhere under it") {
	PaintMap map;
	map.set_base_density(1.0);
	lay_slope(map);
	FieldMap field(GRID, TALLEST, 0.25f);
	field.update(map, field.get_region());
	auto bounds = std::make_shared<TileBounds>(*shared_patch(), GRID, ClumpParams(), 0);
	bounds->set_cover(field.get_cover(), slope_lean(0.25f) * shared_patch()->max_length);
	TileManager tiles;
	tiles.set_grid(GRID);
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
