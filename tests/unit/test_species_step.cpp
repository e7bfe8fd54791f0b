// SPDX-License-Identifier: MIT
// Several species in one step: how each stands, and how each swings.
#include "species_scene.h"

#include "core/base/half.h"
#include "core/solver/simulate.h"
#include "core/solver/solver_params.h"
#include "core/species/field_blades.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

TEST_CASE("field_blades: an awake tile of two species stands at rest as its blades grow") {
	const SpeciesParams params[] = { { 0.5, 4.0, 0.0 }, { 0.5, 4.0, 0.0 } };
	const auto mix = std::make_shared<const SpeciesMix>(params, SPECIES_GRID, 0);
	const FieldBlades blades(SPECIES_GRID, two_patches(), ClumpParams(), 0, mix, nullptr);
	CpuPool pool(two_patches(), 4);
	const GrassSlot slot = fresh_slot(SPECIES_GRID, 33, 21);
	const SlotGrowth growth = blades.grow(slot);
	StepInput input;
	input.step.field = { float(SPECIES_GRID.get_tile_size()), float(SPECIES_GRID.get_tiles_x()), float(SPECIES_GRID.get_tiles_z()),
		float(GRASS_KNOTS) };
	input.slots = { &slot, 1 };
	input.growth = { &growth, 1 };
	pool.step(input);
	int second = 0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const FieldBlades::Pose pose = blades.get_pose(33, 21, b);
		CHECK(pose.species == int(growth.species[size_t(b)]));
		CHECK(pose.blade == int(slot.list.x) + b + GRASS_PATCH_BLADES * pose.species);
		second += pose.species;
		float length = 0.0f;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			CHECK(pool.get_knots(0, b)[size_t(k)] == blades.get_rest_knot(pose, k));
			length += k == 0 ? 0.0f : (blades.get_rest_knot(pose, k) - blades.get_rest_knot(pose, k - 1)).norm();
		}
		CHECK(length / pose.clump.height == doctest::Approx(pose.species == 0 ? 0.4 : 0.8).epsilon(0.01));
	}
	CHECK(second > 16);
	CHECK(second < 48);
}

TEST_CASE("species: the tip of each species swings at its own frequency, whatever its blades are computed with") {
	constexpr double FREQUENCIES[] = { 1.2, 2.5 }; // Hz
	const SpeciesParams mixed[] = { { 0.5, 4.0, 0.0 }, { 0.5, 4.0, 0.0 } };
	const auto mix = std::make_shared<const SpeciesMix>(mixed, SPECIES_GRID, 0);
	PatchParams upright;
	upright.weights = { 1.0, 0.0, 0.0, 0.0 };
	const auto one = std::make_shared<const Patch>(generate_patch(upright));
	const std::shared_ptr<const Patch> patches[] = { one, one };
	const double shares[] = { 0.5, 0.5 };
	const auto patch = std::make_shared<const Patch>(join_patches(patches, shares));
	const FieldBlades blades(SPECIES_GRID, patch, ClumpParams{ 1.6f, 0.0f, 0.0f, 0.0f }, 0, mix, nullptr);
	for (const TileStep tile_step : { step_lanes, step_scalar_double }) {
		CpuPool pool(patch, 1);
		GrassSlot slot = fresh_slot(SPECIES_GRID, 12, 12);
		const SlotGrowth growth = blades.grow(slot);
		StepClock clock;
		const auto step = [&](double p_push, double p_damping) {
			std::vector<GrassStep> steps;
			SolverParams params;
			params.damping_ratio = p_damping;
			params.width_to_thickness = 1.0; // swings as often to all sides
			clock.advance(params, 1.0 / 60.0);
			for (const double frequency : FREQUENCIES) {
				params.natural_frequency = frequency;
				params.load[0] = p_push * frequency * frequency;
				steps.push_back(clock.repeat(params));
			}
			StepInput input;
			input.step = steps[0];
			input.step.field = { float(SPECIES_GRID.get_tile_size()), float(SPECIES_GRID.get_tiles_x()), float(SPECIES_GRID.get_tiles_z()),
				float(GRASS_KNOTS) };
			input.slots = { &slot, 1 };
			input.species = steps;
			if (slot.list.w & GRASS_SLOT_FRESH) {
				input.growth = { &growth, 1 };
			}
			pool.step(input, serial_for, tile_step);
			slot.list.w &= ~uint32_t(GRASS_SLOT_FRESH);
		};
		const auto tip = [&](int p_blade) {
			const FieldBlades::Pose pose = blades.get_pose(12, 12, p_blade);
			return double((pool.get_knots(0, p_blade)[GRASS_KNOTS - 1] - blades.get_rest_knot(pose, GRASS_KNOTS - 1)).x());
		};
		for (int i = 0; i < 600; i++) {
			step(0.4, 0.7);
		}
		std::vector<double> before(GRASS_BLADES_PER_TILE), first(GRASS_BLADES_PER_TILE), last(GRASS_BLADES_PER_TILE);
		std::vector<int> crossings(GRASS_BLADES_PER_TILE);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			before[size_t(b)] = tip(b);
			CHECK(before[size_t(b)] > 0.001); // metres
		}
		for (int i = 1; i < 480; i++) {
			step(0.0, 0.0);
			for (size_t b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				const double now = tip(int(b));
				if (now * before[b] < 0.0) {
					last[b] = (i - now / (now - before[b])) / 60.0;
					first[b] = crossings[b]++ == 0 ? last[b] : first[b];
				}
				before[b] = now;
			}
		}
		for (size_t b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			INFO("blade ", b, " of species ", int(growth.species[b]));
			CHECK(0.5 * (crossings[b] - 1) / (last[b] - first[b]) == doctest::Approx(FREQUENCIES[growth.species[b]]).epsilon(0.03));
		}
	}
}

TEST_CASE("step_clock: a step repeated for other parameters is the one that a clock of their own would have given") {
	StepClock one, own;
	SolverParams field, species;
	species.natural_frequency = 3.3;
	species.damping_ratio = 0.2;
	for (const double delta : { 1.0 / 60.0, 1.0 / 30.0, 1.0 / 144.0, 0.0, 1.0 / 60.0 }) {
		one.advance(field, delta);
		const GrassStep repeated = one.repeat(species), wanted = own.advance(species, delta);
		CHECK(repeated.pbd_motion == wanted.pbd_motion);
		CHECK(repeated.free_motion == wanted.free_motion);
		CHECK(repeated.load == wanted.load);
		CHECK(repeated.contact == wanted.contact);
		CHECK(repeated.chain == wanted.chain);
		CHECK(repeated.energy == wanted.energy);
	}
}

TEST_CASE("simulate: a blade's width points where the patch's azimuth has it, and a load along it bends the blade less") {
	const std::shared_ptr<const Patch> patch = make_patch(0.5);
	CpuPool pool(patch, 1);
	GrassSlot slot = fresh_slot(SPECIES_GRID, 12, 12);
	StepClock clock;
	SolverParams params;
	params.width_to_thickness = 5.0;
	params.damping_ratio = 1.0;
	const auto step = [&](double p_load) {
		params.load[0] = p_load;
		StepInput input;
		input.step = clock.advance(params, 1.0 / 60.0);
		input.step.field = { float(SPECIES_GRID.get_tile_size()), float(SPECIES_GRID.get_tiles_x()), float(SPECIES_GRID.get_tiles_z()),
			float(GRASS_KNOTS) };
		input.step.clump = { 1.6f, 0.0f, 0.0f, 0.0f };
		input.slots = { &slot, 1 };
		pool.step(input, serial_for, step_lanes);
		slot.list.w &= ~uint32_t(GRASS_SLOT_FRESH);
	};
	const auto tip = [&](int p_blade) { return pool.get_knots(0, p_blade)[GRASS_KNOTS - 1]; };
	step(0.0);
	std::array<Eigen::Vector3f, GRASS_BLADES_PER_TILE> rest;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		rest[size_t(b)] = tip(b);
	}
	for (int i = 0; i < 300; i++) {
		step(1.0);
	}
	Eigen::Vector2f along = Eigen::Vector2f::Zero(), across = Eigen::Vector2f::Zero(); // how far tips have gone, metres, and how many
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float azimuth = half_to_float(patch->texels[Patch::texel_index(int(slot.list.x) + b, 0) + 2]);
		const Eigen::Vector2f one((tip(b) - rest[size_t(b)]).norm(), 1.0f);
		const float share = std::abs(std::cos(azimuth)); // of the load that is along its width
		along += share > 0.9f ? one : Eigen::Vector2f(0.0f, 0.0f);
		across += share < 0.3f ? one : Eigen::Vector2f(0.0f, 0.0f);
	}
	CHECK(along.y() >= 8.0f);
	CHECK(across.y() >= 8.0f);
	MESSAGE("along the width " << along.x() / along.y() << " m, across it " << across.x() / across.y());
	CHECK(across.x() / across.y() > 2.0f * along.x() / along.y());
}
