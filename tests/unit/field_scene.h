// SPDX-License-Identifier: MIT
// A field that runs without an engine, for tests of whole ticks.
#pragma once

#include "core/field/field.h"

#include "grown_tile.h"

#include "core/field/visitors.h"
#include "core/solver/simulate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace grass::test {

inline constexpr double TICK = 1.0 / 60.0;

// Simulates as the CPU backend does, unless a test forbids it.
class PoolSimulator : public Simulator {
public:
	explicit PoolSimulator(const FieldSetup &p_setup) : _pool(p_setup.patch, p_setup.pool_size) {}

	StepTime read_step_time() override { return time; }
	bool can_simulate() override { return can; }
	bool can_join() override { return joins; }
	void step(const StepInput &p_input) override {
		_pool.step(p_input);
		_step = p_input.number;
		method = Method(int(p_input.step.contact.w));
		slots.assign(p_input.slots.begin(), p_input.slots.end());
		followers.assign(p_input.followers.begin(), p_input.followers.end());
		grown = p_input.growth.size();
		steps++;
		time.count += time.ms > 0.0 ? 1 : 0;
	}
	void join(std::span<const GrassSlot> p_slots, const GrassStep &p_step) override {
		(void)p_step;
		for (const GrassSlot &slot : p_slots) {
			_pool.join(slot);
		}
		joined.insert(joined.end(), p_slots.begin(), p_slots.end());
	}
	void resize_pool(int p_slots, std::span<const SlotMove> p_moves) override {
		_pool.resize(p_slots, p_moves);
		made = p_slots;
		moves.assign(p_moves.begin(), p_moves.end());
	}
	int get_slots_at_once() const override { return at_once; }
	bool prepare_pool(int p_slots) override {
		ticks_left = p_slots > 0 && p_slots == wanted ? ticks_left - 1 : PREPARING;
		wanted = p_slots;
		return wanted > 0 && ticks_left <= 0;
	}
	EnergyReport read_energy() override { return { _step > 0 ? _step - 1 : 0, _pool.get_energy(), _pool.get_bends() }; }
	uint64_t hash() const { return _pool.hash(); }
	SimulatedKnots read_knots(int p_slot, int p_blade) const {
		SimulatedKnots knots;
		std::ranges::copy(_pool.get_knots(p_slot, p_blade), knots.emplace().begin());
		return knots;
	}

	bool can = true, joins = true;
	int steps = 0;
	Method method = Method::DIRECT; // of the last step
	std::vector<GrassSlot> slots; // likewise
	std::vector<GrassSlot> followers; // likewise
	size_t grown = 0; // tiles, likewise
	StepTime time; // of steps; 0 ms: the device measures none
	std::vector<GrassSlot> joined;
	static constexpr int PREPARING = 5; // calls of prepare_pool(), two a tick
	int at_once = TileParams::MAX_POOL_SIZE, wanted = 0, ticks_left = 0, made = 0; // slots; calls
	std::vector<SlotMove> moves; // of the last change of the pool's size

private:
	CpuPool _pool;
	uint64_t _step = 0;
};

inline FieldSetup make_setup() {
	FieldSetup setup;
	setup.grid = TileGrid::make(16.0, 16.0, 64.0); // tiles of 1 m
	setup.patch = shared_patch();
	setup.pool_size = 64;
	return setup;
}

// A field, and a ball on it.
struct FieldScene {
	FieldSetup setup = make_setup();
	FieldParams params;
	Field field;
	PoolSimulator simulator{ setup };
	std::vector<ColliderShape> bodies;
	Visitors visitors;

	explicit FieldScene(std::shared_ptr<PoolBudget> p_budget = nullptr) : field(std::move(p_budget)) {
		params.sleep_mode = SleepMode::TIMER;
		params.sleep_delay = 0.1;
		params.settle_time = 0.1;
		field.set(setup, field.bounds_of(setup), nullptr, {}, params);
	}
	void put_ball(const Eigen::Vector3d &p_place, const Eigen::Vector3d &p_before) {
		ColliderShape ball;
		ball.size.x() = 0.2;
		ball.now.position = p_place;
		ball.before.position = p_before;
		ball.owner = 7;
		bodies = { ball };
	}
	void put_ball(const Eigen::Vector3d &p_place) { put_ball(p_place, p_place); }
	// False if the tick was left out.
	bool tick(bool p_is_listened = false) {
		if (!field.begin_tick(simulator, p_is_listened, TICK)) {
			return false;
		}
		field.resume();
		field.tick(simulator, bodies, TICK);
		return true;
	}
	void ticks(int p_count) {
		for (int i = 0; i < p_count; i++) {
			tick();
		}
	}
	// Returns the farthest that a knot of a tile is from where it is at rest, metres.
	double bend_of(int p_x, int p_z) {
		const int slot = field.get_tiles().get_slot_of(setup.grid.get_index(p_x, p_z));
		double most = 0.0;
		for (int blade = 0; blade < GRASS_BLADES_PER_TILE; blade++) {
			const BladeNumber number = number_of(setup.grid.get_index(p_x, p_z), blade);
			const auto rest = field.find_knots(number, {});
			const auto now = field.find_knots(number, slot == GRASS_NO_SLOT ? SimulatedKnots() : simulator.read_knots(slot, blade));
			for (size_t knot = 0; knot < rest.size(); knot++) {
				most = std::max(most, (now[knot] - rest[knot]).norm());
			}
		}
		return most;
	}
};

// Returns a camera whose six planes hold nothing, or all, of the field.
inline FieldView make_view(bool p_sees) {
	ViewCamera camera;
	camera.planes.fill(Eigen::Vector4f(1.0f, 0.0f, 0.0f, p_sees ? 1000.0f : -1000.0f));
	FieldView view;
	view.cameras = { camera };
	return view;
}

} // namespace grass::test
