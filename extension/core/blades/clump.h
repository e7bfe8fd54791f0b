// SPDX-License-Identifier: MIT
// Clumps: low-frequency noise of the place in the field that makes neighbouring blades alike in height, lean
// and colour. Twin of shaders/blades/clump.inc: same names, same order of operations.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/base/hash.h"
#include "core/base/tunable.h"

namespace grass {

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

struct Clump {
	float height = 1.0f; // factor on the blade's length
	Eigen::Vector2f lean = Eigen::Vector2f::Zero(); // tangent of half the angle of lean towards x and z
	float tint = 0.0f; // -1 fresh and dark .. +1 dry and light
};

// No blade grows by more than this factor.
inline constexpr float CLUMP_TALLEST = float(1.0 + GRASS_CLUMP_TALLER);

// Four numbers, 0..1, from the four bytes of random bits.
inline Eigen::Array4f random_numbers(uint32_t p_bits) {
	return Eigen::Array4f(float(p_bits & 255u), float((p_bits >> 8) & 255u), float((p_bits >> 16) & 255u), float(p_bits >> 24)) / 255.0f;
}

// Four independent random numbers, 0..1, of a lattice point.
inline Eigen::Array4f lattice(int32_t p_x, int32_t p_y) {
	constexpr uint32_t MASK = GRASS_LATTICE_CELLS - 1;
	return random_numbers(grass_hash((uint32_t(p_x) & MASK) ^ grass_hash(uint32_t(p_y) & MASK)));
}

// a (1 - t) + b t
inline Eigen::Array4f mix(const Eigen::Array4f &p_a, const Eigen::Array4f &p_b, float p_t) {
	return p_a * (1.0f - p_t) + p_b * p_t;
}

// [Eq B1] Value noise, 0..1 each.
inline Eigen::Array4f value_noise(const Eigen::Vector2f &p_place) {
	const Eigen::Array2f corner = p_place.array().floor();
	Eigen::Array2f t = p_place.array() - corner;
	t = t * t * (3.0f - 2.0f * t);
	const int32_t x = int32_t(corner.x());
	const int32_t y = int32_t(corner.y());
	const Eigen::Array4f near_row = mix(lattice(x, y), lattice(x + 1, y), t.x());
	const Eigen::Array4f far_row = mix(lattice(x, y + 1), lattice(x + 1, y + 1), t.x());
	return mix(near_row, far_row, t.y());
}

// [Eq B2] What the noise says about p_place (field-space x, z in metres).
inline Clump clump_at(const Eigen::Vector2f &p_place, const ClumpParams &p_clump) {
	const Eigen::Vector2f coarse = p_place / p_clump.size;
	Eigen::Array4f noise = (2.0f * value_noise(coarse) + value_noise(coarse * 2.7f + Eigen::Vector2f(17.3f, 5.9f))) / 3.0f;
	noise = ((noise - 0.2f) / 0.6f).max(0.0f).min(1.0f);
	noise = noise * noise * (3.0f - 2.0f * noise);
	Clump here;
	here.height = 1.0f + p_clump.height * (noise[0] * float(GRASS_CLUMP_SHORTER + GRASS_CLUMP_TALLER) - float(GRASS_CLUMP_SHORTER));
	here.lean = p_clump.lean * float(GRASS_CLUMP_LEAN) * (2.0f * noise.segment<2>(1) - 1.0f).matrix();
	here.tint = p_clump.tint * (2.0f * noise[3] - 1.0f);
	return here;
}

} // namespace grass
