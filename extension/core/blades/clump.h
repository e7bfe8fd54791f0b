// SPDX-License-Identifier: MIT
// Clumps: low-frequency noise of the place in the field that makes neighbouring blades alike in height, lean
// and colour (shaders/blades/clump.inc).
#pragma once

#include "core/base/tunable.h"
#include "core/blades/glsl_texts.h"

namespace grass {

using Clump = glsl::GrassClump;
inline constexpr Clump NO_CLUMP{ 1.0f, glsl::vec2(0.0f), 0.0f };

// Below 0.05 m neighbouring blades differ at random; above 1000 m a field shows one value.
inline constexpr Tunable CLUMP_SIZE{ "clump_size", "m", 0.05, 1000.0, 0.05, 1.6 };
// 0 = off, 1 = the full range. Above 1 blades could dip into the ground.
inline constexpr Tunable CLUMP_HEIGHT{ "clump_height", "", 0.0, 1.0, 0.01, 1.0 };
inline constexpr Tunable CLUMP_LEAN{ "clump_lean", "", 0.0, 1.0, 0.01, 1.0 };
inline constexpr Tunable CLUMP_TINT{ "clump_tint", "", 0.0, 1.0, 0.01, 1.0 };

// The shader's vec4 `clump`, in this order.
struct ClumpParams {
	float size = float(CLUMP_SIZE.initial); // metres
	float height = float(CLUMP_HEIGHT.initial);
	float lean = float(CLUMP_LEAN.initial);
	float tint = float(CLUMP_TINT.initial);

	bool operator==(const ClumpParams &) const = default;
};

// No blade grows by more than this factor.
inline constexpr float CLUMP_TALLEST = float(1.0 + GRASS_CLUMP_TALLER);

// [Eq B2] The clump at p_place (field-space x, z in metres).
inline Clump clump_at(const Eigen::Vector2f &p_place, const ClumpParams &p_clump) {
	return glsl::grass_clump_at(to_glsl(p_place), glsl::vec4(p_clump.size, p_clump.height, p_clump.lean, p_clump.tint));
}

} // namespace grass
