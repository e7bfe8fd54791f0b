// SPDX-License-Identifier: MIT
// Ground that is read in parts: it is the same however it is cut, in whatever order, and a part casts no more rays than it may.
#include "core/paint/lay_ground.h"

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace grass;

namespace {

constexpr double HALF = 21.0; // metres of a level to each side; four chunks meet in its middle

struct Box {
	Eigen::Vector2d middle, half;
	double turn, high, rise; // rise: along its own x
	Eigen::Vector2d local(const Eigen::Vector2d &p_place) const { return Eigen::Rotation2Dd(-turn) * (p_place - middle); }
	bool holds(const Eigen::Vector2d &p_place) const { return (local(p_place).array().abs() <= half.array()).all(); }
	double at(const Eigen::Vector2d &p_place) const { return high + rise * local(p_place).x(); }
	MapRegion region() const { return { middle.array() - half.norm(), middle.array() + half.norm() }; }
};

// Walls of any thickness, blocks, stairs, a bridge over a trench, and a cliff in hills.
struct Level {
	std::vector<Box> boxes;
	double cliff = 0.0, trench = 0.0, turn = 0.0;

	explicit Level(unsigned p_seed) {
		std::mt19937 random(p_seed);
		std::uniform_real_distribution<double> any(0.0, 1.0);
		const auto place = [&] { return Eigen::Vector2d(-18.0 + 36.0 * any(random), -18.0 + 36.0 * any(random)); };
		for (int n = 0; n < 6; n++) {
			boxes.push_back(
					{ place(), { 0.5 + 2.0 * any(random), 0.5 + 2.0 * any(random) }, 3.0 * any(random), 0.2 + 2.0 * any(random), 0.0 });
			boxes.push_back({ place(), { 4.0 + 8.0 * any(random), 0.02 + 0.1 * any(random) }, 3.0 * any(random), 4.0, 0.0 }); // a wall
		}
		const Eigen::Vector2d stairs = place();
		const double way = 3.0 * any(random);
		for (int step = 0; step < 6; step++) {
			const Eigen::Vector2d on = stairs + 0.4 * step * Eigen::Vector2d(std::cos(way), std::sin(way));
			boxes.push_back({ on, { 0.2, 1.5 }, way, 0.25 * (step + 1), 0.0 });
		}
		cliff = -15.0 + 30.0 * any(random);
		trench = -15.0 + 30.0 * any(random);
		turn = any(random) - 0.5;
		boxes.push_back({ { trench, 3.0 * any(random) }, { 5.0, 0.6 }, 0.3 * any(random), 1.6, 0.05 }); // the bridge
	}
	double at(const Eigen::Vector2d &p_place) const {
		double height = 0.3 * std::sin(0.4 * p_place.x()) + 0.2 * std::cos(0.3 * p_place.y());
		height += p_place.y() + turn * p_place.x() + std::sin(0.5 * p_place.x()) > cliff ? 3.0 : 0.0;
		height -= std::abs(p_place.x() - turn * p_place.y() - trench) < 1.2 ? 2.0 : 0.0;
		for (const Box &box : boxes) {
			height = box.holds(p_place) ? std::fmax(height, box.at(p_place)) : height;
		}
		return height;
	}
};

void lay(PaintMap &r_map, const MapRegion &p_region, const Level &p_level) {
	const HeightAt height = [&](const Eigen::Vector2d &p_place) { return p_level.at(p_place); };
	lay_ground(r_map, p_region, height, MissingGround::STAYS, nullptr, { height });
}

MapRegion whole() {
	return { { -HALF, -HALF }, { HALF, HALF } };
}

// Squares of p_side metres, or chunks where that is 0, in any order.
std::vector<MapRegion> cut(const MapRegion &p_region, double p_side, std::mt19937 &r_random) {
	const double side = p_side > 0.0 ? p_side : MAP_CHUNK_SIZE;
	std::vector<MapRegion> parts;
	for (double z = std::floor(p_region.min.y() / side) * side; z < p_region.max.y(); z += side) {
		for (double x = std::floor(p_region.min.x() / side) * side; x < p_region.max.x(); x += side) {
			parts.push_back(MapRegion{ { x, z }, { x + side, z + side } }.shared(p_region));
		}
	}
	std::shuffle(parts.begin(), parts.end(), r_random);
	return parts;
}

// Texels of all channels of the ground that differ.
int count_different(PaintMap &r_a, PaintMap &r_b) {
	int differ = 0;
	for (const MapChannel channel : { MAP_GROUND, MAP_NORMAL, MAP_LEDGE, MAP_HOLE }) {
		const int reach = int(32.0 / info_of(channel).texel_size());
		for (int component = 0; component < info_of(channel).components; component++) {
			for (int j = -reach; j < reach; j++) {
				for (int i = -reach; i < reach; i++) {
					differ += r_a.get_code(channel, component, i, j) != r_b.get_code(channel, component, i, j) ? 1 : 0;
				}
			}
		}
	}
	return differ;
}

} // namespace

TEST_CASE("ground in parts: whole, chunk by chunk and square by square, in any order, it is the same to the byte") {
	std::mt19937 random(4);
	for (unsigned scene = 0; scene < 3; scene++) {
		const Level level(scene);
		PaintMap at_once;
		lay(at_once, whole(), level);
		REQUIRE(at_once.uses(MAP_LEDGE));
		for (const double side : { 0.0, 16.0, 4.0 }) {
			PaintMap in_parts;
			for (const MapRegion &part : cut(whole(), side, random)) {
				lay(in_parts, part, level);
			}
			CAPTURE(scene);
			CAPTURE(side);
			CHECK(count_different(at_once, in_parts) == 0);
			at_once.compact();
			in_parts.compact();
			CHECK(at_once.compare(in_parts).empty());
		}
	}
}

TEST_CASE("ground in parts: where bodies moved, reading what lies around them gives what reading all of it gives") {
	std::mt19937 random(9);
	std::uniform_real_distribution<double> any(-1.0, 1.0);
	for (unsigned scene = 0; scene < 3; scene++) {
		Level level(scene + 100);
		PaintMap followed;
		lay(followed, whole(), level);
		for (size_t moved = 0; moved < level.boxes.size(); moved++) {
			const Box before = level.boxes[moved];
			Box &box = level.boxes[moved];
			box.middle += 4.0 * Eigen::Vector2d(any(random), any(random));
			box.turn += any(random);
			for (const Box &around : { before, box }) {
				const MapRegion region = around.region().grown(GroundReading::REACH * GROUND_TEXEL).shared(whole());
				for (const MapRegion &part : cut(region, 0.0, random)) {
					if ((part.min.array() < part.max.array()).all()) {
						lay(followed, part, level);
					}
				}
			}
			PaintMap afresh;
			lay(afresh, whole(), level);
			CAPTURE(scene);
			CAPTURE(moved);
			REQUIRE(count_different(followed, afresh) == 0);
		}
	}
}

TEST_CASE("ground in parts: a call reads no more places than it may, and what it reads is the same") {
	const Level level(5);
	PaintMap at_once;
	lay(at_once, whole(), level);
	for (const int64_t most : { int64_t(GroundReading::LEAST_PLACES), int64_t(4096) }) {
		GroundReading ground(whole(), {});
		int64_t calls = 0, read = 0, largest = 0;
		const HeightAt counted = [&](const Eigen::Vector2d &p_place) {
			read++;
			return level.at(p_place);
		};
		for (bool is_done = false; !is_done; calls++) {
			const int64_t before = read;
			is_done = ground.read(counted, counted, most);
			CHECK((is_done || read > before)); // it gets on
			largest = std::max(largest, read - before);
		}
		CHECK(largest <= most);
		CHECK(ground.get_sampled() == read);
		CHECK(read > 3 * most); // it is too much for one call
		CHECK(calls <= 2 * read / most + 1);
		PaintMap in_calls;
		lay_ground(in_calls, ground);
		CHECK(count_different(at_once, in_calls) == 0);
	}
}
