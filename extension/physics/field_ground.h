// SPDX-License-Identifier: MIT
// What a field takes for its ground: a band of heights, and some bodies. Crates, cars and roofs have collision shapes, too.
#pragma once

#include "core/paint/ground_band.h"

#include <godot_cpp/variant/string_name.hpp>

#include <cstdint>

namespace grass {

struct FieldGround : GroundBand {
	static constexpr int64_t ALL_LAYERS = 0xFFFFFFFF;

	int64_t mask = ALL_LAYERS; // physics layers
	godot::StringName group; // bodies of it, and below nodes of it; empty: all bodies

	// Returns what is ground of either one, at any height.
	FieldGround joined(const FieldGround &p_other) const {
		return { GroundBand(), mask | p_other.mask, group == p_other.group ? group : godot::StringName() };
	}
};

} // namespace grass
