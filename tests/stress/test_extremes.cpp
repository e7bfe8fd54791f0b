// SPDX-License-Identifier: MIT
// One thing at a time at its extreme: speed, place, size, numbers that are none.
#include "stress.h"

#include "core/solver/simulate.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1;
const Eigen::Vector3f SIZE(0.15f, 0.12f, 0.1f);

// Of METHODS times SHAPES.
constexpr int COMBINATIONS = 10;
BladeScene make_scene(int p_number, float p_length = 0.5f) {
	BladeScene scene(p_length);
	scene.params.method = METHODS[p_number / 5];
	return scene;
}
std::string describe(int p_number, const std::string &p_failure) {
	return p_failure.empty() ? ""
							 : std::string(name_of(METHODS[p_number / 5])) + ", shape " + std::to_string(p_number % 5) + ": " + p_failure;
}

// A tile of the patch that a ball passes, with its records as TileManager would make them.
std::vector<Eigen::Vector3f> knots_at(Method p_method, int p_tile_x) {
	CpuPool pool(std::make_shared<const Patch>(generate_patch(PatchParams())), 1);
	StepClock clock;
	SolverParams solver;
	solver.method = p_method;
	std::vector<Eigen::Vector3f> knots;
	for (int i = 0; i < 60; i++) {
		GrassSlot slot;
		slot.tile = { p_tile_x, 0, 0, 0 };
		slot.list = { 0, 0, 1, i == 0 ? uint32_t(GRASS_SLOT_FRESH) : 0u };
		GrassCollider ball;
		ball.anchor = { p_tile_x - 1, 0, GRASS_SPHERE, 0 };
		ball.rotation = ball.rotation_before = { 0, 0, 0, 1 };
		ball.size.x = 0.15f;
		ball.position_before = { 0.03f * float(i), 0.15f, 0.03f, 0.0f };
		ball.position = { 0.03f * float(i + 1), 0.15f, 0.03f, 0.5f };
		GrassStep step = clock.advance(solver, 1.0 / 60.0);
		step.field = { 0.5f, 400000.0f, 1.0f, 0.0f };
		step.clump = { 1.6f, 0.0f, 0.0f, 0.0f }; // no clumps: they differ with the place
		const uint32_t list[] = { 0 };
		pool.step({ { &slot, 1 }, { &ball, 1 }, list, {}, step });
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const std::vector<Eigen::Vector3f> blade = pool.get_knots(0, b);
			knots.insert(knots.end(), blade.begin(), blade.end());
		}
	}
	return knots;
}

} // namespace

TEST_CASE("stress: a body at 1000 m/s hits from any side, and lengths hold") {
	check_each(COMBINATIONS * 8, [](int p_number) -> std::string {
		const float angle = float(p_number / COMBINATIONS) * 0.785f;
		const Eigen::Vector3f way = Eigen::Vector3f(std::cos(angle), 0.0f, std::sin(angle)) * (1000.0f / 60.0f);
		BladeScene scene = make_scene(p_number % COMBINATIONS);
		const Eigen::Vector3f middle(0.0f, 0.3f, 0.0f);
		scene.add(SHAPES[p_number % 5], middle, SIZE);
		BladeScene::place(scene.colliders[0], middle - way * 0.5f, middle + way * 0.5f);
		scene.step();
		if (!((scene.knot(0, TIP) - scene.rest(0, TIP)).dot(way.normalized()) > 0.3f * scene.length)) {
			return describe(p_number % COMBINATIONS, "the straight blade was not taken along");
		}
		const std::string failure = look_at(scene);
		return describe(p_number % COMBINATIONS, failure.empty() ? calm_down(scene) : failure);
	});
}

TEST_CASE("stress: a teleported body gives no impulse, wherever it lands beside the blades") {
	check_each(COMBINATIONS * 20, [](int p_number) -> std::string {
		Dice dice{ uint32_t(p_number) };
		BladeScene scene = make_scene(p_number % COMBINATIONS);
		Eigen::Vector3f place = dice.direction();
		place.y() = 0.0f;
		place = place.normalized() * 5.0f;
		scene.add(SHAPES[p_number % 5], place, SIZE);
		scene.step();
		BladeScene::place(scene.colliders[0], -place, -place);
		scene.step();
		return describe(p_number % COMBINATIONS, scene.is_exactly_at_rest() ? "" : "blades have moved");
	});
}

TEST_CASE("stress: a knot at a centre or on an axis finds a way out, the same one every time") {
	check_each(COMBINATIONS * GRASS_FREE_KNOTS, [](int p_number) -> std::string {
		BladeScene scene = make_scene(p_number % COMBINATIONS), again = make_scene(p_number % COMBINATIONS);
		for (BladeScene *each : { &scene, &again }) {
			each->add(SHAPES[p_number % 5], each->rest(0, GRASS_CLAMPED_KNOTS + p_number / COMBINATIONS), { 0.06f, 0.05f, 0.05f });
			each->step_for(0.5);
		}
		if (scene.distance_from(again) != 0.0f) {
			return describe(p_number % COMBINATIONS, "two ways out");
		}
		const std::string failure = look_at(scene);
		return describe(p_number % COMBINATIONS, failure.empty() ? calm_down(scene) : failure);
	});
}

TEST_CASE("stress: worlds of 1/1000 to 1000 times the size move alike without contact") {
	check_each(12, [](int p_number) -> std::string {
		const float scale = std::pow(10.0f, float(p_number % 6 < 3 ? p_number % 6 - 3 : p_number % 6 - 2));
		BladeScene scene, scaled(0.5f * scale);
		scene.params.method = scaled.params.method = METHODS[p_number / 6];
		scene.bend(2.0f);
		scaled.bend(2.0f);
		float most = 0.0f;
		for (int i = 0; i < 240; i++) {
			scene.step();
			scaled.step();
			most = std::max(most,
					scene.largest([&](int b, int k) { return (scaled.knot(b, k) / scale - scene.knot(b, k)).norm() / scene.length; }));
		}
		return most <= 1e-3f
				? ""
				: std::string(name_of(scene.params.method)) + ", " + std::to_string(scale) + " x: " + std::to_string(most) + " L";
	});
}

TEST_CASE("stress: 100 km from the field's first tile blades move as there, within 1e-5 of their length") {
	check_each(2, [](int p_number) -> std::string {
		const std::vector<Eigen::Vector3f> near = knots_at(METHODS[p_number], 1), far = knots_at(METHODS[p_number], 200000);
		float most = 0.0f, moved = 0.0f;
		for (size_t i = 0; i < near.size(); i++) {
			most = std::max(most, (near[i] - far[i]).norm());
			moved = std::max(moved, (near[i] - near[i % (GRASS_BLADES_PER_TILE * GRASS_KNOTS)]).norm());
		}
		return most <= 1e-5f * float(LENGTH_MIN.initial) && moved > 0.1f ? "" : name_of(METHODS[p_number]);
	});
}

TEST_CASE("stress: numbers that are none, anywhere in the state or in bodies, are gone after a step, and neighbours do not notice") {
	constexpr float BROKEN[] = { NOT_A_NUMBER, INFINITY, -INFINITY, 1e38f };
	check_each(sized(480, 4800), [&](int p_number) -> std::string {
		Dice dice{ uint32_t(p_number) };
		BladeScene scene, whole;
		for (BladeScene *each : { &scene, &whole }) {
			each->params.method = METHODS[p_number % 2];
			each->bend(1.0f);
		}
		const int blade = dice.below(GRASS_BLADES_PER_TILE), knot = dice.below(GRASS_FREE_KNOTS), axis = dice.below(3);
		const float broken = BROKEN[p_number / 2 % 4];
		(p_number % 3 == 0                  ? scene.tile->knots[axis][knot][blade]
						: p_number % 3 == 1 ? scene.tile->before[axis][knot][blade]
											: scene.tile->twist[knot][blade]) = broken;
		GrassCollider &bad = scene.add(SHAPES[dice.below(5)], { 0.0f, 0.2f, 0.0f }, SIZE);
		(&(&bad.position)[dice.below(4)].x)[dice.below(3)] = BROKEN[dice.below(3)];
		scene.step();
		whole.step();
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			for (int k = 0; k < GRASS_KNOTS; k++) {
				if (b != blade && scene.knot(b, k) != whole.knot(b, k)) {
					return "blade " + std::to_string(b) + " has noticed";
				}
			}
		}
		const std::string failure = look_at(scene);
		return failure.empty() ? calm_down(scene) : failure;
	});
}
