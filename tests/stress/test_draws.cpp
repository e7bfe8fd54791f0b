// SPDX-License-Identifier: MIT
// Random parameters, bodies and time steps, in bulk: whatever comes, blades stay finite, keep their lengths and come back.
#include "random_scene.h"
#include "stress.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int FRAMES = 600;

// The scene of draw p_number: both methods and all plain versions have their turn.
std::string run_draw(int p_number, int p_bodies, double p_largest, double p_speed, int p_frames) {
	Dice dice{ uint32_t(p_number) + 1 };
	BladeScene scene(float(dice.magnitude(0.1, 1.5)));
	scene.params = dice.params(METHODS[p_number % 2]);
	scene.step_function = p_number % 20 < 2 ? step_scalar_double : step_lanes;
	scene.bend(float(dice.uniform(-3.0, 3.0)));
	Storm storm(scene, dice, p_bodies, 1e-3, p_largest, p_speed);
	for (int i = 0; i < p_frames; i++) {
		const double delta = dice.delta();
		storm.move(delta);
		scene.step(delta);
		const std::string failure = look_at(scene);
		if (!failure.empty()) {
			return std::string(name_of(scene.params.method)) + ", frame " + std::to_string(i) + ": " + failure;
		}
	}
	const std::string failure = calm_down(scene);
	return failure.empty() ? "" : std::string(name_of(METHODS[p_number % 2])) + ", in the end: " + failure;
}

} // namespace

TEST_CASE("stress: random parameters, time steps and a few bodies, 600 frames of a tile each") {
	check_each(sized(150, 10000), [](int p_number) { return run_draw(p_number, p_number % 5, 0.5, 30.0, FRAMES); });
}

TEST_CASE("stress: storms of hundreds of overlapping bodies of all shapes") {
	check_each(sized(16, 400), [](int p_number) { return run_draw(100000 + p_number, 100 + 40 * (p_number % 10), 0.3, 100.0, 40); });
}

TEST_CASE("stress: a thousand shapes in one place, for a second") {
	check_each(2, [](int p_number) -> std::string {
		Dice dice{ uint32_t(p_number) };
		BladeScene scene;
		scene.params.method = METHODS[p_number];
		Storm storm(scene, dice, 1000, 0.05, 0.5, 1.0);
		for (int i = 0; i < sized(10, 60); i++) {
			storm.move(1.0 / 60.0);
			scene.step();
			const std::string failure = look_at(scene);
			if (!failure.empty()) {
				return std::string(name_of(METHODS[p_number])) + ": " + failure;
			}
		}
		return calm_down(scene);
	});
}

TEST_CASE("stress: all lane widths compute what one float does, bit for bit") {
	check_each(sized(150, 20000),
			[](int p_number) { return find_difference(1000 + uint32_t(p_number), p_number % 2 ? Range::WILD : Range::EVERYDAY, 60); });
}
