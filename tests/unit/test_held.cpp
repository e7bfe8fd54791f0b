// SPDX-License-Identifier: MIT
// Blades that something rests on: they stand still, every one of them, and rise when it leaves.
#include <doctest/doctest.h>

#include "held_bodies.h"
#include "sampled.h"

#include <string>

using namespace grass;
using namespace grass::test;

TEST_CASE("METHOD_DIRECT: two seconds after a body came to rest on them one in a hundred blades that it holds moves more than 1e-5 L a "
		  "step, and none on whose roots it stands") {
	for (const float rate : { 30.0f, 60.0f, 144.0f }) {
		CAPTURE(rate);
		const Count count = count_moving(make_rests(), rate);
		CHECK(count.held > 600);
		CHECK(count.moving <= count.held / 100);
		CHECK(count.buried > 50);
		CHECK(count.moving_buried == 0);
		MESSAGE(rate << " steps a second: " << count.moving << " of " << count.held << " move, " << count.moving_buried << " of "
					 << count.buried << " below them");
	}
}

TEST_CASE("METHOD_DIRECT: nor do two in a thousand under balls, boxes, capsules, cylinders and hulls of any size, flat and tilted") {
	for (const float rate : sampled({ 30.0f, 60.0f, 144.0f })) {
		CAPTURE(rate);
		Count all;
		for (const Kind &kind : KINDS) {
			const Count count = count_moving(make_rests(kind, 8, 11), rate);
			CAPTURE(kind.name);
			CHECK(count.held > 50);
			all.held += count.held;
			all.moving += count.moving;
			MESSAGE(std::string(kind.name) << ", " << rate << " steps a second: " << count.moving << " of " << count.held << " move");
		}
		CHECK(all.moving <= all.held / 500);
	}
}

TEST_CASE("METHOD_DIRECT: of stiff blades and of soft and slippery ones, which slide on for seconds, two in a hundred move, and of tall "
		  "dry ones three") {
	struct Grass {
		std::string name;
		double frequency, damping, friction; // Hz, -, times the body's
		int most; // that move, of a hundred
	};
	for (const Grass &grass :
			{ Grass{ "lawn", 4.0, 0.8, 1.0, 2 }, Grass{ "reed", 0.8, 0.15, 0.5, 2 }, Grass{ "tall dry grass", 0.7, 0.9, 1.5, 3 } }) {
		SolverParams params;
		params.natural_frequency = grass.frequency;
		params.damping_ratio = grass.damping;
		params.friction = grass.friction;
		for (const float rate : sampled({ 30.0f, 60.0f, 144.0f })) {
			const Count count = count_moving(make_rests(), rate, params);
			CAPTURE(grass.name);
			CAPTURE(rate);
			CHECK(count.held > 500);
			CHECK(count.moving * 100 <= count.held * grass.most);
			MESSAGE(grass.name << ", " << rate << " steps a second: " << count.moving << " of " << count.held << " move");
		}
	}
}

TEST_CASE("METHOD_DIRECT: a body that has rested on blades and then moves as slowly as 0.1 mm/s takes as many along as at 1 cm/s, up and "
		  "down") {
	constexpr float WAY = 0.006f, RATE = 30.0f; // metres; more than a touch is deep
	for (const float sign : { -1.0f, 1.0f }) {
		CAPTURE(sign);
		int left_quickly = 0;
		for (const float speed : sampled({ 1e-2f, 1e-3f, 1e-4f }, 2)) { // m/s
			int held = 0, left = 0;
			for (const Rest &rest : make_rests()) {
				if (sign < 0.0f && rest.height < half_height(rest) + 0.02f) {
					continue; // it stands on the ground
				}
				BladeScene scene = make_held(rest, RATE);
				std::vector<int> blades;
				for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
					if (is_held(scene, b)) {
						blades.push_back(b);
					}
				}
				move(scene, rest, rest.height, rest.height + sign * WAY, int(std::lround(WAY / speed * RATE)), RATE);
				for (const int b : blades) {
					held++;
					left += is_held(scene, b) ? 0 : 1;
				}
				CHECK(scene.depth() < 1e-5f);
			}
			left_quickly = speed > 5e-3f ? left : left_quickly;
			CAPTURE(speed);
			CHECK(held > 400);
			CHECK(left < held / 10);
			CHECK(left <= left_quickly + held / 100);
			MESSAGE(speed << " m/s " << std::string(sign < 0.0f ? "down: " : "up: ") << left << " of " << held << " left");
		}
	}
}

TEST_CASE("METHOD_DIRECT: what a plate pressed onto a stone that stands still rises when the plate is gone at once, 99 of 100 as high as "
		  "over a stone "
		  "that trembles and so holds nothing") {
	constexpr float RADIUS = 0.045f, HIGH = 0.9f, LOW = 0.15f; // of the stone and of the plate's centre, metres
	constexpr float TREMBLE = 1e-6f; // metres
	int pressed = 0, hanging = 0; // and its tip more than 5 cm from where it would be
	for (const float aside : { 0.06f, 0.08f, 0.1f, 0.15f, 0.2f, 0.3f }) {
		float heights[2][GRASS_BLADES_PER_TILE] = {}; // of the tips, metres
		for (const bool trembles : { false, true }) {
			BladeScene scene;
			const Rest plate{ GRASS_BOX, { 0.5f, 0.05f, 0.5f }, LOW, 0.0f };
			scene.add(plate.shape, { 0.0f, HIGH, ACROSS }, plate.size);
			scene.add(GRASS_SPHERE, { aside, RADIUS, 0.0f }, { RADIUS, 0.0f, 0.0f });
			move(scene, plate, HIGH, LOW, 75, 60.0f);
			scene.step_for(2.0);
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				pressed += trembles && scene.knot(b, GRASS_KNOTS - 1).y() < LOW ? 1 : 0;
			}
			scene.colliders.erase(scene.colliders.begin());
			for (int i = 0; i < 240; i++) {
				const float now = trembles && i % 2 == 0 ? TREMBLE : 0.0f, before = trembles ? TREMBLE - now : 0.0f;
				BladeScene::place(scene.colliders[0], { aside + before, RADIUS, 0.0f }, { aside + now, RADIUS, 0.0f });
				scene.step();
			}
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				heights[trembles ? 1 : 0][b] = scene.knot(b, GRASS_KNOTS - 1).y();
			}
		}
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			hanging += std::abs(heights[0][b] - heights[1][b]) > 0.05f ? 1 : 0;
		}
	}
	MESSAGE(hanging << " of " << pressed << " hang");
	CHECK(pressed > 300);
	CHECK(hanging * 100 <= pressed);
}

TEST_CASE("METHOD_DIRECT: what a body held rises when it leaves, and is at rest four seconds later") {
	for (const Rest &rest : make_rests()) {
		CAPTURE(rest.shape);
		CAPTURE(rest.height);
		BladeScene scene = make_held(rest, 60.0f);
		scene.colliders.clear();
		scene.step_for(4.0);
		CHECK(scene.distance_from_rest() < 1e-3f);
	}
}

TEST_CASE("METHOD_DIRECT: a blade that is folded at its root and lies on the ground, away from where it leans, rises at once") {
	BladeScene scene;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float side = 0.2f + 0.2f * float(b) / float(GRASS_BLADES_PER_TILE); // of the fold, shares of a segment
		const Eigen::Vector3f tip = scene.rest(b, GRASS_KNOTS - 1);
		const Eigen::Vector3f lean = Eigen::Vector3f(tip.x() + 1e-4f, 0.0f, tip.z()).normalized();
		Eigen::Vector3f knot = scene.rest(b, 1);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3f down = lean * side - Eigen::Vector3f::UnitY() * std::sqrt(1.0f - side * side);
			const Eigen::Vector3f along = (Eigen::Vector3f::UnitY() * 0.02f * float(k - 2) - lean).normalized();
			knot += (k == GRASS_CLAMPED_KNOTS ? down : along) * (scene.length * float(GRASS_SEGMENT_SHARE));
			scene.set_knot(b, k, knot);
		}
	}
	scene.step_for(4.0);
	CHECK(scene.distance_from_rest() < 0.01f);
}

TEST_CASE("METHOD_DIRECT: what rolls over a crate that stands on roots moves none of the blades below it") {
	for (const int others : { 0, GRASS_SHARED_COLLIDERS }) {
		CAPTURE(others);
		BladeScene scene;
		for (int i = 0; i < others; i++) { // before it in the list, and nowhere near
			scene.add(GRASS_SPHERE, { 0.3f, 5.0f, 0.3f }, { 0.01f, 0.0f, 0.0f });
		}
		const Eigen::Vector3f high(0.0f, 0.9f, 0.0f), low(0.0f, 0.155f, 0.0f); // 5 mm above the ground, below where clamps end
		scene.add(GRASS_BOX, high, { 0.6f, 0.15f, 0.6f });
		for (int i = 0; i < 240; i++) {
			const auto place = [&](int p_step) { return Eigen::Vector3f(high + (low - high) * std::min(float(p_step) / 75.0f, 1.0f)); };
			BladeScene::place(scene.colliders.back(), place(i), place(i + 1));
			scene.step();
		}
		float highest = 0.0f;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			highest = std::max(highest, scene.knot(b, GRASS_KNOTS - 1).y() / scene.length);
		}
		CHECK(highest < LYING);
		scene.add(GRASS_SPHERE, high, { 0.15f, 0.0f, 0.0f });
		float most = 0.0f; // blade lengths a step
		for (int i = 0; i < 60; i++) {
			const auto place = [&](int p_step) { return Eigen::Vector3f(-0.5f + float(p_step) / 60.0f, 0.5f, 0.0f); };
			BladeScene::place(scene.colliders.back(), place(i), place(i + 1));
			BladeScene before;
			*before.tile = *scene.tile;
			scene.step();
			most = std::max(most, scene.distance_from(before));
		}
		MESSAGE("the farthest goes " << most << " L in a step");
		CHECK(most < 1e-5f);
	}
}
