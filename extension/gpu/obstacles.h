// SPDX-License-Identifier: MIT
// Finds out why the graphics device cannot simulate or draw a field. Main thread.
#pragma once

#include "core/field/device_fit.h"
#include "gpu/compile_queue.h"

#include <godot_cpp/variant/string.hpp>

namespace grass {

// Returns the limits that the engine and its driver report, read once, or the defaults if there is no device. On any thread.
const DeviceLimits &device_limits();
// Returns the reason as a sentence: what the device lacks, or a pass that its driver has refused so far. Empty: no reason is known.
godot::String find_obstacle(const FieldSetup &p_setup);
// Returns true if find_obstacle() finds a refused pass. Fast if no pass was refused in this process.
bool needs_refused_pass(const FieldSetup &p_setup);
// Prints an error or a warning for each pass refused since the last call. Fast if there is none.
void report_refusals();

} // namespace grass
