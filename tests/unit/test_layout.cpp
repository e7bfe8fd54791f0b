// SPDX-License-Identifier: MIT
// Record sizes and offsets are checked at compile time in core/base/layout.h; here, that the numbers of
// shaders/base/constants.inc fit one another.
#include "core/base/layout.h"
#include "core/solver/step.h"

#include <doctest/doctest.h>

using namespace grass;

TEST_CASE("layout: a record's words stand where std430 puts them") {
	GrassSlot slot;
	slot.tile = { 1, 2, 3, 4 };
	slot.list = { 5, 6, 7, 8 };
	slot.blend = { 0.5f, 0.0f, 0.0f, 0.0f };
	const uint32_t *words = reinterpret_cast<const uint32_t *>(&slot);
	for (uint32_t i = 0; i < 8; i++) {
		CHECK(words[i] == i + 1);
	}
	CHECK(words[8] == 0x3f000000u);
	CHECK(alignof(GrassSlot) == 16);
	CHECK(alignof(GrassCollider) == 16);
}

TEST_CASE("layout: constants fit one another") {
	CHECK(GRASS_CLAMPED_KNOTS + GRASS_FREE_KNOTS == GRASS_KNOTS);
	CHECK(GRASS_SEGMENTS == GRASS_KNOTS - 1);
	CHECK(GRASS_PATCH_BLADES % GRASS_PATCH_BLADES_PER_ROW == 0);
	CHECK(GRASS_POOL_BLADES_PER_ROW == GRASS_BLADES_PER_TILE);
	CHECK((GRASS_START_COUNT - 1) * GRASS_START_STRIDE + GRASS_BLADES_PER_TILE <= GRASS_PATCH_BLADES);
	CHECK((GRASS_SLOT_FRESH & GRASS_SLOT_SETTLING) == 0);
	CHECK((GRASS_SLOT_RETIRED & (GRASS_SLOT_FRESH | GRASS_SLOT_SETTLING)) == 0);
}

TEST_CASE("layout: an empty step holds nothing") {
	const StepInput input{};
	CHECK(input.slots.empty());
	CHECK(input.colliders.empty());
	CHECK(input.collider_list.empty());
	CHECK(input.planes.empty());
}
