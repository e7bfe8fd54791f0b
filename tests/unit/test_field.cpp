// SPDX-License-Identifier: MIT
// Whole ticks without an engine: bodies in, blades out.
#include "core/field/field.h"

#include "grown_tile.h"

#include "core/field/canopy.h"
#include "core/field/grass_at.h"
#include "core/field/visitors.h"
#include "core/solver/simulate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double TICK = 1.0 / 60.0;

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
		moves.assign(p_moves.begin(), p_moves.end());
	}
	EnergyReport read_energy() override { return { _step > 0 ? _step - 1 : 0, _pool.get_energy(), _pool.get_bends() }; }
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
	StepTime time; // of steps; 0 ms: the device measures none
	std::vector<GrassSlot> joined;
	std::vector<SlotMove> moves; // of the last change of the pool's size

private:
	CpuPool _pool;
	uint64_t _step = 0;
};

FieldSetup make_setup() {
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

	FieldScene() {
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
	// The farthest that a knot of a tile is from where it is at rest, metres.
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

// A camera whose six planes hold nothing, or all, of the field.
FieldView make_view(bool p_sees) {
	ViewCamera camera;
	camera.planes.fill(Eigen::Vector4f(1.0f, 0.0f, 0.0f, p_sees ? 1000.0f : -1000.0f));
	FieldView view;
	view.cameras = { camera };
	return view;
}

} // namespace

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

namespace {

FieldView view_from(float p_away) {
	FieldView view = make_view(true);
	view.cameras[0].eye = { p_away, 1.7f, 0.0f };
	view.cameras[0].pixel_slope = 0.0014f;
	view.is_watched = true;
	return view;
}

} // namespace

TEST_CASE("field: a far camera leaves blades out, a near one makes them join, and whoever reads a blade gets it") {
	FieldScene scene;
	scene.field.see(scene.simulator, view_from(60.0f), true);
	scene.put_ball({ 0.5, 0.2, 0.5 });
	scene.ticks(10);
	const auto left_out = [&] { return int(scene.simulator.slots.front().blend.y); };
	const int far = left_out();
	CHECK(far >= 48);
	CHECK(scene.simulator.joined.empty());
	CHECK(scene.field.get_tiles().get_statistics().left_out_blades > 0);
	scene.field.see(scene.simulator, view_from(12.0f), true);
	REQUIRE_FALSE(scene.simulator.joined.empty());
	CHECK(int(scene.simulator.joined.front().blend.z) == far); // so many were left out
	scene.tick();
	CHECK(left_out() < far);
	CHECK(left_out() == int(scene.simulator.joined.front().blend.y));
	scene.field.see(scene.simulator, view_from(60.0f), true);
	scene.tick();
	REQUIRE(left_out() >= 48); // it gives blades up later than it gets them
	scene.simulator.joined.clear();
	const int tile = scene.setup.grid.get_index(8, 8);
	scene.field.ask(scene.simulator, std::span(&tile, 1));
	REQUIRE(scene.simulator.joined.size() == 1);
	scene.field.ask(scene.simulator, std::span(&tile, 1));
	CHECK(scene.simulator.joined.size() == 1); // once
	scene.tick();
	const auto asked = std::ranges::find_if(scene.simulator.slots, [tile](const GrassSlot &p_slot) { return p_slot.tile.z == tile; });
	REQUIRE(asked != scene.simulator.slots.end());
	CHECK(int(asked->blend.y) == 0);
}

TEST_CASE("field: nothing is left out without frames, with plants, with WHOLE, or while blades cannot join") {
	const auto count = [](auto &&p_change) {
		FieldScene scene;
		FieldView view = view_from(60.0f);
		p_change(scene, view);
		scene.field.see(scene.simulator, view, true);
		scene.put_ball({ 0.5, 0.2, 0.5 });
		scene.ticks(3);
		return int64_t(scene.field.get_tiles().get_statistics().left_out_blades);
	};
	CHECK(count([](FieldScene &, FieldView &) {}) > 0);
	CHECK(count([](FieldScene &, FieldView &r_view) { r_view.is_drawn = false; }) == 0);
	CHECK(count([](FieldScene &r_scene, FieldView &) { r_scene.simulator.joins = false; }) == 0);
	CHECK(count([](FieldScene &r_scene, FieldView &) {
		r_scene.params.detail = SimulationDetail::WHOLE;
		r_scene.field.set_params(r_scene.params);
	}) == 0);
	CHECK(count([](FieldScene &r_scene, FieldView &) {
		r_scene.setup.has_plants = true;
		r_scene.field.set(r_scene.setup, r_scene.field.bounds_of(r_scene.setup), nullptr, {}, r_scene.params);
	}) == 0);
}

TEST_CASE("field: chains are halved in far tiles once their blades are calm and no body is near, and only by METHOD_DIRECT") {
	const auto count = [](float p_away, bool p_leaves, Method p_method = Method::DIRECT) {
		FieldScene scene;
		scene.setup.method = scene.params.solver.method = p_method;
		scene.params.sleep_delay = 60.0;
		scene.field.set(scene.setup, scene.field.bounds_of(scene.setup), nullptr, {}, scene.params);
		scene.field.see(scene.simulator, view_from(p_away), true);
		scene.put_ball({ 0.5, 0.2, 0.5 });
		int halved = 0;
		for (int i = 0; i < 60; i++) {
			if (i == 10 && p_leaves) {
				scene.bodies.clear();
			}
			scene.tick();
			const int now = int(std::ranges::count_if(
					scene.simulator.slots, [](const GrassSlot &p_slot) { return (p_slot.list.w & GRASS_SLOT_HALVED) != 0; }));
			CHECK((i > 10 || now < int(scene.simulator.slots.size()))); // the one under the ball has none
			halved = now;
		}
		return halved;
	};
	CHECK(count(30.0f, true) > 0);
	CHECK(count(30.0f, true) > count(30.0f, false));
	CHECK(count(2.0f, true) == 0);
	CHECK(count(30.0f, true, Method::PBD) == 0);
}

TEST_CASE("field: tiles far from every eye are marked, if contact_rate is above its least") {
	FieldScene scene;
	const auto is_far = [&](float p_away, double p_rate) {
		scene.params.solver.contact_rate = p_rate;
		scene.params.contact_distance = 4.0;
		scene.field.set_params(scene.params);
		scene.field.stir();
		scene.field.see(scene.simulator, view_from(p_away), true);
		scene.put_ball({ 0.5, 0.2, 0.5 });
		scene.ticks(2);
		return (scene.simulator.slots.front().list.w & GRASS_SLOT_FAR) != 0;
	};
	CHECK(is_far(20.0f, 1600.0));
	CHECK_FALSE(is_far(2.0f, 1600.0));
	CHECK(is_far(20.0f, 800.0));
	CHECK_FALSE(is_far(20.0f, CONTACT_RATE.minimum));
}

namespace {

// 12 m away the field draws more blades than the fewest that it may simulate.
void step_with_budget(
		FieldScene &r_scene, double p_budget, double p_time, int p_steps, SimulationDetail p_detail = SimulationDetail::SEEN) {
	r_scene.params.budget = p_budget;
	r_scene.params.detail = p_detail;
	r_scene.params.sleep_delay = 60.0;
	r_scene.field.set_params(r_scene.params);
	r_scene.field.stir();
	r_scene.simulator.time.ms = p_time;
	for (int i = 0; i < p_steps; i++) {
		r_scene.field.see(r_scene.simulator, view_from(12.0f), true);
		r_scene.put_ball({ 0.5 + 0.004 * i, 0.2, 0.5 }, { 0.496 + 0.004 * i, 0.2, 0.5 });
		r_scene.tick();
	}
}

} // namespace

TEST_CASE("field: over its budget it simulates fewer of the drawn blades, and the others follow; under it, all of them again") {
	FieldScene scene;
	step_with_budget(scene, 0.0, 5.0, 10);
	CHECK(scene.simulator.followers.empty());
	const float drawn = 64.0f - scene.simulator.slots.front().blend.y;
	REQUIRE(drawn >= 24.0f);
	step_with_budget(scene, 1.0, 5.0, 150);
	CHECK(scene.field.get_coarseness() > 5.0f);
	REQUIRE_FALSE(scene.simulator.followers.empty());
	const GrassSlot &follower = scene.simulator.followers.front();
	CHECK(64.0f - follower.blend.y == drawn); // what is drawn does not change
	CHECK(follower.blend.z > follower.blend.y);
	CHECK(follower.blend.w == follower.blend.z);
	const auto record = std::ranges::find_if(scene.simulator.slots, [&](const GrassSlot &p_slot) { return p_slot.tile == follower.tile; });
	REQUIRE(record != scene.simulator.slots.end());
	CHECK(record->blend.y == follower.blend.z);
	const uint64_t followed = scene.field.get_tiles().get_statistics().followed_blades;
	CHECK(followed > 0);
	CHECK(followed < scene.field.get_tiles().get_statistics().left_out_blades);
	step_with_budget(scene, 1.0, 0.1, 250);
	CHECK(scene.field.get_coarseness() == 1.0f);
	CHECK(scene.simulator.followers.empty());
}

TEST_CASE("field: a budget leaves out nothing near an eye, of blades that a script reads, or with WHOLE") {
	FieldScene scene;
	step_with_budget(scene, 1.0, 5.0, 150);
	REQUIRE_FALSE(scene.simulator.followers.empty());
	const int tile = scene.simulator.followers.front().tile.z;
	scene.field.ask(scene.simulator, std::span(&tile, 1));
	scene.tick();
	for (const GrassSlot &follower : scene.simulator.followers) {
		CHECK(follower.tile.z != tile);
	}
	scene.field.see(scene.simulator, view_from(2.0f), true);
	scene.tick();
	CHECK(scene.simulator.followers.empty());
	step_with_budget(scene, 1.0, 5.0, 3, SimulationDetail::WHOLE);
	CHECK(scene.field.get_coarseness() == 1.0f);
	CHECK(scene.simulator.followers.empty());
	CHECK(scene.simulator.slots.front().blend.y == 0.0f);
}

TEST_CASE("field: a budget on a device without timestamps changes nothing, and the field says so") {
	FieldScene scene;
	step_with_budget(scene, 0.0, 0.0, 300);
	CHECK_FALSE(scene.field.is_budget_blind());
	step_with_budget(scene, 1.0, 0.0, 200);
	CHECK_FALSE(scene.field.is_budget_blind());
	step_with_budget(scene, 1.0, 0.0, 60);
	CHECK(scene.field.is_budget_blind());
	CHECK(scene.field.get_coarseness() == 1.0f);
	step_with_budget(scene, 1.0, 0.5, 1);
	CHECK_FALSE(scene.field.is_budget_blind());
}
