// SPDX-License-Identifier: MIT
// How smoothly blades lie that a body crushes, and how surely they rise, by `iterations`: docs/history/0016 quotes it. A tile of 64
// blades, a body in 40 random places.
#include "blade_scene.h"

#include <Eigen/Geometry>
#include <cstdio>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int PLACES = 40;
constexpr int RISE = 120; // steps
constexpr float SHARP = 0.8f; // between two segments, radians
constexpr double APART = 1e-3; // blade lengths

struct Crush {
	const char *name;
	int shape;
	bool falls; // by 1 cm a step, or stands there from the first step on
	int steps;
};
constexpr Crush CRUSHES[] = { { "a ball appears, 8 steps", GRASS_SPHERE, false, 8 },
	{ "a ball appears, 30 steps", GRASS_SPHERE, false, 30 }, { "a ball falls", GRASS_SPHERE, true, 60 },
	{ "a crate falls", GRASS_BOX, true, 60 } };

void crush(BladeScene &r_scene, const Crush &p_crush, const Eigen::Vector3f &p_place, float p_size) {
	r_scene.add(p_crush.shape, p_place, { p_size, p_size, p_size });
	const auto at = [&](int p_step) {
		return Eigen::Vector3f(p_place + Eigen::Vector3f(0.0f, std::max(0.5f - 0.01f * float(p_step), 0.0f), 0.0f));
	};
	for (int i = 0; i < p_crush.steps; i++) {
		if (p_crush.falls) {
			BladeScene::place(r_scene.colliders[0], at(i), at(i + 1));
		}
		r_scene.step();
	}
}

// Angles between segments of all blades: how many are sharp, and the sum of their squares.
void measure(const BladeScene &p_scene, double &r_sharp, double &r_squares) {
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS - 1; k++) {
			const Eigen::Vector3f before = p_scene.knot(b, k) - p_scene.knot(b, k - 1), here = p_scene.knot(b, k + 1) - p_scene.knot(b, k);
			const float angle = std::atan2(before.cross(here).norm(), before.dot(here));
			r_sharp += angle > SHARP ? 1.0 : 0.0;
			r_squares += double(angle) * double(angle);
		}
	}
}

} // namespace

int main() {
	std::printf(
			"By `iterations`, for a blade: the squares of the angles between its segments (sum, rad^2) and how many of them are sharp "
			"(over\n"
			"%.1f rad), crushed; and how many in a hundred part by more than %.0e L in float and double within %d steps of being let go\n",
			double(SHARP), APART, RISE);
	for (const int iterations : { 2, 3, 4, 10 }) {
		for (const Crush &kind : CRUSHES) {
			std::mt19937 random(5);
			const auto between = [&](float p_least, float p_most) {
				return std::uniform_real_distribution<float>(p_least, p_most)(random);
			};
			double sharp = 0.0, squares = 0.0, apart = 0.0;
			for (int i = 0; i < PLACES; i++) {
				const float size = between(0.1f, 0.2f), x = between(-0.25f, 0.25f), z = between(-0.05f, 0.05f);
				const Eigen::Vector3f place(x, between(0.1f, 0.3f), z);
				BladeScene scenes[2];
				scenes[1].step_function = step_scalar_double;
				for (BladeScene &scene : scenes) {
					scene.params.iterations = iterations;
					crush(scene, kind, place, size);
				}
				measure(scenes[0], sharp, squares);
				bool parts[GRASS_BLADES_PER_TILE] = {};
				for (int step = 0; step < RISE; step++) {
					for (BladeScene &scene : scenes) {
						scene.colliders.clear();
						scene.step();
					}
					for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
						for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
							parts[b] = parts[b] || (scenes[0].knot(b, k) - scenes[1].knot(b, k)).norm() > APART * scenes[0].length;
						}
					}
				}
				apart += double(std::count(parts, parts + GRASS_BLADES_PER_TILE, true));
			}
			const double blades = double(PLACES * GRASS_BLADES_PER_TILE);
			std::printf("  %2d, %-24s: %.3f, %.3f sharp, %.1f part\n", iterations, kind.name, squares / blades, sharp / blades,
					100.0 * apart / blades);
		}
	}
}
