// SPDX-License-Identifier: MIT
// A pool on the CPU, for its tests: records in, knots out.
#pragma once

#include "grown_tile.h"

#include "core/base/half.h"
#include "core/blades/blade.h"
#include "core/solver/simulate.h"
#include "core/solver/solver_params.h"

namespace grass::test {

inline constexpr float TILE_SIZE = 0.5f;

// A pool, and a ball that rolls over its tiles (x = 0 ..., z = 0).
struct PoolScene {
	CpuPool pool;
	SolverParams params;
	StepClock clock;
	std::vector<GrassSlot> slots, followers;
	std::vector<GrassCollider> colliders{ 1 };
	std::vector<uint32_t> list{ 0 };
	std::span<const SlotGrowth> growth; // of the steps to come
	GrassStep step_record;
	int time = 0;

	explicit PoolScene(int p_slots, Method p_method = Method::DIRECT) : pool(shared_patch(), p_slots) {
		params.method = p_method;
		for (int i = 0; i < p_slots; i++) {
			GrassSlot slot;
			slot.tile = { i, 0, i, i };
			slot.list = { uint32_t(i * 64), 0, 1, GRASS_SLOT_FRESH };
			slots.push_back(slot);
		}
		colliders[0].rotation = colliders[0].rotation_before = { 0, 0, 0, 1 };
		colliders[0].size.x = 0.15f;
	}
	void step(const ParallelFor &p_parallel_for = serial_for, double p_delta = 1.0 / 60.0) {
		step_record = clock.advance(params, p_delta);
		step_record.field = { TILE_SIZE, 64, 64, 0 };
		step_record.clump = { 1.6f, 1, 1, 1 };
		colliders[0].position_before = { -0.5f + 0.05f * float(time), 0.15f, 0.03f, 0.0f };
		colliders[0].position = { -0.45f + 0.05f * float(time), 0.15f, 0.03f, 0.5f };
		time++;
		StepInput input{ slots, colliders, list, {}, step_record };
		input.followers = followers;
		input.growth = growth;
		pool.step(input, p_parallel_for);
		for (GrassSlot &slot : slots) {
			slot.list.w &= ~uint32_t(GRASS_SLOT_FRESH);
		}
	}
	Eigen::Vector3f rest(int p_slot, int p_blade, int p_knot) const {
		const auto texel = [&](int p_k) {
			const uint16_t *halves = &shared_patch()->texels[Patch::texel_index(int(slots[size_t(p_slot)].list.x) + p_blade, p_k)];
			return Eigen::Vector3f(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
		};
		const ivec4 tile = slots[size_t(p_slot)].tile;
		const Eigen::Vector2f place = root_place({ float(tile.x), float(tile.y) }, texel(0).head<2>(), { 64.0f, 64.0f }, TILE_SIZE);
		return rest_knot(texel(p_knot), p_knot, clump_at(place, { 1.6f, 1, 1, 1 }));
	}
};

} // namespace grass::test
