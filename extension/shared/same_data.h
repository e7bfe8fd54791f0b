// SPDX-License-Identifier: MIT
// Whether data that was read twice is the same: without comparing where both share their memory.
#pragma once

#include <godot_cpp/variant/variant.hpp>

namespace grass {

// For what PhysicsServer3D.shape_get_data() returns, and packed arrays. The engine's arrays share their memory until one of
// them is written, so the address shows a change to a caller that keeps the last result, however many points it has.
bool is_same_data(const godot::Variant &p_a, const godot::Variant &p_b);

} // namespace grass
