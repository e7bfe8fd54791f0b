// SPDX-License-Identifier: MIT
// Clumps: low-frequency noise over the field that makes neighbouring blades alike in height, lean and colour (shaders/blades/clump.inc).
#pragma once

#include "core/base/tunable.h"
#include "core/blades/glsl_texts.h"

#include <array>
#include <cmath>

namespace grass {

using Clump = glsl::GrassClump;
inline constexpr Clump NO_CLUMP{ 1.0f, glsl::vec2(0.0f), 0.0f };

// Below 0.05 m neighbouring blades differ at random; above 1000 m the whole field has one value.
inline constexpr Tunable CLUMP_SIZE{ "clump_size", "m", 0.05, 1000.0, 0.05, 1.6 };
// 0: off; 1: the full range. Above 1 blades could dip into the ground.
inline constexpr Tunable CLUMP_HEIGHT{ "clump_height", "", 0.0, 1.0, 0.01, 1.0 };
inline constexpr Tunable CLUMP_LEAN{ "clump_lean", "", 0.0, 1.0, 0.01, 1.0 };
inline constexpr Tunable CLUMP_TINT{ "clump_tint", "", 0.0, 1.0, 0.01, 1.0 };

// In the order of the shader's vec4 `clump`; then its `clump_origin`.
struct ClumpParams {
	float size = float(CLUMP_SIZE.initial); // metres
	float height = float(CLUMP_HEIGHT.initial);
	float lean = float(CLUMP_LEAN.initial);
	float tint = float(CLUMP_TINT.initial);
	std::array<float, 4> origin{}; // see set_origin()

	// Sets the field's centre in the noise, metres. The lattices repeat, so only the remainder of a division is kept: places keep their
	// precision wherever the field is.
	void set_origin(const Eigen::Vector2d &p_metres) {
		const double finer = double(GRASS_CLUMP_FINER);
		const auto rest = [](double p_cells) { return float(p_cells - GRASS_LATTICE_CELLS * std::floor(p_cells / GRASS_LATTICE_CELLS)); };
		const Eigen::Vector2d coarse = p_metres / double(size);
		origin = { rest(coarse.x()), rest(coarse.y()), rest(finer * coarse.x()), rest(finer * coarse.y()) };
	}
	bool is_elsewhere() const { return origin != std::array<float, 4>{}; }
	bool operator==(const ClumpParams &) const = default;
};

// No blade grows by more than this factor.
inline constexpr float CLUMP_TALLEST = float(1.0 + GRASS_CLUMP_TALLER);

// [Eq B2] Returns the clump at p_place (field-space x, z in metres).
inline Clump clump_at(const Eigen::Vector2f &p_place, const ClumpParams &p_clump) {
	return glsl::grass_clump_at(to_glsl(p_place), glsl::vec4(p_clump.size, p_clump.height, p_clump.lean, p_clump.tint),
			glsl::vec4(p_clump.origin[0], p_clump.origin[1], p_clump.origin[2], p_clump.origin[3]));
}

} // namespace grass
