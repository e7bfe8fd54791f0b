// SPDX-License-Identifier: MIT
// [Eq 51] Halved chains in many scenes, each from its own seed, until everything is at rest.
#include "halved_scenes.h"
#include "stress.h"

#include <doctest/doctest.h>

using namespace grass;
using namespace grass::test;

TEST_CASE("halved chains: tips of drawn blades in scenes of bodies, blasts and hills") {
	for (int i = 0; i < sized(1, 40); i++) {
		for (int scene = 0; scene < int(SCENE_NAMES.size()); scene++) {
			check_scene(scene, uint32_t(1000 * i + scene), 300);
		}
	}
}
