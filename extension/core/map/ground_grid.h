// SPDX-License-Identifier: MIT
// Where the heights of a map's ground lie, and the shape of the ground between them: as in the terrain from which they were read. Heights
// taken half a metre beside a terrain's vertices would flatten each bump of two metres.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <optional>

namespace grass {

// How the ground goes between four heights (GRASS_GROUND_BLENDED and so on in map/growth.inc).
enum class GroundSplit : uint8_t {
	BLENDED,
	ACROSS, // two triangles; their common edge leads from the first height to the one across
	BESIDE, // two triangles; their common edge joins the neighbours of the first height along x and along z
};

struct GroundGrid {
	static constexpr int32_t STEPS = 1024; // of a metre

	int32_t x = 0, z = 0; // from the centre of a texel to its height, in steps; more than minus a half metre, at most a half
	GroundSplit split = GroundSplit::BLENDED;
	bool operator==(const GroundGrid &) const = default;

	// Returns the grid that has a height at p_vertex (x, z in metres).
	static GroundGrid at(const Eigen::Vector2d &p_vertex, GroundSplit p_split) {
		const auto step = [](double p_at) {
			const double beside = p_at - 0.5, share = beside - std::ceil(beside - 0.5); // -0.5 < share <= 0.5
			const int32_t code = int32_t(std::lround(share * STEPS));
			return code == -STEPS / 2 ? STEPS / 2 : code;
		};
		return { step(p_vertex.x()), step(p_vertex.y()), p_split };
	}
	// Returns the grid of a terrain with a vertex at p_vertex and cells along p_u and p_v, metres; nothing if these are not whole metres
	// along x and along z.
	static std::optional<GroundGrid> of_cells(const Eigen::Vector2d &p_vertex, const Eigen::Vector2d &p_u, const Eigen::Vector2d &p_v) {
		constexpr double TOLERANCE = 1e-3;
		const Eigen::Array4d sides(p_u.x(), p_u.y(), p_v.x(), p_v.y()), whole = sides.round();
		const bool is_aligned = ((sides - whole).abs() < TOLERANCE).all() && p_u.norm() > 0.5 && p_v.norm() > 0.5 &&
				std::abs(whole[0] * whole[1]) + std::abs(whole[2] * whole[3]) == 0.0;
		return is_aligned ? std::optional(at(p_vertex, GroundSplit::BLENDED)) : std::nullopt;
	}
	static constexpr bool is_step(int32_t p_step) { return p_step > -STEPS / 2 && p_step <= STEPS / 2; }

	// Returns the texel of the ground around the centre of a texel of half its size.
	Eigen::Array2i texel_below(int p_i, int p_j) const {
		return ((Eigen::Array2d(p_i, p_j) + 0.5) * 0.5 - offset().array()).floor().cast<int>();
	}
	Eigen::Vector2d offset() const { return Eigen::Vector2d(x, z) / STEPS; } // metres from the centre of a texel to its height
};

// Returns a grid as one number: its steps, 11 bits each, above its split.
inline uint32_t pack_ground_grid(const GroundGrid &p_grid) {
	return uint32_t(p_grid.split) | uint32_t(p_grid.x + GroundGrid::STEPS / 2) << 2 | uint32_t(p_grid.z + GroundGrid::STEPS / 2) << 13;
}
// Returns false if the number stands for no grid.
inline bool unpack_ground_grid(uint32_t p_packed, GroundGrid &r_grid) {
	constexpr uint32_t MASK = (1u << 11) - 1;
	r_grid = { int32_t(p_packed >> 2 & MASK) - GroundGrid::STEPS / 2, int32_t(p_packed >> 13 & MASK) - GroundGrid::STEPS / 2,
		GroundSplit(p_packed & 3u) };
	return p_packed >> 24 == 0 && r_grid.split <= GroundSplit::BESIDE && GroundGrid::is_step(r_grid.x) && GroundGrid::is_step(r_grid.z);
}

} // namespace grass
