// SPDX-License-Identifier: MIT
// Nanoseconds that a step of a free blade takes on one core: as a chain and by its strains, in every kind of number, taking turns. Prints a
// table; docs/benchmarks/solver.md quotes it.
#include "blade_scene.h"
#include "core/strain/basis.h"
#include "core/strain/strain_tile.h"

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
	std::vector<Step> chains{ step_scalar_double, step_scalar_float };
	std::vector<StrainTileStep> strains{ step_strains_double, step_strains_float };
	chains.insert(chains.end(), get_lane_steps().begin(), get_lane_steps().end());
	strains.insert(strains.end(), get_strain_steps().begin(), get_strain_steps().end());
	std::printf("numbers,chain_ns,strains_ns,share\n");
	for (size_t i = 0; i < chains.size(); i++) {
		double chain = 1e9, strain = 1e9;
		for (int round = 0; round < ROUNDS; round++) {
			BladeScene scene(Method::DIRECT);
			scene.params.damping_ratio = 0.05;
			scene.bend(1.0f);
			scene.step();
			const StrainSpecies species{ scene.clock.advance(scene.params, 1.0 / 60.0),
				make_strain_section(scene.params.taper, scene.params.width_to_thickness) };
			chain = std::min(chain, nanoseconds([&] { chains[i](*scene.tile, { &species.step, 1 }, 0.0f, {}); }));
			const auto state = std::make_unique<StrainState>();
			find_lengths(*scene.tile, *state);
			for (int n = 0; n < GRASS_STRAINS; n++) {
				for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
					state->strains[n][b] = 0.5f / float(n + 1);
				}
			}
			strain = std::min(strain, nanoseconds([&] { strains[i](*scene.tile, *state, { &species, 1 }, 0.0f); }));
		}
		std::printf("%s,%.0f,%.0f,%.2f\n", NAMES[i], chain, strain, strain / chain);
	}
}
