// SPDX-License-Identifier: MIT
#include "core/paint/ledges.h"

#include "core/base/hash.h"
#include "core/map/growth.h"

#include <algorithm>
#include <bit>
#include <deque>
#include <numbers>

namespace grass {

namespace {

constexpr int POINTS = LedgeCell::POINTS, SPOTS = LedgeCell::SPOTS;
constexpr int PROBES = 2; // along a side of a cell
// Metres that the ground may be away from where grass is put, before a cell counts as one with a ledge, and then.
constexpr double SUSPECT = 0.03, FITS = 0.02;
constexpr int HALVINGS = 4; // of the distance between two points of a cell, to see whether the ground jumps between them
constexpr double NEAR = 0.05; // metres in which the slope beside a ledge is measured

double tangent_of(double p_degrees) {
	return std::tan(p_degrees * std::numbers::pi / 180.0);
}

double blend(const std::array<double, 4> &p_corners, double p_x, double p_z) {
	return (p_corners[0] * (1.0 - p_x) + p_corners[1] * p_x) * (1.0 - p_z) + (p_corners[2] * (1.0 - p_x) + p_corners[3] * p_x) * p_z;
}

bool is_any_steep(const std::array<double, 4> &p_corners, double p_tangent) {
	const auto is_steep = [&](size_t p_a, size_t p_b) { return std::abs(p_corners[p_a] - p_corners[p_b]) > p_tangent * GROUND_TEXEL; };
	return is_steep(0, 1) || is_steep(2, 3) || is_steep(0, 2) || is_steep(1, 3);
}

class LedgeFinder {
public:
	LedgeFinder(const HeightBlock &p_heights, const LedgeSearch &p_search, bool p_skips_missing) :
			_heights(p_heights), _search(p_search), _skips_missing(p_skips_missing), _tangent(tangent_of(p_search.slope)) {}

	Ledges run() {
		const Eigen::Array2i first = _heights.get_first(), size = _heights.get_size() - 1;
		_is_examined.resize(size_t(size.x()) * size_t(size.y()));
		for (int j = first.y(); j < first.y() + size.y(); j++) {
			for (int i = first.x(); i < first.x() + size.x(); i++) {
				if (is_suspect(i, j)) {
					add(i, j);
				}
			}
		}
		while (!_waiting.empty()) {
			const auto [i, j] = _waiting.front();
			_waiting.pop_front();
			examine(i, j);
		}
		return std::move(_ledges);
	}

private:
	std::array<double, 4> corners(int p_i, int p_j) const {
		return { _heights.at(p_i, p_j), _heights.at(p_i + 1, p_j), _heights.at(p_i, p_j + 1), _heights.at(p_i + 1, p_j + 1) };
	}
	// p_x, p_z: of the way through the cell.
	double height(int p_i, int p_j, double p_x, double p_z) {
		if (!_search.between) {
			return blend(corners(p_i, p_j), p_x, p_z);
		}
		_ledges.sampled++;
		return _search.between(HeightBlock::centre(p_i, p_j) + Eigen::Vector2d(p_x, p_z) * GROUND_TEXEL);
	}

	// A few places in it, at random, so that a wall or a gap along the rows of texels is not missed everywhere.
	bool is_suspect(int p_i, int p_j) {
		const std::array<double, 4> four = corners(p_i, p_j);
		const auto missing = std::count_if(four.begin(), four.end(), [](double p_height) { return !std::isfinite(p_height); });
		if (missing > 0) {
			return missing < 4 && !_skips_missing && _search.between;
		}
		if (is_any_steep(four, _tangent)) {
			return true;
		}
		for (int n = 0; _search.between && n < PROBES * PROBES; n++) {
			const uint32_t bits = grass_hash(uint32_t(p_i) * 73856093u ^ uint32_t(p_j) * 19349663u ^ uint32_t(n) * 83492791u);
			const int column = n % PROBES, row = n / PROBES;
			const double x = (column + double(bits & 0xffffu) / 65536.0) / PROBES, z = (row + double(bits >> 16) / 65536.0) / PROBES;
			if (!(std::abs(height(p_i, p_j, x, z) - blend(four, x, z)) <= SUSPECT)) {
				return true;
			}
		}
		return false;
	}

	void add(int p_i, int p_j) {
		const Eigen::Array2i at = Eigen::Array2i(p_i, p_j) - _heights.get_first(), size = _heights.get_size() - 1;
		if ((at < 0).any() || (at >= size).any()) {
			return;
		}
		uint8_t &is_examined = _is_examined[size_t(at.y()) * size_t(size.x()) + size_t(at.x())];
		if (!is_examined) {
			is_examined = 1;
			_waiting.emplace_back(p_i, p_j);
		}
	}

	// Finely. A ledge that leaves the cell makes its neighbour suspect, so it is followed from where it was found.
	void examine(int p_i, int p_j) {
		const std::array<double, 4> four = corners(p_i, p_j);
		LedgeCell cell{ p_i, p_j, {} };
		std::array<bool, 4> leaves{}; // towards -x, +x, -z, +z
		double most = 0.0;
		for (int row = 0; row < POINTS; row++) {
			for (int column = 0; column < POINTS; column++) {
				const bool is_corner = column % SPOTS == 0 && row % SPOTS == 0;
				const double x = double(column) / SPOTS, z = double(row) / SPOTS;
				cell.at(column, row) = is_corner ? four[size_t(column / SPOTS + 2 * (row / SPOTS))] : height(p_i, p_j, x, z);
				const double off = std::abs(cell.at(column, row) - blend(four, x, z));
				const bool is_off = !(off <= SUSPECT);
				most = is_off && !std::isfinite(off) ? std::numeric_limits<double>::infinity() : std::max(most, off);
				const std::array<bool, 4> borders = { column == 0, column == SPOTS, row == 0, row == SPOTS };
				for (size_t n = 0; n < 4; n++) {
					leaves[n] = leaves[n] || (borders[n] && is_off);
				}
			}
		}
		if (!is_any_steep(four, _tangent) && !(most > SUSPECT && jumps(cell))) {
			return;
		}
		_ledges.cells.push_back(cell);
		constexpr std::array<std::array<int, 2>, 4> WAYS = { { { -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } } };
		for (size_t n = 0; n < 4; n++) {
			if (leaves[n] && _search.between) {
				add(p_i + WAYS[n][0], p_j + WAYS[n][1]);
			}
		}
	}

	// Whether the ground, where it rises most between two points, is steeper than a slope.
	bool jumps(const LedgeCell &p_cell) {
		Eigen::Array2d from = Eigen::Array2d::Zero(), to = Eigen::Array2d::Zero();
		double most = -1.0, low = 0.0, high = 0.0;
		for (int row = 0; row < POINTS; row++) {
			for (int column = 0; column < POINTS; column++) {
				for (int way = 0; way < 2; way++) {
					const int next_column = column + (way == 0 ? 1 : 0), next_row = row + (way == 1 ? 1 : 0);
					if (next_column >= POINTS || next_row >= POINTS) {
						continue;
					}
					const double here = p_cell.at(column, row), there = p_cell.at(next_column, next_row);
					if (std::isfinite(here) != std::isfinite(there)) {
						return true; // ground ends here
					}
					if (std::abs(there - here) > most) {
						most = std::abs(there - here);
						from = Eigen::Array2d(column, row) / SPOTS;
						to = Eigen::Array2d(next_column, next_row) / SPOTS;
						low = here;
						high = there;
					}
				}
			}
		}
		for (int n = 0; n < HALVINGS; n++) {
			const Eigen::Array2d middle = 0.5 * (from + to);
			const double between = height(p_cell.i, p_cell.j, middle.x(), middle.y());
			if (!std::isfinite(between)) {
				return true;
			}
			const bool is_first_half = std::abs(between - low) > std::abs(high - between);
			(is_first_half ? to : from) = middle;
			(is_first_half ? high : low) = between;
		}
		return std::abs(high - low) > _tangent * (to - from).matrix().norm() * GROUND_TEXEL;
	}

	const HeightBlock &_heights;
	const LedgeSearch &_search;
	bool _skips_missing;
	double _tangent;
	std::vector<uint8_t> _is_examined; // or waits to be
	std::deque<std::pair<int, int>> _waiting;
	Ledges _ledges;
};

// How far from the ground each code's height lies at a point of a cell. Infinite: so far that nothing may grow there.
std::array<double, 16> errors_at(const LedgeCell &p_cell, const std::array<LedgeCorner, 4> &p_corners, int p_column, int p_row) {
	const double x = double(p_column) / SPOTS, z = double(p_row) / SPOTS, there = p_cell.at(p_column, p_row);
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
		if (!std::isfinite(there)) { // what was no ground before stays so
			errors[code] = (code & ~missing) == 0 ? 0.0 : std::numeric_limits<double>::infinity();
			continue;
		}
		const glsl::vec4 weights = glsl::grass_ledge_weights(int(code), glsl::vec2(float(x), float(z)));
		double height = double(weights.x) * planes[0] + double(weights.y) * planes[1] + double(weights.z) * planes[2] +
				double(weights.w) * planes[3];
		if (code == GRASS_LEDGE_NONE) {
			height = blend({ p_corners[0].height, p_corners[1].height, p_corners[2].height, p_corners[3].height }, x, z);
		}
		errors[code] = std::abs(height - there);
	}
	errors[0] = std::numeric_limits<double>::infinity();
	return errors;
}

} // namespace

Ledges find_ledges(const HeightBlock &p_heights, const LedgeSearch &p_search, bool p_skips_missing) {
	return LedgeFinder(p_heights, p_search, p_skips_missing).run();
}

std::array<uint8_t, size_t(LedgeCell::SPOTS *LedgeCell::SPOTS)> ledge_codes(
		const LedgeCell &p_cell, const std::array<LedgeCorner, 4> &p_corners, double p_slope) {
	const double tangent = tangent_of(p_slope);
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
	std::array<std::array<double, 16>, size_t(POINTS * POINTS)> errors;
	for (int n = 0; n < POINTS * POINTS; n++) {
		errors[size_t(n)] = errors_at(p_cell, p_corners, n % POINTS, n / POINTS);
	}
	std::array<uint8_t, size_t(SPOTS * SPOTS)> codes{};
	for (int spot = 0; spot < SPOTS * SPOTS; spot++) {
		const size_t first = size_t(spot / SPOTS * POINTS + spot % SPOTS);
		double best = 0.0;
		for (unsigned code = 1; code < 16; code++) {
			double error = 0.0;
			for (const size_t point : { first, first + 1, first + size_t(POINTS), first + size_t(POINTS) + 1 }) {
				error = std::max(error, errors[point][code]);
			}
			// The most corners that fit: what lies beside the cell blends with them.
			const double score = std::popcount(code) + 1.0 - error;
			if (is_allowed[code] && error <= FITS && score > best) {
				best = score;
				codes[size_t(spot)] = uint8_t(code);
			}
		}
	}
	return codes;
}

Eigen::Vector2d slope_beside_ledge(const HeightBlock &p_heights, const LedgeSearch &p_search, int p_i, int p_j, int64_t &r_sampled) {
	const double tangent = tangent_of(p_search.slope), here = p_heights.at(p_i, p_j), step = p_search.between ? NEAR : GROUND_TEXEL;
	const auto height = [&](int p_di, int p_dj) {
		if (!p_search.between) {
			return p_heights.at(p_i + p_di, p_j + p_dj);
		}
		r_sampled++;
		return p_search.between(HeightBlock::centre(p_i, p_j) + step * Eigen::Vector2d(p_di, p_dj));
	};
	const auto slope = [&](int p_di, int p_dj) {
		const double ahead = (height(p_di, p_dj) - here) / step, behind = (here - height(-p_di, -p_dj)) / step;
		if (!std::isfinite(ahead) || !std::isfinite(behind)) {
			const double known = std::isfinite(ahead) ? ahead : (std::isfinite(behind) ? behind : 0.0);
			return std::abs(known) > tangent ? 0.0 : known;
		}
		const double mean = 0.5 * (ahead + behind), least = std::abs(ahead) < std::abs(behind) ? ahead : behind;
		const double chosen = std::abs(ahead - behind) < 0.2 ? mean : least; // else one of them is beyond the ledge
		return std::abs(chosen) > tangent ? 0.0 : chosen;
	};
	return { slope(1, 0), slope(0, 1) };
}

} // namespace grass
