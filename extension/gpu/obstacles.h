// SPDX-License-Identifier: MIT
// Why the graphics device cannot simulate or draw a field. Main thread.
#pragma once

#include "core/field/device_fit.h"
#include "gpu/compile_queue.h"

#include <godot_cpp/variant/string.hpp>

#include <vector>

namespace grass {

// As the engine and its driver say, found once; where there is no device, the defaults.
const DeviceLimits &device_limits();
// Why it cannot, as a sentence: what it lacks, or a pass that its driver has refused so far. Empty: nothing is known.
godot::String find_obstacle(const FieldSetup &p_setup);
// Whether find_obstacle() finds a refused pass, and fast where there has been none in this process.
bool needs_refused_pass(const FieldSetup &p_setup);
// What to say of passes refused since the last call, one text each.
struct Refusal {
	godot::String text;
	bool has_stand_in;
};
std::vector<Refusal> take_refusals();

} // namespace grass
