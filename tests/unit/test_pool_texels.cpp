// SPDX-License-Identifier: MIT
// What frames between two ticks show of the pool.
#include "core/field/pool_texels.h"

#include "pool_scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace grass;
using namespace grass::test;

namespace {

using Row = std::vector<uint16_t>;

constexpr int SLOTS = 4, ROWS = 4;

struct TexelScene {
	PoolScene scene{ SLOTS };
	PoolTexels texels;

	explicit TexelScene(bool p_is_between) {
		texels.reset(SLOTS);
		texels.set_between(p_is_between);
	}
	void step() {
		texels.begin_step(scene.pool, scene.slots);
		scene.step();
		texels.end_step(scene.slots);
	}
	void steps(int p_count) {
		for (int i = 0; i < p_count; i++) {
			step();
		}
	}
	Row pack(int p_slot) const {
		Row row(size_t(PoolTexels::ROW_TEXELS) * 4);
		scene.pool.pack_row(p_slot, row);
		return row;
	}
	Row shown(int p_slot, float p_share = 1.0f) {
		texels.show(scene.pool, ROWS, p_share);
		const auto row = texels.get_shown().subspan(size_t(p_slot) * PoolTexels::ROW_TEXELS * 4, size_t(PoolTexels::ROW_TEXELS) * 4);
		return { row.begin(), row.end() };
	}
};

// Returns the farthest that a row is from the mix of two others, metres and radians.
float distance_to_mix(const Row &p_row, const Row &p_before, const Row &p_after, float p_share) {
	float most = 0.0f;
	for (size_t i = 0; i < p_row.size(); i++) {
		const float mixed = half_to_float(p_before[i]) + p_share * (half_to_float(p_after[i]) - half_to_float(p_before[i]));
		most = std::max(most, std::abs(half_to_float(p_row[i]) - mixed));
	}
	return most;
}

} // namespace

TEST_CASE("pool texels: without a mix a frame shows the last step, and nothing more is kept") {
	TexelScene plain(false), mixing(true);
	plain.steps(12);
	mixing.steps(12);
	CHECK(plain.shown(1, 0.25f) == plain.pack(1));
	mixing.shown(1);
	const size_t bytes = size_t(ROWS) * PoolTexels::ROW_TEXELS * 8;
	CHECK(plain.texels.get_memory_usage() == bytes + 8); // the set of rows to write
	CHECK(mixing.texels.get_memory_usage() == 3 * (bytes + 8));
	mixing.texels.set_between(false);
	CHECK(mixing.texels.get_memory_usage() == bytes + 8);
	CHECK(mixing.shown(1, 0.25f) == mixing.pack(1));
}

TEST_CASE("pool texels: a frame between two ticks shows the mix of their steps, of every tile") {
	TexelScene scene(true);
	scene.steps(10);
	std::vector<Row> before;
	for (int slot = 0; slot < SLOTS; slot++) {
		before.push_back(scene.pack(slot));
	}
	scene.step();
	CHECK(distance_to_mix(before[1], scene.pack(1), scene.pack(1), 1.0f) > 0.005f); // it moves, metres a step
	for (const float share : { 0.0f, 0.25f, 0.5f, 0.75f, 1.0f }) {
		for (int slot = 0; slot < SLOTS; slot++) {
			CHECK(distance_to_mix(scene.shown(slot, share), before[size_t(slot)], scene.pack(slot), share) <
					5e-4f); // a half's rounding, below 2: a twist in radians may be above 1
		}
	}
	CHECK(scene.shown(1, 0.0f) == before[1]);
	CHECK(scene.shown(1, 1.0f) == scene.pack(1));
}

TEST_CASE("pool texels: several steps in a frame leave the mix of the last two") {
	TexelScene scene(true);
	scene.steps(9);
	scene.shown(1, 0.5f);
	scene.steps(2);
	const Row before = scene.pack(1);
	scene.step();
	CHECK(scene.shown(1, 0.0f) == before);
	CHECK(scene.shown(1, 1.0f) == scene.pack(1));
}

TEST_CASE("pool texels: a tile that wakes was at rest a step before, whoever had its row") {
	TexelScene scene(true);
	scene.steps(12);
	CHECK(scene.shown(1, 0.0f) != Row(size_t(PoolTexels::ROW_TEXELS) * 4));
	scene.scene.slots[1].tile = { 9, 0, 9, 1 };
	scene.scene.slots[1].list.w |= GRASS_SLOT_FRESH;
	scene.step();
	CHECK(scene.shown(1, 0.0f) == Row(size_t(PoolTexels::ROW_TEXELS) * 4));
	CHECK(scene.shown(1, 1.0f) == scene.pack(1));
}

TEST_CASE("pool texels: a tile that a step leaves out is shown as it is, whatever the share") {
	TexelScene scene(true);
	scene.steps(12);
	scene.shown(1, 0.5f);
	std::erase_if(scene.scene.slots, [](const GrassSlot &p_slot) { return p_slot.tile.w == 1; });
	scene.step();
	for (const float share : { 0.0f, 0.5f, 1.0f }) {
		CHECK(scene.shown(1, share) == scene.pack(1));
	}
}

TEST_CASE("pool texels: what is shown already is not made again") {
	TexelScene scene(true);
	scene.steps(5);
	CHECK(scene.texels.show(scene.scene.pool, ROWS, 0.5f));
	CHECK(!scene.texels.show(scene.scene.pool, ROWS, 0.5f));
	CHECK(scene.texels.show(scene.scene.pool, ROWS, 0.75f));
	TexelScene resting(true);
	resting.texels.show(resting.scene.pool, ROWS, 0.5f);
	CHECK(!resting.texels.show(resting.scene.pool, ROWS, 0.75f)); // nothing has moved
}

TEST_CASE("pool texels: a mix that begins between two frames begins with the last step") {
	TexelScene scene(false);
	scene.steps(11);
	scene.texels.set_between(true);
	CHECK(scene.shown(1, 0.25f) == scene.pack(1));
	const Row before = scene.pack(1);
	scene.step();
	CHECK(scene.shown(1, 0.0f) == before);
}

TEST_CASE("pool texels: rows follow their tiles into a smaller pool, and go on being mixed there") {
	for (const bool is_between : { false, true }) {
		TexelScene scene(is_between);
		scene.steps(28); // the ball has come to tile 2
		(void)scene.shown(2, 0.5f);
		const Row before = scene.pack(2);
		scene.step();
		const Row after = scene.pack(2);
		REQUIRE(distance_to_mix(before, after, after, 1.0f) > 0.005f); // it moves
		const std::vector<SlotMove> moves = { { 1, 1, GRASS_NO_SLOT }, { 2, 2, 1 }, { 3, 3, GRASS_NO_SLOT } };
		scene.scene.pool.resize(2, moves);
		scene.texels.resize_pool(2, moves);
		if (is_between) {
			CHECK(distance_to_mix(scene.shown(1, 0.25f), before, after, 0.25f) < 1e-3f);
		} else {
			CHECK(scene.shown(1) == after);
		}
	}
}

TEST_CASE("pool texels: blades that join between two steps are shown where they are, whatever the share; the others go on being mixed") {
	TexelScene scene(true);
	scene.steps(10);
	const Row before = scene.pack(1);
	for (int i = 0; i < 3; i++) {
		scene.scene.slots[1].blend.y = 48.0f;
		scene.step();
	}
	scene.shown(1, 0.5f);
	GrassSlot &slot = scene.scene.slots[1];
	slot.blend = { 1.0f, 0.0f, slot.blend.y, slot.blend.y };
	scene.scene.pool.join(slot);
	scene.texels.change(scene.scene.pool, std::span(&slot, 1));
	const Row joined = scene.pack(1), half = scene.shown(1, 0.5f), whole = scene.shown(1, 1.0f);
	CHECK(whole == joined);
	int mixed = 0, apart = 0;
	for (size_t i = 0; i < joined.size(); i++) {
		const bool joins = int(i / 4) % GRASS_POOL_BLADES_PER_ROW >= 16;
		mixed += !joins && half[i] != joined[i];
		apart += joins && half[i] != joined[i];
	}
	CHECK(mixed > 100);
	CHECK(apart == 0);
	CHECK(joined != before);
}
