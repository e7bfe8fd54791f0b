// SPDX-License-Identifier: MIT
// What is not simulated since nobody sees it, and that it is right again when somebody does.
#include "tile_scene.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double TICK = 1.0 / 64.0; // seconds; sums of it are exact

// Sees x < p_x, metres.
Frustum left_of(float p_x) {
	Frustum frustum;
	frustum.fill(Eigen::Vector4f(1.0f, 0.0f, 0.0f, p_x));
	return frustum;
}

void see_nothing(TileManager &r_manager) {
	r_manager.get_view().see(std::vector<Frustum>{ left_of(-1000.0f) }, 0.0f);
}

int steps(TileManager &r_manager, const std::vector<ColliderShape> &p_colliders, double p_seconds) {
	const uint64_t before = r_manager.get_statistics().tile_steps;
	for (double time = 0.0; time < p_seconds; time += TICK) {
		step(r_manager, p_colliders, TICK);
	}
	return int(r_manager.get_statistics().tile_steps - before);
}

ColliderShape pushed(ColliderShape p_ball) {
	p_ball.before.position.x() -= 0.01;
	return p_ball;
}

} // namespace

TEST_CASE("view: in view, and where no view is known, every tile is simulated") {
	TileManager manager = make_manager();
	const ColliderShape ball = make_ball(manager, 3, 5);
	CHECK(steps(manager, { ball }, 2.0) == 128);
	manager.get_view().see(std::vector<Frustum>{ left_of(0.0f) }, 0.0f); // tile 3 lies at x = -8.25
	CHECK(steps(manager, { ball }, 2.0) == 128);
}

TEST_CASE("view: out of view a tile is simulated while something moves in it, and half a second longer") {
	TileManager manager = make_manager();
	see_nothing(manager);
	const ColliderShape ball = make_ball(manager, 3, 5);
	CHECK(steps(manager, { pushed(ball) }, 2.0) == 128);
	CHECK(steps(manager, { ball }, 2.0) == 31); // the step at 0.5 s is left out
	CHECK(manager.get_statistics().awake == 1);
	CHECK(manager.get_statistics().list_entries == 0);
	CHECK(steps(manager, { pushed(ball) }, TICK) == 1); // at once
	CHECK(manager.get_statistics().list_entries == 1);
}

TEST_CASE("view: a tile that is seen again goes on in its slot, where it stopped") {
	TileManager manager = make_manager();
	const ColliderShape ball = make_ball(manager, 3, 5);
	const int tile = manager.get_grid().get_index(3, 5);
	step(manager, { pushed(ball) }, TICK);
	const int slot = manager.get_slot_of(tile);
	see_nothing(manager);
	steps(manager, { ball }, 1.0);
	CHECK(steps(manager, { ball }, 60.0) == 0);
	manager.get_view().see_all();
	REQUIRE(step(manager, { ball }, TICK) == 1);
	CHECK(manager.get_slots()[0].tile.w == slot);
	CHECK(flags_of(manager.get_slots()[0]) == 0); // not fresh: its blades are where they were
	CHECK(manager.get_slots()[0].list.z == 1);
	CHECK(manager.get_statistics().woken == 1);
}

TEST_CASE("view: a tile left alone out of view is at rest without being led there, by the time at which it would be") {
	TileManager manager = make_manager();
	const ColliderShape ball = make_ball(manager, 3, 5);
	const int tile = manager.get_grid().get_index(3, 5);
	see_nothing(manager);
	step(manager, { pushed(ball) }, TICK);
	CHECK(steps(manager, {}, 2.5 - 2 * TICK) == 31);
	CHECK(manager.is_awake(tile));
	step(manager, {}, TICK);
	REQUIRE(step(manager, {}, TICK) <= 1);
	steps(manager, {}, 2 * TICK);
	CHECK_FALSE(manager.is_awake(tile));
	CHECK(manager.get_statistics().slept == 1);
	CHECK(manager.get_statistics().evicted == 0);
}

TEST_CASE("view: seen again before that, it swings on and is led to rest") {
	TileManager manager = make_manager();
	see_nothing(manager);
	step(manager, { pushed(make_ball(manager, 3, 5)) }, TICK);
	steps(manager, {}, 1.0);
	manager.get_view().see_all();
	CHECK(steps(manager, {}, 0.5) == 32);
	int settled = 0;
	for (int i = 0; i < 128; i++) {
		settled += step(manager, {}, TICK) == 1 && flags_of(manager.get_slots()[0]) == GRASS_SLOT_SETTLING ? 1 : 0;
	}
	CHECK(settled == 32); // settle_time
	CHECK(manager.get_statistics().slept == 1);
}

TEST_CASE("view: a frustum, its margin, and several of them") {
	TileManager manager = make_manager(); // tiles of 0.5 m from -10 m on
	const std::vector<ColliderShape> balls = { make_ball(manager, 3, 5), make_ball(manager, 23, 5), make_ball(manager, 36, 5) };
	steps(manager, balls, 1.0);
	const auto seen = [&](const std::vector<Frustum> &p_frustums, float p_margin) {
		manager.get_view().see(p_frustums, p_margin);
		const int count = step(manager, balls, TICK);
		CHECK(manager.get_statistics().list_entries == count);
		return count;
	};
	Frustum right;
	right.fill(Eigen::Vector4f(-1.0f, 0.0f, 0.0f, -5.0f)); // x > 5 m
	CHECK(seen({ left_of(0.0f) }, 0.0f) == 1);
	CHECK(seen({ left_of(0.0f) }, 1.4f) == 1);
	CHECK(seen({ left_of(0.0f) }, 1.6f) == 2); // the second stands at 1.5 m
	CHECK(seen({ left_of(0.0f), right }, 0.0f) == 2);
	CHECK(seen({}, 100.0f) == 0);
	CHECK_FALSE(manager.is_field_seen());
	manager.get_view().see(std::vector<Frustum>{ left_of(-10.5f) }, 0.4f);
	CHECK_FALSE(manager.is_field_seen());
	manager.get_view().see(std::vector<Frustum>{ left_of(-10.5f) }, 0.6f);
	CHECK(manager.is_field_seen());
	manager.get_view().see_all();
	CHECK(manager.is_field_seen());
	CHECK(step(manager, balls, TICK) == 3);
}

TEST_CASE("view: after steps that were left out, what is past is at rest at once, and what is touched stays") {
	TileManager manager = make_manager();
	const ColliderShape stays = make_ball(manager, 3, 5), goes = make_ball(manager, 23, 5);
	step(manager, { stays, goes }, TICK);
	manager.pass_unseen(1.0);
	CHECK(step(manager, { stays, goes }, TICK) == 2);
	manager.pass_unseen(60.0);
	REQUIRE(step(manager, { stays }, TICK) == 2);
	CHECK(flags_of(manager.get_slots()[0]) == GRASS_SLOT_RETIRED);
	CHECK(manager.get_slots()[0].tile.x == 23);
	CHECK(flags_of(manager.get_slots()[1]) == 0);
	CHECK(manager.get_statistics().slept == 1);
	step(manager, {}, TICK);
	CHECK(manager.get_statistics().awake == 1); // only that one step
}

TEST_CASE("view: a tile out of view whose ground changed is moved once") {
	TileManager manager = make_manager();
	const ColliderShape ball = make_ball(manager, 3, 5);
	see_nothing(manager);
	step(manager, { ball }, TICK);
	steps(manager, { ball }, 1.0);
	CHECK(steps(manager, { ball }, 1.0) == 0);
	const auto stir = [&](int p_x) {
		TileRange range;
		range.x_begin = p_x;
		range.x_end = p_x + 2;
		range.z_begin = 0;
		range.z_end = 40;
		manager.stir(range);
	};
	stir(4);
	CHECK(step(manager, { ball }, TICK) == 0);
	stir(2);
	REQUIRE(step(manager, { ball }, TICK) == 1);
	CHECK(manager.get_slots()[0].list.z == 1);
	manager.stir({});
	CHECK(steps(manager, { ball }, 1.0) <= 32); // half a second, as after any motion
	CHECK(steps(manager, { ball }, 1.0) == 0);
}

TEST_CASE("view: tiles on hills are seen where their ground may be") {
	TileManager manager = make_manager();
	TileParams params = manager.get_params();
	params.low = -2.0;
	params.height = 30.0;
	manager.set_params(params);
	Frustum above;
	above.fill(Eigen::Vector4f(0.0f, -1.0f, 0.0f, -20.0f)); // y > 20 m
	manager.get_view().see(std::vector<Frustum>{ above }, 0.0f);
	CHECK(manager.is_field_seen());
	above.fill(Eigen::Vector4f(0.0f, 1.0f, 0.0f, -1.5f)); // y < -1.5 m
	manager.get_view().see(std::vector<Frustum>{ above }, 0.0f);
	CHECK(manager.is_field_seen());
	above.fill(Eigen::Vector4f(0.0f, 1.0f, 0.0f, -2.5f));
	manager.get_view().see(std::vector<Frustum>{ above }, 0.0f);
	CHECK_FALSE(manager.is_field_seen());
}
