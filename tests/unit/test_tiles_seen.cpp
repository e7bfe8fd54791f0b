// SPDX-License-Identifier: MIT
// Who gets the slots of a pool that is too small for a crowd: tiles that cameras see, near ones first.
#include "tile_scene.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int POOL = 64, STEPS = 24;
constexpr float MARGIN = 5.0f; // metres around the picture that are simulated
constexpr float LEFT = -8.5f, RIGHT = 8.4f; // where pictures end that show three columns of balls, with what is near them. Metres

// 400 balls, each in a tile of its own: every second one of both directions, from right to left.
std::vector<ColliderShape> make_crowd(const TileManager &p_manager) {
	std::vector<ColliderShape> crowd;
	for (int x = 38; x >= 0; x -= 2) {
		for (int z = 0; z < 40; z += 2) {
			crowd.push_back(make_ball(p_manager, x, z));
		}
	}
	return crowd;
}

// Looks at what lies left of p_x (p_sign 1) or right of it (-1) from p_eye on the ground. Metres.
void look(TileManager &r_manager, float p_x, float p_eye, float p_sign = 1.0f) {
	Frustum frustum;
	frustum.fill(Eigen::Vector4f(p_sign, 0.0f, 0.0f, p_sign * p_x));
	const Eigen::Vector3f eye(p_eye, 0.0f, 0.0f);
	r_manager.get_view().see(std::vector<Frustum>{ frustum }, MARGIN, std::span(&eye, 1));
}

Eigen::Vector3d place_of(const ColliderShape &p_ball) {
	return p_ball.now.position;
}

bool is_awake(const TileManager &p_manager, const ColliderShape &p_ball) {
	const TilePlace tile = p_manager.get_grid().get_place(place_of(p_ball));
	return p_manager.is_awake(p_manager.get_grid().get_index(tile.x, tile.z));
}

// Balls between p_left and p_right (metres) whose tiles sleep.
int count_asleep(const TileManager &p_manager, const std::vector<ColliderShape> &p_crowd, double p_left, double p_right) {
	int asleep = 0;
	for (const ColliderShape &ball : p_crowd) {
		asleep += place_of(ball).x() > p_left && place_of(ball).x() < p_right && !is_awake(p_manager, ball);
	}
	return asleep;
}

void take_steps(TileManager &r_manager, const std::vector<ColliderShape> &p_crowd, int p_count = STEPS) {
	for (int i = 0; i < p_count; i++) {
		step(r_manager, p_crowd, 1.0 / 64.0);
		if (r_manager.get_statistics().simulated == r_manager.get_statistics().awake) {
			check_consistent(r_manager);
		}
	}
}

} // namespace

TEST_CASE("seen: at once a crowd's slots go to what the camera sees, in whatever order the bodies come") {
	TileManager manager = make_manager(POOL);
	const std::vector<ColliderShape> crowd = make_crowd(manager);
	look(manager, LEFT, 0.0f);
	take_steps(manager, crowd, 1);
	CHECK(count_asleep(manager, crowd, -10.0, -7.5) == 0); // 60 balls
	CHECK(manager.get_statistics().awake == POOL); // the others get what is left
	take_steps(manager, crowd);
	CHECK(manager.get_statistics().woken == POOL);
	CHECK(manager.get_statistics().yielded == 0);
}

TEST_CASE("seen: where no view is known the order of the bodies decides, as ever") {
	TileManager manager = make_manager(POOL);
	const std::vector<ColliderShape> crowd = make_crowd(manager);
	take_steps(manager, crowd);
	for (size_t i = 0; i < crowd.size(); i++) {
		CHECK(is_awake(manager, crowd[i]) == (i < POOL));
	}
	CHECK(manager.get_statistics().ranked == 0);
	CHECK(manager.get_statistics().yielded == 0);
}

TEST_CASE("seen: a camera that turns gives slots from what it leaves to what it sees, some in each step") {
	TileManager manager = make_manager(POOL);
	std::vector<ColliderShape> crowd = make_crowd(manager);
	for (const bool stamped : { false, true }) {
		for (size_t i = 0; i < crowd.size(); i++) {
			crowd[i].stamp = stamped ? i + 1 : 0;
		}
		manager.reset();
		look(manager, LEFT, 0.0f);
		take_steps(manager, crowd);
		look(manager, RIGHT, 0.0f, -1.0f);
		int steps = 0;
		for (; steps < STEPS && count_asleep(manager, crowd, 7.0, 10.0) > 0; steps++) {
			const TileStatistics before = manager.get_statistics();
			take_steps(manager, crowd, 1);
			const TileStatistics &now = manager.get_statistics();
			CHECK(now.yielded - before.yielded <= uint64_t(manager.get_params().most_yielding()));
			CHECK(now.woken - before.woken == now.yielded - before.yielded);
		}
		CHECK(steps > 1);
		CHECK(steps <= 1 + (60 + manager.get_params().most_yielding() - 1) / manager.get_params().most_yielding());
		const uint64_t woken = manager.get_statistics().woken;
		take_steps(manager, crowd);
		CHECK(manager.get_statistics().woken == woken);
		CHECK(manager.get_statistics().awake == POOL);
	}
}

TEST_CASE("seen: where not all that is seen finds a slot, near tiles win over far ones") {
	TileManager manager = make_manager(POOL);
	const std::vector<ColliderShape> crowd = make_crowd(manager);
	for (const float eye : { -10.0f, 10.0f, -10.0f }) {
		look(manager, 100.0f, eye);
		take_steps(manager, crowd);
		double farthest_awake = 0.0, nearest_asleep = 100.0;
		for (const ColliderShape &ball : crowd) {
			const double distance = (place_of(ball) - Eigen::Vector3d(eye, 0.0, 0.0)).norm();
			double &bound = is_awake(manager, ball) ? farthest_awake : nearest_asleep;
			bound = is_awake(manager, ball) ? std::max(bound, distance) : std::min(bound, distance);
		}
		CHECK(farthest_awake < 1.5 * nearest_asleep);
		CHECK(nearest_asleep > 4.0);
	}
}

TEST_CASE("seen: nothing flickers where a camera trembles, walks to and fro or nods") {
	TileManager manager = make_manager(POOL);
	const std::vector<ColliderShape> crowd = make_crowd(manager);
	look(manager, -6.0f, -9.0f);
	take_steps(manager, crowd);
	const uint64_t woken = manager.get_statistics().woken;
	for (int i = 0; i < 100; i++) {
		look(manager, -6.0f + (i % 2 == 0 ? 0.9f : -0.9f), -9.0f + (i % 3 == 0 ? 0.2f : -0.2f));
		take_steps(manager, crowd, 1);
	}
	CHECK(manager.get_statistics().woken - woken <= 20); // a column of balls once: no tile comes twice
	const uint64_t once = manager.get_statistics().woken;
	for (int i = 0; i < 100; i++) {
		look(manager, -6.0f + (i % 2 == 0 ? 0.9f : -0.9f), -9.0f + (i % 3 == 0 ? 0.2f : -0.2f));
		take_steps(manager, crowd, 1);
	}
	CHECK(manager.get_statistics().woken == once);
}

TEST_CASE("seen: bodies out of view take no slot from grass that still swings in view") {
	TileManager manager = make_manager(POOL);
	std::vector<ColliderShape> crowd = make_crowd(manager);
	look(manager, LEFT, 0.0f);
	take_steps(manager, crowd);
	std::vector<ColliderShape> right; // those in view have gone
	for (ColliderShape &ball : crowd) {
		if (place_of(ball).x() > 0.0) {
			right.push_back(ball);
		}
	}
	take_steps(manager, right, 2);
	CHECK(count_asleep(manager, crowd, -10.0, -7.5) == 0);
	right.push_back(make_ball(manager, 1, 1)); // but another one in view does
	take_steps(manager, right, 1);
	CHECK(is_awake(manager, right.back()));
	CHECK(count_asleep(manager, crowd, -10.0, -7.5) <= 1);
}

TEST_CASE("seen: the work of a step is bounded, however large the crowd") {
	TileManager manager = make_manager(POOL);
	std::vector<ColliderShape> crowd = make_crowd(manager);
	for (ColliderShape &ball : crowd) {
		ball.size.x() = 0.4; // nine tiles each
	}
	for (int i = 0; i < STEPS; i++) {
		look(manager, i % 8 < 4 ? 100.0f : LEFT, i % 2 == 0 ? -10.0f : 10.0f);
		const TileStatistics before = manager.get_statistics();
		take_steps(manager, crowd, 1);
		const TileStatistics &now = manager.get_statistics();
		const uint64_t tiles = POOL + uint64_t(manager.get_params().most_yielding());
		CHECK(now.ranked > before.ranked);
		CHECK(now.ranked - before.ranked <= crowd.size() + POOL + 9 * tiles);
		CHECK(now.looked_at - before.looked_at <= uint64_t(manager.get_params().list_capacity()) + 9 * crowd.size());
	}
}

TEST_CASE("seen: where bodies fill the list of meetings, those in view are in it, though they come last") {
	TileManager manager = make_manager(POOL);
	std::vector<ColliderShape> crowd(10000, make_ball(manager, 30));
	for (int z = 0; z < 40; z += 2) {
		crowd.push_back(make_ball(manager, 1, z));
	}
	look(manager, LEFT, 0.0f);
	take_steps(manager, crowd, 3);
	CHECK(count_asleep(manager, crowd, -10.0, -8.0) == 0);
	CHECK(manager.is_awake(30));
	CHECK(int(manager.get_collider_list().size()) <= manager.get_list_capacity());
}
