// SPDX-License-Identifier: MIT
#include "core/paint/ledges.h"

#include "core/map/growth.h"

#include <algorithm>
#include <bit>
#include <numbers>

namespace grass {

namespace {

constexpr double FITS = 0.02; // metres that the ground may be away from where grass is put, in a cell with a ledge
constexpr double NEAR = 0.05; // metres in which the slope beside a ledge is measured

// Returns how far from the ground each code's height lies at a point of a cell. Infinite: so far that nothing may grow there.
std::array<double, 16> errors_at(const LedgeCell &p_cell, const std::array<LedgeCorner, 4> &p_corners, int p_column, int p_row) {
	const double x = double(p_column) / LedgeCell::SPOTS, z = double(p_row) / LedgeCell::SPOTS, there = p_cell.at(p_column, p_row);
	std::array<double, 4> planes{};
	unsigned missing = 0;
	for (size_t n = 0; n < 4; n++) {
		const LedgeCorner &corner = p_corners[n];
		const glsl::vec2 from(float((x - double(n & 1)) * GROUND_TEXEL), float((z - double(n >> 1)) * GROUND_TEXEL));
		planes[n] =
				double(glsl::grass_ledge_plane(float(corner.height), glsl::vec2(float(corner.normal.x()), float(corner.normal.y())), from));
		missing |= corner.is_missing ? 1u << n : 0u;
	}
	std::array<double, 16> errors{};
	for (unsigned code = 1; code < 16; code++) {
		if (!std::isfinite(there)) { // where there was no ground before, there is still none
			errors[code] = (code & ~missing) == 0 ? 0.0 : std::numeric_limits<double>::infinity();
			continue;
		}
		const glsl::vec4 weights = glsl::grass_ledge_weights(int(code), glsl::vec2(float(x), float(z)));
		double height = double(weights.x) * planes[0] + double(weights.y) * planes[1] + double(weights.z) * planes[2] +
				double(weights.w) * planes[3];
		if (code == GRASS_LEDGE_NONE) {
			height = blend_corners({ p_corners[0].height, p_corners[1].height, p_corners[2].height, p_corners[3].height }, x, z);
		}
		errors[code] = std::abs(height - there);
	}
	errors[0] = std::numeric_limits<double>::infinity();
	return errors;
}

} // namespace

double blend_corners(const std::array<double, 4> &p_corners, double p_x, double p_z) {
	return (p_corners[0] * (1.0 - p_x) + p_corners[1] * p_x) * (1.0 - p_z) + (p_corners[2] * (1.0 - p_x) + p_corners[3] * p_x) * p_z;
}

double ledge_tangent(double p_slope) {
	return std::tan(p_slope * std::numbers::pi / 180.0);
}

std::array<uint8_t, size_t(LedgeCell::SPOTS *LedgeCell::SPOTS)> ledge_codes(
		const LedgeCell &p_cell, const std::array<LedgeCorner, 4> &p_corners, double p_slope) {
	const double tangent = ledge_tangent(p_slope);
	std::array<bool, 16> is_allowed{};
	for (unsigned code = 1; code < 16; code++) {
		is_allowed[code] = true;
		for (unsigned a = 0; a < 4; a++) {
			for (unsigned b = 0; b < a; b++) {
				const double metres = GROUND_TEXEL * std::sqrt(double(std::popcount(a ^ b)));
				const bool are_both = (code >> a & 1u) && (code >> b & 1u);
				is_allowed[code] =
						is_allowed[code] && !(are_both && std::abs(p_corners[a].height - p_corners[b].height) > tangent * metres);
			}
		}
	}
	std::array<std::array<double, 16>, size_t(LedgeCell::POINTS * LedgeCell::POINTS)> errors;
	for (int n = 0; n < LedgeCell::POINTS * LedgeCell::POINTS; n++) {
		errors[size_t(n)] = errors_at(p_cell, p_corners, n % LedgeCell::POINTS, n / LedgeCell::POINTS);
	}
	std::array<uint8_t, size_t(LedgeCell::SPOTS * LedgeCell::SPOTS)> codes{};
	for (int spot = 0; spot < LedgeCell::SPOTS * LedgeCell::SPOTS; spot++) {
		const size_t first = size_t(spot / LedgeCell::SPOTS * LedgeCell::POINTS + spot % LedgeCell::SPOTS);
		double best = 0.0;
		for (unsigned code = 1; code < 16; code++) {
			double error = 0.0;
			for (const size_t point : { first, first + 1, first + size_t(LedgeCell::POINTS), first + size_t(LedgeCell::POINTS) + 1 }) {
				error = std::max(error, errors[point][code]);
			}
			// Prefer the code with the most corners that fit, since the cell's surroundings blend with them.
			const double score = std::popcount(code) + 1.0 - error;
			if (is_allowed[code] && error <= FITS && score > best) {
				best = score;
				codes[size_t(spot)] = uint8_t(code);
			}
		}
	}
	return codes;
}

Eigen::Vector2d slope_beside_ledge(
		const HeightBlock &p_heights, double p_slope, bool p_is_sheet, int p_i, int p_j, GroundPlaces &r_places) {
	const double tangent = ledge_tangent(p_slope), here = p_heights.at(p_i, p_j), step = p_is_sheet ? GROUND_TEXEL : NEAR;
	const auto height = [&](int p_di, int p_dj) {
		return p_is_sheet ? p_heights.at(p_i + p_di, p_j + p_dj)
						  : r_places.between(HeightBlock::centre(p_i, p_j) + step * Eigen::Vector2d(p_di, p_dj));
	};
	const auto slope = [&](int p_di, int p_dj) {
		const double ahead = (height(p_di, p_dj) - here) / step, behind = (here - height(-p_di, -p_dj)) / step;
		if (!std::isfinite(ahead) || !std::isfinite(behind)) {
			const double known = std::isfinite(ahead) ? ahead : (std::isfinite(behind) ? behind : 0.0);
			return std::abs(known) > tangent ? 0.0 : known;
		}
		const double mean = 0.5 * (ahead + behind), least = std::abs(ahead) < std::abs(behind) ? ahead : behind;
		const double chosen = std::abs(ahead - behind) < 0.2 ? mean : least; // otherwise one of them is beyond the ledge
		return std::abs(chosen) > tangent ? 0.0 : chosen;
	};
	return { slope(1, 0), slope(0, 1) };
}

} // namespace grass
