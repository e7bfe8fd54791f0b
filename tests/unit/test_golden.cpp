// SPDX-License-Identifier: MIT
// Golden hashes: what the CPU simulation computes, bit for bit. Each scene is stepped with every precision and lane width, and the
// bits of all knots and twists are hashed. A hash that changes says that results changed, not that they are wrong: a change that is
// meant to leave results alone (another order of files, one text in place of two) has an error; one that is meant to change them
// records the new hashes. They stand in the failed checks' messages: run `./grass test unit --only golden`, copy them into the table,
// and say in the commit which step of the solver changed them.
// They are the same on every platform: nothing here comes from the C library's sin(), cos() or exp() (core/base/functions.h), no product is
// fused into a sum, and Eigen adds one number after the other.
#include "bit_hash.h"
#include "blade_scene.h"

#include "core/paint/brush.h"
#include "core/solver/simulate.h"
#include "core/species/field_blades.h"

#include <doctest/doctest.h>

#include <string>
#include <tuple>

using namespace grass;
using namespace grass::test;

namespace {

// Bent blades that nothing touches swing up.
void swing(BladeScene &r_scene) {
	r_scene.bend(1.1f);
}
// A ball that rolls through the tile, and leaves.
void roll(BladeScene &r_scene) {
	r_scene.add(GRASS_SPHERE, { -0.5f, 0.12f, 0.03f }, { 0.12f, 0.0f, 0.0f });
}
// A turned plank, thinner than a blade's segments are long, and a capsule and a hull that follow it.
void sweep(BladeScene &r_scene) {
	GrassCollider &plank = r_scene.add(GRASS_BOX, { -0.4f, 0.2f, 0.0f }, { 0.008f, 0.2f, 0.3f });
	plank.rotation = plank.rotation_before = { 0.0f, 0.38268343f, 0.0f, 0.92387953f };
	r_scene.add(GRASS_CAPSULE, { -0.6f, 0.1f, 0.1f }, { 0.05f, 0.2f, 0.0f });
	r_scene.add(GRASS_HULL, { -0.8f, 0.1f, -0.1f }, { 0.1f, 0.1f, 0.1f });
	r_scene.add(GRASS_CYLINDER, { -1.0f, 0.1f, 0.0f }, { 0.1f, 0.1f, 0.0f });
}

// Two thirds of a second: bodies move by 2.5 cm a step, a fourth of the way sunk to the ground.
BitHash run(BladeScene &r_scene) {
	BitHash hash;
	for (int i = 0; i < 40; i++) {
		for (GrassCollider &collider : r_scene.colliders) {
			const Eigen::Vector3f before(collider.position.x, collider.position.y, collider.position.z);
			BladeScene::place(collider, before, before + Eigen::Vector3f(0.025f, -0.001f, 0.001f * float(i % 3)));
		}
		r_scene.step(i == 20 ? 1.0 / 30.0 : 1.0 / 60.0); // one tick was late
		if (i % 10 == 9) {
			add_tile(hash, *r_scene.tile);
		}
	}
	return hash;
}

struct Golden {
	std::string name;
	void (*prepare)(BladeScene &r_scene);
	Method method;
	std::string lanes; // of any width
	std::string scalar_double;
	double contact_rate = CONTACT_RATE.minimum; // Hz
};

const Golden GOLDEN[] = {
	{ "swing, direct", swing, Method::DIRECT, "279df4237a9d3f5f", "bcb22603720527a7" },
	{ "swing, pbd", swing, Method::PBD, "5bcaae3b9a2dc37f", "634ce3c1631aab8b" },
	{ "ball, direct", roll, Method::DIRECT, "ff2ed5a8b7dfeb35", "4499d74836a3cb89" },
	{ "ball, direct, finer", roll, Method::DIRECT, "de8c1873d83a5437", "c62fdf36013001e3", 800.0 },
	{ "ball, pbd", roll, Method::PBD, "acf75c204ced60bc", "ad6cc5bec3beaf3c" },
	{ "edges, direct", sweep, Method::DIRECT, "8927305d251b8a78", "c1515bb99db87ba3" },
	{ "edges, direct, finer", sweep, Method::DIRECT, "32eae0b7bed66bf9", "6c10cc1998d64935", 800.0 },
	{ "edges, pbd", sweep, Method::PBD, "8cdad1f98d3226d5", "5e198d2f0b0ba710" },
};

// A field of two species on a painted hill: how blades stand at rest goes by clump, map and species.
class MappedField {
public:
	MappedField() {
		PatchParams short_blades, long_blades;
		short_blades.length_min = short_blades.length_max = 0.3;
		long_blades.seed = 7;
		const std::shared_ptr<const Patch> patches[] = { std::make_shared<const Patch>(generate_patch(short_blades)),
			std::make_shared<const Patch>(generate_patch(long_blades)) };
		const double shares[] = { 0.6, 0.4 };
		_patch = std::make_shared<const Patch>(join_patches(patches, shares));
		const SpeciesParams species[] = { { 0.6, 2.0, 0.5 }, { 0.4, 4.0, 0.3 } };
		_mix = std::make_shared<const SpeciesMix>(species, _grid, 3);
		paint();
		_layers.update(_map, _layers.get_region());
	}

	BitHash run(TileStep p_step) const {
		const FieldBlades blades(_grid, _patch, ClumpParams(), 3, _mix, &_layers);
		CpuPool pool(_patch, SLOTS);
		std::vector<GrassSlot> slots;
		std::vector<SlotGrowth> growth;
		for (int i = 0; i < SLOTS; i++) {
			GrassSlot slot;
			slot.tile = { 40 + i, 41, _grid.get_index(40 + i, 41), i };
			slot.list = { grass_tile_start(uint32_t(40 + i), 41, 3), 0, 1, GRASS_SLOT_FRESH | GRASS_SLOT_MAPPED };
			slots.push_back(slot);
			growth.push_back(blades.grow(slot));
		}
		GrassCollider ball;
		ball.anchor = { 40, 41, GRASS_SPHERE, 0 };
		ball.rotation = ball.rotation_before = { 0.0f, 0.0f, 0.0f, 1.0f };
		ball.size.x = 0.2f;
		const uint32_t list[] = { 0 };
		SolverParams params[2];
		params[1].natural_frequency = 2.0;
		StepClock clock;
		BitHash hash;
		for (int i = 0; i < 40; i++) {
			ball.position_before = { -0.4f + 0.03f * float(i), 0.3f, 0.0f, 0.0f };
			ball.position = { -0.37f + 0.03f * float(i), 0.3f, 0.0f, 0.5f };
			GrassStep steps[] = { clock.advance(params[0], 1.0 / 60.0), clock.repeat(params[1]) };
			for (GrassStep &step : steps) {
				step.field = { float(_grid.get_tile_size()), float(_grid.get_tiles_x()), float(_grid.get_tiles_z()), float(GRASS_KNOTS) };
			}
			StepInput input{ slots, { &ball, 1 }, list, {}, steps[0] };
			input.species = steps;
			input.growth = growth;
			pool.step(input, serial_for, p_step);
			for (GrassSlot &slot : slots) {
				slot.list.w &= ~uint32_t(GRASS_SLOT_FRESH);
			}
			growth.clear();
			if (i % 13 == 0) {
				add_pool(hash, pool);
			}
		}
		return hash;
	}

private:
	static constexpr int SLOTS = 3;

	static void add_pool(BitHash &r_hash, const CpuPool &p_pool) {
		for (int slot = 0; slot < SLOTS; slot++) {
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				for (const Eigen::Vector3f &knot : p_pool.get_knots(slot, b)) {
					r_hash.add({ knot.data(), 3 });
				}
			}
		}
	}
	void paint() {
		_map.set_base_density(1.0);
		const Eigen::Vector3d normal = Eigen::Vector3d(-0.4, 1.0, -0.25).normalized();
		for (int j = -8; j < 8; j++) {
			for (int i = -8; i < 8; i++) {
				_map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(0.4 * (i + 0.5) + 0.25 * (j + 0.5)));
				_map.set_code(MAP_NORMAL, 0, i, j, info_of(MAP_NORMAL).code(normal.x()));
				_map.set_code(MAP_NORMAL, 1, i, j, info_of(MAP_NORMAL).code(normal.z()));
			}
		}
		const auto disc = [](double p_x, double p_radius) {
			return MapShape::stroke({ p_x, 0.7 }, { p_x, 0.7 }, p_radius, 1.0, Falloff::LINEAR);
		};
		Brush brush;
		for (const auto &[tool, target, place] : { std::tuple(MapTool::CUT, 0.15, 1.2), std::tuple(MapTool::HEIGHT, 0.7, 0.3) }) {
			brush.tool = tool;
			brush.target = target;
			apply_brush(_map, disc(place, 0.8), brush);
		}
		brush.tool = MapTool::COMB;
		brush.target = 0.8;
		brush.direction = { 1.0, 0.3 };
		apply_brush(_map, MapShape::stroke({ -0.5, 0.5 }, { 0.6, 0.9 }, 0.8, 1.0, Falloff::LINEAR), brush);
	}

	TileGrid _grid = TileGrid::make(40.0, 40.0, 256.0); // 80 x 80 tiles of 0.5 m
	std::shared_ptr<const Patch> _patch;
	std::shared_ptr<const SpeciesMix> _mix;
	PaintMap _map;
	MapLayers _layers{ MapPlace{ _grid, 1.0, 0.5f } };
};

std::vector<Step> float_steps() {
	std::vector<Step> steps(get_lane_steps().begin(), get_lane_steps().end());
	steps.push_back(step_scalar_float);
	return steps;
}

} // namespace

TEST_CASE("golden: every lane width and scalar floats step these scenes to the recorded bits") {
	const std::vector<Step> steps = float_steps();
	for (const Golden &golden : GOLDEN) {
		for (size_t i = 0; i < steps.size(); i++) {
			BladeScene scene(golden.method);
			golden.prepare(scene);
			scene.params.contact_rate = golden.contact_rate;
			scene.step_function = steps[i];
			INFO(golden.name, ", width ", i);
			CHECK(run(scene).str() == golden.lanes);
			CHECK(scene.distance_from_rest() > 0.02f); // nothing is recorded of blades that nothing moves
		}
	}
}

TEST_CASE("golden: scalar doubles step these scenes to the recorded bits") {
	for (const Golden &golden : GOLDEN) {
		BladeScene scene(golden.method);
		golden.prepare(scene);
		scene.params.contact_rate = golden.contact_rate;
		scene.step_function = step_scalar_double;
		INFO(golden.name);
		CHECK(run(scene).str() == golden.scalar_double);
	}
}

TEST_CASE("golden: a painted field of two species steps to the recorded bits") {
	const MappedField field;
	for (const Step step : float_steps()) {
		CHECK(field.run(step).str() == "4c0ddfcb047f2415");
	}
	CHECK(field.run(step_scalar_double).str() == "c1c6a3158c6de80f");
}
