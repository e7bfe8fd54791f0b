// SPDX-License-Identifier: MIT
// Ground with edges: blades are counted against the ground that was read.
#include "core/field/bare_cause.h"
#include "core/map/map_layers.h"
#include "core/paint/lay_ground.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace grass;

namespace {

constexpr double NO_GROUND = std::numeric_limits<double>::quiet_NaN();

// A box that is turned by p_turn around its middle; height: of its top, above ground that rises by p_rise towards the box's x.
struct Block {
	Eigen::Vector2d middle, half;
	double turn, height, rise = 0.0;
	bool holds(const Eigen::Vector2d &p_place) const { return (local(p_place).array().abs() <= half.array()).all(); }
	Eigen::Vector2d local(const Eigen::Vector2d &p_place) const { return Eigen::Rotation2Dd(-turn) * (p_place - middle); }
	double at(const Eigen::Vector2d &p_place) const { return height + rise * local(p_place).x(); }
};

double highest(const std::vector<Block> &p_blocks, const Eigen::Vector2d &p_place, double p_floor) {
	double height = p_floor;
	for (const Block &block : p_blocks) {
		height = block.holds(p_place) ? std::fmax(height, block.at(p_place)) : height;
	}
	return height;
}

struct Count {
	int blades = 0, off = 0, bare = 0, differs = 0;
};

// Places at random, as blades of a field have them, against the ground.
Count count_off(const PaintMap &p_map, const HeightAt &p_ground, double p_half) {
	const TileGrid grid = TileGrid::make(2.0 * p_half, 2.0 * p_half, 256.0);
	MapLayers field({ grid, 0.5, 0.25f });
	field.update(p_map, field.get_region());
	std::mt19937 random(7);
	std::uniform_real_distribution<double> along(-p_half, p_half);
	Count count;
	for (int n = 0; n < 50000; n++) {
		const Eigen::Vector2d place = Eigen::Vector2d(along(random), along(random)).cast<float>().cast<double>();
		const double ground = p_ground(place);
		if (!std::isfinite(ground)) {
			continue;
		}
		const Growth here = field.sample(place.cast<float>());
		count.blades++;
		count.bare += here.density == 0.0f ? 1 : 0;
		count.off += here.density > 0.0f && std::abs(double(here.ground) - ground) > 0.03 ? 1 : 0;
		if (here.density > 0.0f) { // queries say the same as the picture
			count.differs += std::abs(p_map.sample(MAP_GROUND, 0, place) - double(here.ground)) > 1e-3 ? 1 : 0;
		}
	}
	CHECK(count.differs == 0);
	return count;
}

void lay(PaintMap &r_map, double p_half, const HeightAt &p_ground) {
	r_map.set_base_density(1.0);
	lay_ground(r_map, { { -p_half - 1, -p_half - 1 }, { p_half + 1, p_half + 1 } }, p_ground, MissingGround::STAYS, nullptr, { p_ground });
}

} // namespace

TEST_CASE("ledges: blocks, walls and kerbs, at any offset and turned anyhow: no blade hangs or is buried") {
	std::mt19937 random(3);
	std::uniform_real_distribution<double> any(0.0, 1.0);
	for (int scene = 0; scene < 12; scene++) {
		std::vector<Block> blocks;
		for (int n = 0; n < 8; n++) {
			const double turn = scene % 3 == 0 ? 0.0 : any(random) * 3.0;
			const Eigen::Vector2d middle(-14.0 + 28.0 * any(random), -14.0 + 28.0 * any(random));
			blocks.push_back({ middle, { 0.7 + 2.0 * any(random), 0.7 + 2.0 * any(random) }, turn, 0.1 + 2.4 * any(random) });
		}
		blocks.push_back({ { any(random), any(random) }, { 0.15, 6.0 }, scene % 2 * any(random), 2.5 }); // a thin wall
		blocks.push_back({ { 9.0 + any(random), any(random) }, { 0.4, 8.0 }, 0.0, 0.08 }); // a kerb
		const auto ground = [&](const Eigen::Vector2d &p_place) { return highest(blocks, p_place, 0.0); };
		PaintMap map;
		lay(map, 16.0, ground);
		const Count count = count_off(map, ground, 16.0);
		CAPTURE(scene);
		CAPTURE(count.bare);
		CHECK(count.off < count.blades / 1000);
		CHECK(count.bare < count.blades / 16); // a strip along the edges
	}
}

TEST_CASE("ledges: stairs, a sloping roof, a cliff in hills, a gap, and a floor that ends") {
	struct Case {
		const char *name;
		HeightAt ground;
	};
	const auto hills = [](const Eigen::Vector2d &p_at) { return 0.8 * std::sin(0.3 * p_at.x()) + 0.5 * std::cos(0.23 * p_at.y() + 1.0); };
	for (double offset = 0.0; offset < 1.0; offset += 0.17) {
		const Case cases[] = {
			{ "stairs",
					[offset](
							const Eigen::Vector2d &p_at) { return 0.2 * std::floor(std::clamp((p_at.x() + offset) / 0.3, -20.0, 20.0)); } },
			{ "terraces", [offset](const Eigen::Vector2d &p_at) { return 0.4 * std::floor((p_at.x() + 0.3 * p_at.y() + offset) / 2.5); } },
			{ "roof",
					[offset](const Eigen::Vector2d &p_at) {
						const std::vector<Block> roof{ { { offset, 1.0 }, { 4.0, 3.0 }, offset, 3.0, 0.5 } };
						return highest(roof, p_at, 0.0);
					} },
			{ "cliff",
					[&hills, offset](const Eigen::Vector2d &p_at) {
						const double edge = offset + 0.7 * p_at.y() + std::sin(0.5 * p_at.y());
						return hills(p_at) + (p_at.x() > edge ? 4.0 : 0.0);
					} },
			{ "gap",
					[offset](const Eigen::Vector2d &p_at) {
						return std::abs(p_at.x() + 0.4 * p_at.y() - offset) < 0.3 ? -3.0 : 0.3 * p_at.y();
					} },
			{ "end", [offset](const Eigen::Vector2d &p_at) { return p_at.norm() < 6.0 + offset ? 1.5 : NO_GROUND; } },
		};
		for (const Case &here : cases) {
			CAPTURE(here.name);
			CAPTURE(offset);
			PaintMap map;
			lay(map, 8.0, here.ground);
			const Count count = count_off(map, here.ground, 8.0);
			CHECK(count.off < count.blades / 1000);
		}
	}
}

TEST_CASE("ledges: smooth and rough ground has none, and the heights are asked a few times a metre") {
	const HeightAt grounds[] = { [](const Eigen::Vector2d &p_at) { return 3.0 * std::sin(0.5 * p_at.x()) * std::cos(0.4 * p_at.y()); },
		[](const Eigen::Vector2d &p_at) { return 1.7 * p_at.x(); },
		[](const Eigen::Vector2d &p_at) { return 0.1 * std::sin(5.0 * p_at.x()) * std::sin(6.0 * p_at.y()); } };
	for (const HeightAt &ground : grounds) {
		PaintMap map;
		const LaidGround laid = lay_ground(map, { { -16, -16 }, { 16, 16 } }, ground, MissingGround::STAYS, nullptr, { ground });
		CHECK_FALSE(map.uses(MAP_LEDGE));
		CHECK(laid.sampled >= 34 * 34);
	}
	PaintMap map;
	const auto level = [](const Eigen::Vector2d &) { return 2.0; };
	const LaidGround laid = lay_ground(map, { { -16, -16 }, { 16, 16 } }, level, MissingGround::STAYS, nullptr, { level });
	constexpr int BESIDE = 4 * 33 * 4 + 4 * 6; // cells from which a ledge may be followed into one of 33 x 33
	CHECK(laid.sampled == 42 * 42 + 4 * (33 * 33 + BESIDE));
	CHECK_FALSE(map.uses(MAP_LEDGE));
}

TEST_CASE("ledges: a terrain that ends with its field has none at its border, where grass stands on it as elsewhere") {
	constexpr double HALF = 8.0;
	const MapRegion field{ { -HALF, -HALF }, { HALF, HALF } };
	const HeightAt terrain = [&](const Eigen::Vector2d &p_at) {
		return field.contains(p_at) ? 0.4 * p_at.x() + 0.3 * std::sin(0.5 * p_at.y()) : NO_GROUND;
	};
	const HeightAt floor = [&](const Eigen::Vector2d &p_at) { return p_at.x() < 5.0 ? terrain(p_at) : NO_GROUND; }; // ends within it
	for (const HeightAt &ground : { terrain, floor }) {
		const HeightAt continued = [&](const Eigen::Vector2d &p_at) { return continued_ground(ground(p_at), ground, field, p_at); };
		PaintMap map;
		lay(map, HALF, continued);
		CHECK(map.uses(MAP_LEDGE) == std::isnan(ground({ 6.0, 0.0 })));
		const Count count = count_off(map, ground, HALF);
		CHECK(count.off < count.blades / 1000);
	}
}

TEST_CASE("ledges: one that goes leaves nothing behind, and laying twice changes nothing") {
	const std::vector<Block> blocks{ { { 0.3, 0.2 }, { 2.0, 1.6 }, 0.5, 1.0 } };
	const HeightAt with = [&](const Eigen::Vector2d &p_at) { return highest(blocks, p_at, 0.0); };
	const HeightAt without = [](const Eigen::Vector2d &) { return 0.0; };
	PaintMap map;
	lay(map, 8.0, with);
	CHECK(map.uses(MAP_LEDGE));
	CHECK(lay_ground(map, { { -9, -9 }, { 9, 9 } }, with, MissingGround::STAYS, nullptr, { with }).changed.empty());
	const LaidGround gone = lay_ground(map, { { -9, -9 }, { 9, 9 } }, without, MissingGround::STAYS, nullptr, { without });
	CHECK_FALSE(gone.changed.empty());
	map.compact();
	CHECK(map.is_empty());
}

TEST_CASE("ledges: of a sheet of heights, what is steeper than the slope given is bare") {
	const auto cliff = [](const Eigen::Vector2d &p_at) { return std::clamp(5.0 * p_at.x() + 2.5, 0.0, 5.0); }; // 78.7 degrees
	for (const double slope : { 70.0, 80.0 }) {
		PaintMap map;
		map.set_base_density(1.0);
		lay_ground(map, { { -8, -8 }, { 8, 8 } }, cliff, MissingGround::HOLE, nullptr, { nullptr, slope });
		CHECK(map.uses(MAP_LEDGE) == (slope < 75.0));
		const BareCause cause = find_bare_cause(map, nullptr, {}, { 0.1, 1.1 }, 0.5);
		CHECK((cause.kind == BareKind::LEDGE) == (slope < 75.0));
		CHECK(find_bare_cause(map, nullptr, {}, { -2.0, 1.0 }, 0.5).kind == BareKind::GRASS);
	}
}
