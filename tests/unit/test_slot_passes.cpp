// SPDX-License-Identifier: MIT
#include "core/solver/slot_passes.h"

#include <doctest/doctest.h>

#include <limits>
#include <numeric>
#include <vector>

using namespace grass;

namespace {

GrassSlot make_slot(uint32_t p_first, uint32_t p_count, uint32_t p_bits) {
	return { { 0, 0, 0, 0 }, { 0, p_first, p_count, p_bits }, { 0.0f, 0.0f, 0.0f, 0.0f } };
}

} // namespace

TEST_CASE("slot passes: one sharp collider is enough for edges, none at all for the short pass, and every slot keeps its other bits") {
	const std::vector<GrassCollider> colliders(2, GrassCollider{});
	const std::vector<uint8_t> sharp{ 0, 1 };
	const std::vector<uint32_t> list{ 0, 0, 1, 1 };
	StepInput input;
	input.colliders = colliders;
	input.sharp = sharp;
	input.collider_list = list;
	std::vector<GrassSlot> slots{ make_slot(0, 0, GRASS_SLOT_RETIRED), make_slot(0, 1, GRASS_SLOT_FRESH), make_slot(1, 2, 0),
		make_slot(3, 0, GRASS_SLOT_SETTLING), make_slot(3, 1, GRASS_SLOT_MAPPED) };
	input.slots = slots;
	std::vector<GrassSlot> chosen(slots.size());
	const SlotPasses passes = choose_passes(input, {}, chosen);
	CHECK(passes.edges == 2);
	CHECK(passes.free == 1);
	const std::vector<uint32_t> expected{ GRASS_SLOT_RETIRED, GRASS_SLOT_FRESH, GRASS_SLOT_EDGES, GRASS_SLOT_SETTLING | GRASS_SLOT_FREE,
		GRASS_SLOT_MAPPED | GRASS_SLOT_EDGES };
	for (size_t i = 0; i < slots.size(); i++) {
		CHECK(chosen[i].list.w == expected[i]);
	}
}

TEST_CASE("slot passes: a tile with more colliders than a workgroup shares has a pass of its own, sharp or not") {
	const std::vector<GrassCollider> colliders(GRASS_SHARED_COLLIDERS + 2, GrassCollider{});
	std::vector<uint8_t> sharp(colliders.size(), 0);
	sharp[GRASS_SHARED_COLLIDERS + 1] = 1;
	std::vector<uint32_t> list(colliders.size());
	std::iota(list.begin(), list.end(), 0);
	StepInput input;
	input.colliders = colliders;
	input.sharp = sharp;
	input.collider_list = list;
	std::vector<GrassSlot> slots{ make_slot(0, GRASS_SHARED_COLLIDERS, 0), make_slot(0, GRASS_SHARED_COLLIDERS + 1, 0),
		make_slot(1, GRASS_SHARED_COLLIDERS + 1, 0) };
	input.slots = slots;
	std::vector<GrassSlot> chosen(slots.size());
	const SlotPasses passes = choose_passes(input, {}, chosen);
	CHECK(passes.crowds == 2);
	CHECK(passes.edges == 0);
	CHECK(chosen[0].list.w == 0);
	CHECK(chosen[1].list.w == GRASS_SLOT_CROWD);
	CHECK(chosen[2].list.w == (GRASS_SLOT_CROWD | GRASS_SLOT_EDGES)); // until the pass is compiled, that for edges takes it
}

TEST_CASE("slot passes: retired tiles stay first, then come those with a fast collider, then the liveliest, alike ones in their order") {
	GrassCollider slow{}, fast{};
	slow.position.x = 0.01f;
	fast.position.z = 0.1f;
	const std::vector<GrassCollider> colliders{ slow, fast };
	const std::vector<uint8_t> sharp{ 0, 0 };
	const std::vector<uint32_t> list{ 0, 1, 0, 1 };
	StepInput input;
	input.colliders = colliders;
	input.sharp = sharp;
	input.collider_list = list;
	input.step.chain.x = 1.0f / 60.0f;
	std::vector<GrassSlot> slots{ make_slot(0, 0, GRASS_SLOT_RETIRED), make_slot(0, 1, 0), make_slot(1, 1, 0), make_slot(2, 0, 0),
		make_slot(2, 2, 0), make_slot(0, 1, 0), make_slot(0, 1, 0) };
	const size_t looked_at = slots.size();
	slots.resize(looked_at + 128, make_slot(0, 0, 0)); // of these nothing is known
	for (size_t i = 0; i < slots.size(); i++) {
		slots[i].tile.w = int(i);
	}
	const auto order_of = [&](std::span<const GrassSlot> p_slots, const std::vector<float> &p_energies) {
		input.slots = p_slots;
		std::vector<GrassSlot> chosen(p_slots.size());
		choose_passes(input, p_energies, chosen);
		std::vector<int> order;
		for (const GrassSlot &slot : std::span(chosen).first(looked_at)) {
			order.push_back(slot.tile.w);
		}
		return order;
	};
	const auto order_by = [&](const std::vector<float> &p_energies) { return order_of(slots, p_energies); };
	CHECK(order_of(std::span(slots).first(looked_at), { 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 2.0f }) ==
			std::vector<int>{ 0, 2, 4, 1, 3, 5, 6 }); // so few run at once
	CHECK(order_by({}) == std::vector<int>{ 0, 2, 4, 1, 3, 5, 6 });
	CHECK(order_by({ 9.0f, 0.5f, 0.0f, 2.0f, 0.0f, 0.5f, 8.0f }) == std::vector<int>{ 0, 2, 4, 6, 3, 1, 5 });
	CHECK(order_by({ 0.0f, 1e-30f, 0.0f, 1e30f }) == std::vector<int>{ 0, 2, 4, 3, 1, 5, 6 }); // of the last nothing is known
	const float infinite = std::numeric_limits<float>::infinity();
	CHECK(order_by({ 0.0f, 1.0f, 0.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f, infinite, 2.0f }) ==
			std::vector<int>{ 0, 2, 4, 3, 5, 6, 1 });
}
