// SPDX-License-Identifier: MIT
#include "core/solver/slot_passes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

using namespace grass;

namespace {

GrassSlot make_slot(uint32_t p_first, uint32_t p_count, uint32_t p_bits) {
	return { { 0, 0, 0, 0 }, { 0, p_first, p_count, p_bits }, { 0.0f, 0.0f, 0.0f, 0.0f }, {} };
}

const PassGroups &of(const SlotPasses &p_passes, SlotPass p_pass) {
	return p_passes[size_t(p_pass)];
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
	const SlotPasses passes = choose_passes(input, {}, {}, chosen);
	CHECK(of(passes, SlotPass::EDGES).tiles() == 2);
	CHECK(of(passes, SlotPass::PLAIN).tiles() == 1);
	CHECK(of(passes, SlotPass::FREE).tiles() == 1);
	const std::vector<uint32_t> expected{ 0, GRASS_SLOT_MAPPED, GRASS_SLOT_FRESH, GRASS_SLOT_RETIRED, GRASS_SLOT_SETTLING };
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
	const SlotPasses passes = choose_passes(input, {}, {}, chosen);
	CHECK(of(passes, SlotPass::CROWD).single.count == 2);
	CHECK(of(passes, SlotPass::CROWD).many.count == 0);
	CHECK(of(passes, SlotPass::EDGES).tiles() == 0);
	CHECK(of(passes, SlotPass::PLAIN).single.count == 1);
}

TEST_CASE("slot passes: first come those with a fast collider, then the liveliest, alike ones in their order") {
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
		choose_passes(input, p_energies, {}, chosen);
		std::vector<int> order;
		for (const GrassSlot &slot : std::span(chosen).first(looked_at)) {
			order.push_back(slot.tile.w);
		}
		return order;
	};
	const auto order_by = [&](const std::vector<float> &p_energies) { return order_of(slots, p_energies); };
	const std::vector<int> as_given{ 2, 4, 1, 5, 6, 0, 3 }; // the retired one and that without colliders have workgroups of another kind
	CHECK(order_of(std::span(slots).first(looked_at), { 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 2.0f }) == as_given); // so few run at once
	CHECK(order_by({}) == as_given);
	CHECK(order_by({ 9.0f, 0.5f, 0.0f, 2.0f, 0.0f, 0.5f, 8.0f }) == std::vector<int>{ 2, 4, 6, 1, 5, 0, 3 });
	CHECK(order_by({ 0.0f, 1e-30f, 0.0f, 0.0f, 0.0f, 1e30f }) == std::vector<int>{ 2, 4, 5, 1, 6, 0, 3 }); // of the last nothing is known
	CHECK(order_by({ 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f }) == std::vector<int>{ 2, 4, 1, 5, 6, 0, 8 });
	const float infinite = std::numeric_limits<float>::infinity();
	CHECK(order_by({ 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, infinite, std::numeric_limits<float>::quiet_NaN() }) ==
			std::vector<int>{ 2, 4, 5, 6, 1, 0, 3 });
}

TEST_CASE("slot passes: tiles of which few blades are simulated share a workgroup as long as there is room for their colliders") {
	std::mt19937 random(41);
	const std::vector<GrassCollider> colliders(8, GrassCollider{});
	const std::vector<uint8_t> sharp{ 0, 0, 0, 0, 0, 1, 1, 1 };
	std::vector<uint32_t> list(4096);
	std::ranges::generate(list, [&] { return random() % 8; });
	for (const bool may_share : { true, false }) {
		std::vector<GrassSlot> slots;
		int blades = 0, live = 0;
		for (int i = 0; i < 700; i++) {
			const uint32_t entries = random() % 3 == 0 ? random() % 40 : random() % 3;
			slots.push_back(make_slot(random() % 4000, entries, random() % 20 == 0 ? GRASS_SLOT_RETIRED : 0));
			slots.back().tile.w = i;
			slots.back().blend.y = float(8 * (random() % 8));
			if (slots.back().list.w == 0) {
				live++;
				blades += 64 - int(slots.back().blend.y);
			}
		}
		StepInput input;
		input.colliders = colliders;
		input.sharp = sharp;
		input.collider_list = list;
		input.slots = slots;
		std::vector<GrassSlot> chosen(slots.size());
		const SlotPasses passes = choose_passes(input, {}, { 64, may_share }, chosen);
		std::vector<int> seen(slots.size(), 0);
		uint32_t group = 0;
		int tiles = 0;
		for (int pass = 0; pass < SLOT_PASSES; pass++) {
			for (const bool many : { false, true }) {
				const SlotGroups &groups = many ? passes[size_t(pass)].many : passes[size_t(pass)].single;
				CHECK((groups.count == 0 || groups.first == group)); // one after the other
				CHECK((may_share || !many || groups.count == 0));
				tiles += groups.tiles;
				for (uint32_t i = 0; i < groups.count; i++, group++) {
					const uvec4 own = chosen[group].group;
					CHECK(own.w == group % 64);
					CHECK(own.y * own.z <= 64);
					CHECK((many || (own.y == 64 && own.z == 1)));
					uint32_t shared = 0;
					for (uint32_t at = own.x; at < own.x + own.z; at++) {
						const GrassSlot &slot = chosen[at];
						seen[size_t(slot.tile.w)]++;
						const bool is_retired = slot.list.w != 0;
						CHECK((is_retired || 64 - uint32_t(slot.blend.y) <= own.y));
						CHECK(uint32_t(slot.blend.w) == shared);
						shared += slot.list.z;
					}
					CHECK((shared <= GRASS_SHARED_COLLIDERS || own.z == 1));
				}
			}
		}
		CHECK(tiles == live);
		CHECK(std::ranges::all_of(seen, [](int p_times) { return p_times == 1; }));
		CHECK((may_share ? int(group) < blades / 64 + live / 3 : group == slots.size()));
	}
}

TEST_CASE(
		"slot passes: tiles that move by their strains have workgroups of their own, unless a body is near or their pass is not compiled") {
	const std::vector<GrassCollider> colliders(1, GrassCollider{});
	const std::vector<uint8_t> sharp{ 0 };
	const std::vector<uint32_t> list{ 0 };
	std::vector<GrassSlot> slots{ make_slot(0, 0, GRASS_SLOT_ALONE), make_slot(0, 0, 0), make_slot(0, 1, GRASS_SLOT_ALONE),
		make_slot(0, 0, GRASS_SLOT_ALONE | GRASS_SLOT_FRESH), make_slot(0, 0, GRASS_SLOT_ALONE) };
	for (GrassSlot &slot : slots) {
		slot.blend.y = 48.0f;
	}
	StepInput input;
	input.colliders = colliders;
	input.sharp = sharp;
	input.collider_list = list;
	input.slots = slots;
	std::vector<GrassSlot> chosen(slots.size());
	const SlotPasses passes = choose_passes(input, {}, { 64, false, true }, chosen);
	CHECK(of(passes, SlotPass::STRAINS).tiles() == 2);
	CHECK(of(passes, SlotPass::STRAINS).single.count == 0);
	CHECK(of(passes, SlotPass::STRAINS).many.count == 1); // they share it, whether or not others may
	CHECK(of(passes, SlotPass::FREE).single.count == 2);
	CHECK(of(passes, SlotPass::PLAIN).single.count == 1);
	const SlotPasses chains = choose_passes(input, {}, { 64, false, false }, chosen);
	CHECK(of(chains, SlotPass::STRAINS).tiles() == 0);
	CHECK(of(chains, SlotPass::FREE).single.count == 4);
	const SlotGrowth grown{ 0, {}, {} };
	input.growth = { &grown, 1 };
	CHECK(of(choose_passes(input, {}, { 64, false, true }, chosen), SlotPass::STRAINS).tiles() == 0); // all have slot 0
	input.growth = {};
	input.step.contact.w = float(GRASS_METHOD_PBD);
	CHECK(of(choose_passes(input, {}, { 64, false, true }, chosen), SlotPass::STRAINS).tiles() == 0);
}
