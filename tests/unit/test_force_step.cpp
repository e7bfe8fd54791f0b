// SPDX-License-Identifier: MIT
// What forces do to blades: [Eq W6].
#include <doctest/doctest.h>

#include "grown_tile.h"

#include "core/blades/force.h"
#include "core/solver/simulate.h"
#include "core/solver/solver_params.h"

#include <bit>
#include <cmath>

using namespace grass;
using namespace grass::test;

namespace {

const TileGrid GRID = TileGrid::make(32.0, 32.0, 256.0);

// Tiles beside each other in the middle of the field, and a force over them.
struct BlownScene {
	CpuPool pool;
	SolverParams params;
	StepClock clock;
	Force force;
	std::vector<GrassSlot> slots;
	TileStep tile_step = step_lanes;
	bool is_blowing = true;

	explicit BlownScene(Method p_method, int p_slots = 3) : pool(shared_patch(), p_slots) {
		params.method = p_method;
		force.kind = ForceKind::WIND;
		force.duration = 0.0;
		force.turbulence = 0.0;
		force.radius = 20.0;
		force.age = 10.0;
		for (int i = 0; i < p_slots; i++) {
			GrassSlot slot;
			slot.tile = { 32 + i, 32, i, i };
			slot.list = { uint32_t(i * 64), 0, 0, GRASS_SLOT_FRESH };
			slots.push_back(slot);
		}
	}
	void step(double p_delta = 1.0 / 60.0) {
		const GrassForce record = force.pack(GRID);
		StepInput input;
		input.step = clock.advance(params, p_delta);
		input.step.field = { float(GRID.get_tile_size()), 64, 64, 0 };
		input.step.clump = { 1.6f, 1, 1, 1 };
		for (GrassSlot &slot : slots) {
			slot.list.w = (slot.list.w & GRASS_SLOT_FRESH) | (is_blowing ? 1u << GRASS_SLOT_FORCES : 0u);
		}
		input.slots = slots;
		input.forces = { &record, 1 };
		pool.step(input, serial_for, tile_step);
		for (GrassSlot &slot : slots) {
			slot.list.w = 0;
		}
	}
	// Mean of the tips' ways from rest, shares of their blades.
	Eigen::Vector3f bend() const { return pool.get_bends()[1]; }
	uint64_t hash() const {
		uint64_t hash = 14695981039346656037u;
		for (int blade = 0; blade < GRASS_BLADES_PER_TILE; blade++) {
			for (const Eigen::Vector3f &knot : pool.get_knots(1, blade)) {
				for (int c = 0; c < 3; c++) {
					hash = (hash ^ std::bit_cast<uint32_t>(knot[c])) * 1099511628211u;
				}
			}
		}
		return hash;
	}
};

} // namespace

TEST_CASE("force: bends blades along its air, farther the stronger it blows, and they rise when it ends") {
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		float before = 0.0f;
		for (const double speed : { 4.0, 8.0, 16.0, 40.0 }) {
			BlownScene scene(method);
			scene.force.speed = speed;
			for (int i = 0; i < 300; i++) {
				scene.step();
			}
			CAPTURE(int(method));
			CAPTURE(speed);
			CHECK(scene.bend().x() > before + 0.02f);
			CHECK(std::abs(scene.bend().z()) < 0.3f * scene.bend().x());
			before = scene.bend().x();
			scene.is_blowing = false;
			for (int i = 0; i < 1200; i++) {
				scene.step();
			}
			CHECK(scene.bend().norm() < 1e-3f);
		}
	}
}

TEST_CASE("force: what is too weak to simulate leaves every bit at rest") {
	BlownScene still(Method::DIRECT), weak(Method::DIRECT);
	still.is_blowing = false;
	weak.force.speed = 0.99 * GRASS_FORCE_WAKES;
	for (int i = 0; i < 20; i++) {
		still.step();
		weak.step();
	}
	CHECK(still.hash() == weak.hash());
}

TEST_CASE("force: all lanes compute the same bits") {
	for (const Method method : { Method::DIRECT, Method::PBD }) {
		uint64_t expected = 0;
		for (const TileStep step : { step_scalar_float, step_lanes }) {
			BlownScene scene(method);
			scene.tile_step = step;
			scene.force.kind = ForceKind::BLAST;
			scene.force.place = { -0.3, 0.4, 0.2 };
			scene.force.radius = 4.0;
			scene.force.speed = 50.0;
			scene.force.duration = 1.0;
			scene.force.age = 0.0;
			for (int i = 0; i < 90; i++) {
				scene.force.age += 1.0 / 60.0;
				scene.step();
			}
			expected = expected == 0 ? scene.hash() : expected;
			CHECK(scene.hash() == expected);
		}
	}
}

TEST_CASE("force: a blade at rest in it is where longer steps or shorter ones take it, too") {
	Eigen::Vector3f bends[3];
	const double rates[] = { 30.0, 60.0, 240.0 };
	for (int r = 0; r < 3; r++) {
		BlownScene scene(Method::DIRECT);
		scene.force.speed = 12.0;
		for (int i = 0; i < int(12.0 * rates[r]); i++) {
			scene.step(1.0 / rates[r]);
		}
		bends[r] = scene.bend();
	}
	CHECK((bends[0] - bends[1]).norm() < 2e-3f);
	CHECK((bends[2] - bends[1]).norm() < 2e-3f);
}
