// SPDX-License-Identifier: MIT
// Scenes of bodies, blasts and hills, each from its own seed: blades change to their strains without a jump.
#include "moving_scenes.h"
#include "stress.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

TEST_CASE("[Eq Q11] alone: in five scenes no blade jumps as its tile changes to strains") {
	constexpr int KINDS = int(SCENE_NAMES.size()), WEIGHT = 4; // of a scene, so long does it take: under a sanitizer one is left
	for (int i = 0; i < sized(WEIGHT * KINDS, 40 * WEIGHT * KINDS) / WEIGHT; i++) {
		check_scene(i % KINDS, uint32_t(1000 * (i / KINDS) + i % KINDS), 300);
	}
}
