// SPDX-License-Identifier: MIT
// An awake tile on a map that changes: its blades grow as the map says.
#include "hill_map.h"

#include "core/solver/simulate.h"
#include "core/species/field_blades.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

namespace {

// An awake tile on a slope that is grown over.
struct SlopeTile {
	PaintMap map;
	MapLayers layers{ MapPlace{ HILL_GRID, tallest(), 1.0f } };
	CpuPool pool{ shared_patch(), 4 };
	GrassSlot slot = fresh_slot(HILL_GRID, 50, 30);
	StepInput input;

	SlopeTile() {
		map.set_base_density(1.0);
		lay_slope(map);
		layers.update(map, layers.get_region());
		input.step.field = { float(HILL_GRID.get_tile_size()), float(HILL_GRID.get_tiles_x()), float(HILL_GRID.get_tiles_z()),
			float(GRASS_KNOTS) };
		input.slots = { &slot, 1 };
	}
	FieldBlades get_blades() const { return FieldBlades(HILL_GRID, shared_patch(), ClumpParams(), 0, nullptr, &layers); }
	void cut_to_10_cm() {
		paint(map, MapTool::CUT, 0.1, disc(5.0, -5.0, 6.0));
		layers.update(map, layers.get_region());
	}
};

} // namespace

TEST_CASE("map_layers: an awake tile stands as its blades grow, and stands so again when the map changes below it") {
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
	const std::vector<uint16_t> row = check();
	for (size_t i = 0; i < row.size(); i++) {
		CHECK((row[i] == 0 || i == 3)); // at rest, whatever rest is; the fourth number says how many blades are simulated
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

TEST_CASE("map_layers: an awake blade that is cut keeps its shape and its speed, in proportion [Eq M6]") {
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
