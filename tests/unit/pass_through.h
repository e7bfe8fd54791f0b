// SPDX-License-Identifier: MIT
#pragma once

#include "blade_scene.h"

namespace grass::test {

// Moves collider 0 along x through the blades at p_speed (m/s), calling p_check(x) after every step.
template <class Check> void pass_through(BladeScene &r_scene, float p_speed, float p_height, const Check &p_check) {
	const float stride = p_speed / 60.0f;
	const int count = int(2.0f / stride) + 4;
	for (int i = 0; i < count; i++) {
		const float x = (float(i) - 0.5f * float(count) + 0.37f) * stride;
		BladeScene::place(r_scene.colliders[0], { x - stride, p_height, 0.02f }, { x, p_height, 0.02f });
		r_scene.step();
		p_check(x);
	}
}

} // namespace grass::test
