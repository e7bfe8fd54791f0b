// SPDX-License-Identifier: MIT
// Nanoseconds that a step of a free blade takes on one core: as a chain and by its strains, in every kind of number, taking turns. Prints a
// table; lab/results/solver.md quotes it.
#include "blade_scene.h"
#include "core/solver/strain/basis.h"
#include "core/solver/strain/strain.h"

#include <chrono>
#include <cstdio>
#include <functional>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int ROUNDS = 40, STEPS = 30;

// Of the best round.
double nanoseconds(const std::function<void()> &p_step) {
	const auto start = std::chrono::steady_clock::now();
	for (int i = 0; i < STEPS; i++) {
		p_step();
	}
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / STEPS / GRASS_BLADES_PER_TILE * 1e9;
}

} // namespace

int main() {
	const char *NAMES[] = { "double", "float", "4 lanes", "8 lanes", "16 lanes" };
	std::vector<Step> steps{ step_scalar_double, step_scalar_float };
	steps.insert(steps.end(), get_lane_steps().begin(), get_lane_steps().end());
	std::printf("numbers,chain_ns,strains_ns,share\n");
	for (size_t i = 0; i < steps.size(); i++) {
		double chain = 1e9, strain = 1e9;
		for (int round = 0; round < ROUNDS; round++) {
			BladeScene scene(Method::DIRECT);
			scene.params.damping_ratio = 0.05;
			scene.bend(1.0f);
			scene.step();
			const GrassStep step = scene.clock.advance(scene.params, 1.0 / 60.0);
			const StrainSection<float> section = make_strain_section(scene.params.taper, scene.params.width_to_thickness);
			chain = std::min(chain, nanoseconds([&] { steps[i](*scene.tile, { &step, 1 }, 0.0f, {}); }));
			scene.tile->sections = &section;
			steps[i](*scene.tile, { &step, 1 }, 0.0f, {}); // finds the numbers
			strain = std::min(strain, nanoseconds([&] { steps[i](*scene.tile, { &step, 1 }, 0.0f, {}); }));
		}
		std::printf("%s,%.0f,%.0f,%.2f\n", NAMES[i], chain, strain, strain / chain);
	}
}
