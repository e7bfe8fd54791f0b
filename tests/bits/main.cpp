// SPDX-License-Identifier: MIT
// Steps scenes of random blades, bodies and parameters, and prints a hash of each, for the fastest lanes that the machine has and for
// doubles. The layers `windows` and `arm64` compare what the program says there with what it says here (tools/test/testing_platforms.py).
#include "bit_hash.h"
#include "random_scene.h"

#include <cstdio>

using namespace grass;
using namespace grass::test;

namespace {

constexpr uint32_t SCENES = 100;
constexpr int STEPS = 30;

std::string hash_of(uint32_t p_seed, Range p_range, Step p_step) {
	RandomScene scene(p_seed, p_range);
	BitHash hash;
	for (int i = 0; i < STEPS; i++) {
		scene.advance();
		const float energy = scene.step(p_step, scene.get_tile());
		add_tile(hash, scene.get_tile());
		hash.add({ &energy, 1 });
	}
	return hash.str();
}

} // namespace

int main() {
	for (uint32_t seed = 0; seed < SCENES; seed++) {
		const Range range = seed % 2 ? Range::WILD : Range::EVERYDAY;
		const std::string lanes = hash_of(seed, range, step_lanes), doubles = hash_of(seed, range, step_scalar_double);
		std::printf("scene %u: lanes %s, doubles %s\n", seed, lanes.c_str(), doubles.c_str());
	}
	return 0;
}
