// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace grass {

// What it cost to find out where bodies are, counted since a field began to watch them.
struct BodyReads {
	int64_t poses = 0; // one for each body and tick
	int64_t shapes = 0; // shapes checked for changes
	int64_t engine_calls = 0; // calls of the physics server and of nodes: most of the cost of bodies

	void add(const BodyReads &p_others) {
		poses += p_others.poses;
		shapes += p_others.shapes;
		engine_calls += p_others.engine_calls;
	}
};

} // namespace grass
