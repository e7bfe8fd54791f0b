// SPDX-License-Identifier: MIT
// How many of a field's blades its ticks simulate: what cameras need, within a budget.
#include "field_scene.h"

using namespace grass;
using namespace grass::test;

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

TEST_CASE("field: a tile's blades move by their strains some time after a body was near, sooner the faster swings die down") {
	const auto count = [](bool p_leaves, double p_damping) {
		FieldScene scene;
		scene.params.solver.damping_ratio = p_damping;
		scene.params.sleep_delay = 60.0;
		scene.field.set(scene.setup, scene.field.bounds_of(scene.setup), nullptr, {}, scene.params);
		scene.field.see(scene.simulator, view_from(2.0f), true);
		scene.put_ball({ 0.5, 0.2, 0.5 });
		int ticks = 0;
		for (int i = 0; i < 160; i++) {
			if (i == 10 && p_leaves) {
				scene.bodies.clear();
			}
			scene.tick();
			const auto alone = std::ranges::count_if(
					scene.simulator.slots, [](const GrassSlot &p_slot) { return (p_slot.list.w & GRASS_SLOT_ALONE) != 0; });
			CHECK((i > 10 || alone < int(scene.simulator.slots.size()))); // not the one under the ball
			ticks += i > 10 && alone == int(scene.simulator.slots.size()) ? 1 : 0;
		}
		return ticks;
	};
	CHECK(count(false, 0.5) == 0);
	CHECK(count(true, 0.5) > 60);
	CHECK(count(true, 1.0) > count(true, 0.5));
	CHECK(count(true, 0.25) < count(true, 0.5));
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
