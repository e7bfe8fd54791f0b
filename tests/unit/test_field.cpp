// SPDX-License-Identifier: MIT
// Whole ticks without an engine: bodies in, blades out.
#include "field_scene.h"
#include "species_scene.h"

#include "core/field/canopy.h"
#include "core/field/grass_at.h"
#include "core/map/map_layers.h"

#include <limits>

using namespace grass;
using namespace grass::test;

TEST_CASE("field: a ball bends the blades of its tile, which rise and sleep when it has gone") {
	FieldScene scene;
	scene.ticks(2);
	CHECK(scene.simulator.steps == 0); // nothing is awake
	scene.put_ball({ 0.5, 0.2, 0.5 });
	scene.ticks(20);
	CHECK(scene.simulator.steps == 20);
	CHECK(scene.bend_of(8, 8) > 0.05);
	CHECK(scene.bend_of(0, 0) == 0.0);
	scene.bodies.clear();
	scene.ticks(60);
	CHECK(scene.field.get_tiles().get_statistics().awake == 0);
	CHECK(scene.bend_of(8, 8) == 0.0);
	CHECK(scene.simulator.steps < 80);
}

TEST_CASE("canopy: grass that a ball presses hides less at its old height, and all of it stands again [Eq V2]") {
	FieldScene scene;
	scene.setup.clump = { 1.6f, 0.0f, 0.0f, 0.0f };
	scene.field.set(scene.setup, scene.field.bounds_of(scene.setup), nullptr, {}, scene.params);
	const auto hidden = [&](double p_height) {
		return hidden_share(scene.field, [](const Eigen::Vector2f &) { return nullptr; }, { 0.1, p_height, 0.5 }, { 0.9, p_height, 0.5 });
	};
	const double high = scene.setup.patch->mean_height - 0.01, before = hidden(high), low = hidden(0.01);
	CHECK(before > 0.1);
	scene.put_ball({ 0.5, 0.1, 0.5 });
	scene.bodies[0].size.x() = 0.6;
	scene.ticks(20);
	CHECK(hidden(high) < 0.5 * before);
	CHECK(hidden(0.01) > low); // the same blades in less height
	scene.bodies.clear();
	scene.ticks(240);
	CHECK(hidden(high) == doctest::Approx(before));
}

TEST_CASE("field: blades go on to the bit while the pool becomes smaller and larger") {
	FieldScene still, changed;
	for (FieldScene *scene : { &still, &changed }) { // slot 0 falls asleep, so that the tile under the ball has a later one
		scene->put_ball({ -3.5, 0.2, -3.5 });
		scene->ticks(5);
		scene->put_ball({ 0.5, 0.2, 0.5 });
		scene->ticks(40);
	}
	REQUIRE(still.field.get_tiles().get_statistics().awake <= 9);
	bool has_moved = false;
	for (const int slots : { 300, 9, 12, 10 }) {
		changed.field.set_pool_size(changed.simulator, slots);
		has_moved = has_moved || !changed.simulator.moves.empty();
		CHECK(changed.field.get_setup().pool_size == slots);
		CHECK(changed.field.get_tiles().get_params().pool_size == slots);
		CHECK(changed.bend_of(8, 8) == still.bend_of(8, 8)); // before the next tick, too
		still.ticks(3);
		changed.ticks(3);
		CHECK(changed.bend_of(8, 8) == still.bend_of(8, 8));
	}
	CHECK(has_moved);
	CHECK(still.bend_of(8, 8) > 0.05);
}

TEST_CASE("field: one that is put to rest, or is gone, leaves its slots to others, though it has no ticks") {
	const auto budget = std::make_shared<PoolBudget>(100);
	{
		FieldScene scene(budget);
		scene.put_ball({ 0.5, 0.2, 0.5 });
		scene.ticks(5);
		const int awake = scene.field.get_tiles().get_statistics().awake;
		REQUIRE(awake > 0);
		CHECK(budget->get_used() == awake);
		scene.field.rest();
		CHECK(budget->get_used() == 0);
		scene.ticks(5);
		CHECK(budget->get_used() == awake);
	}
	CHECK(budget->get_used() == 0);
}

TEST_CASE("field: the same ticks make the same bits") {
	FieldScene one, other;
	for (FieldScene *scene : { &one, &other }) {
		for (int i = 0; i < 30; i++) {
			scene->put_ball({ -2.0 + 0.1 * i, 0.2, 0.25 }, { -2.1 + 0.1 * i, 0.2, 0.25 });
			scene->tick();
		}
	}
	REQUIRE(one.simulator.slots.size() == other.simulator.slots.size());
	for (const GrassSlot &slot : one.simulator.slots) {
		CHECK(one.simulator.read_knots(slot.tile.w, 5) == other.simulator.read_knots(slot.tile.w, 5));
	}
}

TEST_CASE("field: ticks that nobody sees are left out, unless somebody listens, and time has passed when it is seen again") {
	FieldScene scene;
	scene.put_ball({ 0.5, 0.2, 0.5 });
	scene.ticks(5);
	CHECK(scene.field.is_seen());
	scene.field.see(scene.simulator, make_view(false), true);
	CHECK_FALSE(scene.field.is_seen());
	CHECK_FALSE(scene.tick());
	CHECK(scene.simulator.steps == 5);
	CHECK(scene.field.get_unseen_ticks() == 1);
	CHECK(scene.tick(true)); // resumes
	CHECK_FALSE(scene.field.resume());
	CHECK_FALSE(scene.tick());
	scene.field.see(scene.simulator, make_view(true), true);
	REQUIRE(scene.field.begin_tick(scene.simulator, false, TICK));
	CHECK(scene.field.resume());
	CHECK_FALSE(scene.field.resume());
	scene.field.see(scene.simulator, FieldView(), false); // hidden
	CHECK_FALSE(scene.field.is_seen());
	scene.field.see(scene.simulator, FieldView(), true); // a world without a camera
	CHECK(scene.field.is_seen());
}

TEST_CASE("field: the blades of an awake tile are looked up when it wakes, and again only where the map changed") {
	FieldScene scene;
	PaintMap map;
	map.set_base_density(1.0);
	MapLayers layers({ scene.setup.grid });
	layers.update(map, layers.get_region());
	scene.field.set(scene.setup, scene.field.bounds_of(scene.setup), &layers, {}, scene.params);
	scene.put_ball({ 0.0, 0.2, 0.0 }); // on four tiles
	scene.tick();
	REQUIRE(scene.simulator.grown == 4);
	scene.tick();
	CHECK(scene.simulator.grown == 0);
	scene.field.regrow({ 8, 9, 0, 16 });
	scene.tick();
	CHECK(scene.simulator.grown == 2);
}

TEST_CASE("field: tiles that would have fallen asleep while nobody saw them are at rest once somebody does") {
	FieldScene scene;
	scene.put_ball({ 0.5, 0.2, 0.5 });
	scene.ticks(5);
	scene.bodies.clear();
	REQUIRE(scene.field.get_tiles().get_statistics().awake > 0);
	scene.field.see(scene.simulator, make_view(false), true);
	for (int i = 0; i < 60; i++) {
		CHECK_FALSE(scene.tick());
	}
	scene.field.see(scene.simulator, make_view(true), true);
	CHECK(scene.tick());
	CHECK(std::ranges::all_of(scene.simulator.slots, [](const GrassSlot &p_slot) { return p_slot.list.w & GRASS_SLOT_RETIRED; }));
}

TEST_CASE("field: while the simulation compiles grass stands, and who listens still hears of bodies in it") {
	FieldScene scene;
	scene.simulator.can = false;
	scene.put_ball({ 0.5, 0.2, 0.5 });
	CHECK_FALSE(scene.tick());
	CHECK(scene.field.get_unseen_ticks() == 0); // it is seen
	CHECK(scene.tick(true));
	CHECK(scene.simulator.steps == 0);
	CHECK(scene.field.get_tiles().get_statistics().awake == 0);
	CHECK(scene.visitors.update(scene.field.get_tiles(), scene.bodies).entered == std::vector<uint64_t>{ 7 });
	scene.simulator.can = true;
	CHECK(scene.tick());
	CHECK(scene.simulator.steps == 1);
}

TEST_CASE("field: the method is the one that it was made with, whatever its params say") {
	FieldScene scene;
	scene.put_ball({ 0.5, 0.2, 0.5 });
	scene.params.solver.method = Method::PBD;
	scene.field.set_params(scene.params);
	scene.tick();
	CHECK(scene.simulator.method == Method::DIRECT);
	REQUIRE(scene.field.get_tiles().get_statistics().awake > 0);
	scene.setup.method = Method::PBD;
	scene.params.solver.method = Method::DIRECT;
	scene.field.set(scene.setup, scene.field.bounds_of(scene.setup), nullptr, {}, scene.params);
	CHECK(scene.field.get_tiles().get_statistics().awake == 0); // made anew, at rest
	scene.tick();
	CHECK(scene.simulator.method == Method::PBD);
}

TEST_CASE("field params: tiles wait for the species that swings longest, and are calm when the quickest is") {
	FieldParams params;
	SolverParams slow = params.solver, fast = params.solver;
	slow.natural_frequency = 0.5;
	fast.natural_frequency = 4.0;
	CHECK(params.calm_time() == params.solver.calm_time());
	CHECK(params.calm_energy() == params.solver.energy_within(1e-3 * params.sleep_motion));
	params.species = { fast, slow };
	CHECK(params.calm_time() == std::max(slow.calm_time(), fast.calm_time()));
	CHECK(params.calm_time() > fast.calm_time());
	CHECK(params.calm_energy() == slow.energy_within(1e-3 * params.sleep_motion));
	CHECK(params.calm_energy() < fast.energy_within(1e-3 * params.sleep_motion));
}

TEST_CASE("field: slots that take a simulator long come ticks later, but at once where a replay must find them") {
	FieldScene scene;
	scene.simulator.at_once = 0;
	scene.put_ball({ 0.5, 0.2, 0.5 });
	scene.ticks(3);
	CHECK(scene.simulator.wanted == 16);
	CHECK(scene.simulator.made == 0);
	CHECK(scene.simulator.steps == 0);
	CHECK(scene.field.holds_slots()); // a field that rested would not go on
	scene.tick();
	CHECK(scene.simulator.made == 16);
	CHECK(scene.simulator.steps == 1);
	CHECK(scene.simulator.wanted == 0);
	CHECK(scene.field.get_tiles().get_statistics().awake > 0);
	scene.ticks(10);
	CHECK(scene.bend_of(8, 8) > 0.01);
	FieldScene left;
	left.simulator.at_once = 0;
	left.put_ball({ 0.5, 0.2, 0.5 });
	left.tick();
	left.bodies.clear();
	left.tick();
	CHECK(left.simulator.wanted == 0); // nobody needs them any more
	CHECK_FALSE(left.field.holds_slots());
	FieldScene whole;
	whole.simulator.at_once = 0;
	whole.params.detail = SimulationDetail::WHOLE;
	whole.field.set_params(whole.params);
	whole.put_ball({ 0.5, 0.2, 0.5 });
	whole.tick();
	CHECK(whole.simulator.steps == 1);
}

TEST_CASE("field: bounds are made anew for other blades only") {
	FieldScene scene;
	FieldSetup next = scene.setup;
	next.grid = TileGrid::make(8.0, 8.0, 64.0);
	const double overhang = scene.field.get_bounds()->get_overhang();
	CHECK(scene.field.bounds_of(next)->get_overhang() == overhang);
	next.clump.lean = 0.0f;
	CHECK(scene.field.bounds_of(next)->get_overhang() < overhang);
}

TEST_CASE("grass at a place: all of it without a map, and what is painted with one") {
	FieldScene scene;
	const Eigen::Vector2f place(0.5f, 0.5f);
	CHECK(density_at(place, nullptr) == 1.0);
	const double height = height_at(scene.field, place, nullptr);
	CHECK(height > 0.5 * double(scene.setup.patch->mean_height));
	CHECK(height < double(scene.setup.blade_length()));
	PaintMap painted;
	painted.set_base_density(0.0);
	MapLayers map(scene.setup.map_place());
	map.update(painted, map.get_region());
	CHECK(density_at(place, &map) == 0.0);
	CHECK(height_at(scene.field, place, &map) == 0.0);
	CHECK(kind_of(scene.field).per_area == 64.0);
}

TEST_CASE("grass at a place: where species grow in stands, work finds the height of those that grow there") {
	FieldSetup setup = make_setup();
	const SpeciesParams stands[] = { { 0.5, 4.0, 1.0 }, { 0.5, 4.0, 1.0 } };
	setup.species = std::make_shared<const SpeciesMix>(stands, setup.grid, 1);
	setup.patch = two_patches();
	const std::shared_ptr<const Patch> low = make_patch(0.4), high = make_patch(0.8, 7);
	Field field;
	field.set(setup, field.bounds_of(setup), nullptr, { low, high }, FieldParams());
	const GrassKind kind = kind_of(field);
	REQUIRE(kind.height_at);
	int lowest = 0, highest = 0;
	for (double x = -7.5; x < 8.0; x += 0.5) {
		const double height = kind.height_at({ x, 0.9 * x });
		lowest += height < 1.05 * double(low->mean_height) ? 1 : 0;
		highest += height > 0.95 * double(high->mean_height) ? 1 : 0;
	}
	CHECK(lowest > 3);
	CHECK(highest > 3);
}

TEST_CASE("visitors: a body is listed once when it comes and once when it goes, however many shapes it has") {
	FieldScene scene;
	scene.put_ball({ 0.5, 0.2, 0.5 });
	scene.bodies.push_back(scene.bodies[0]);
	scene.tick();
	Visitors::Change change = scene.visitors.update(scene.field.get_tiles(), scene.bodies);
	CHECK(change.entered == std::vector<uint64_t>{ 7 });
	CHECK(change.exited.empty());
	scene.tick();
	change = scene.visitors.update(scene.field.get_tiles(), scene.bodies);
	CHECK(change.entered.empty());
	CHECK(change.exited.empty());
	scene.bodies.clear();
	scene.tick();
	change = scene.visitors.update(scene.field.get_tiles(), scene.bodies);
	CHECK(change.exited == std::vector<uint64_t>{ 7 });
	CHECK(scene.visitors.leave().empty());
}
