// SPDX-License-Identifier: MIT
// Compares data that was read twice, without comparing elements where both share their memory.
#pragma once

#include <godot_cpp/variant/variant.hpp>

namespace grass {

// Returns whether two results of PhysicsServer3D.shape_get_data(), or two packed arrays, are the same. The engine's arrays share their
// memory until one of them is written. So for a caller that keeps the last result the address shows a change, however many points the array
// has.
bool is_same_data(const godot::Variant &p_a, const godot::Variant &p_b);

} // namespace grass
