// SPDX-License-Identifier: MIT
#include "core/solver/slot_passes.h"

#include <doctest/doctest.h>

#include <vector>

using namespace grass;

namespace {

GrassSlot make_slot(uint32_t p_first, uint32_t p_count, uint32_t p_bits) {
	return { { 0, 0, 0, 0 }, { 0, p_first, p_count, p_bits }, { 0.0f, 0.0f, 0.0f, 0.0f } };
}

} // namespace

TEST_CASE("slot passes: one sharp collider is enough for edges, none at all for the short pass, and every slot keeps its other bits") {
	const std::vector<uint8_t> sharp{ 0, 1 };
	const std::vector<uint32_t> list{ 0, 0, 1, 1 };
	StepInput input;
	input.sharp = sharp;
	input.collider_list = list;
	std::vector<GrassSlot> slots{ make_slot(0, 0, GRASS_SLOT_RETIRED), make_slot(0, 1, GRASS_SLOT_FRESH), make_slot(1, 2, 0),
		make_slot(3, 0, GRASS_SLOT_SETTLING), make_slot(3, 1, GRASS_SLOT_MAPPED) };
	const SlotPasses passes = choose_passes(input, slots);
	CHECK(passes.edges == 2);
	CHECK(passes.free == 1);
	const std::vector<uint32_t> expected{ GRASS_SLOT_RETIRED, GRASS_SLOT_FRESH, GRASS_SLOT_EDGES, GRASS_SLOT_SETTLING | GRASS_SLOT_FREE,
		GRASS_SLOT_MAPPED | GRASS_SLOT_EDGES };
	for (size_t i = 0; i < slots.size(); i++) {
		CHECK(slots[i].list.w == expected[i]);
	}
}
