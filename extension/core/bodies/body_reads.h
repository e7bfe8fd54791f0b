// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace grass {

// What finding out where bodies are took, counted since a field began to watch them.
struct BodyReads {
	int64_t poses = 0; // one a body and tick
	int64_t shapes = 0; // shapes looked at for changes
	int64_t engine_calls = 0; // of the physics server and of nodes: most of what bodies cost

	void add(const BodyReads &p_others) {
		poses += p_others.poses;
		shapes += p_others.shapes;
		engine_calls += p_others.engine_calls;
	}
};

} // namespace grass
