// SPDX-License-Identifier: MIT
#include "core/paint/ledge_finder.h"

#include "core/base/hash.h"

#include <algorithm>

namespace grass {

namespace {

// Metres that the ground may be away from where grass is put, before a cell counts as one with a ledge.
constexpr double SUSPECT = 0.03;

bool is_any_steep(const std::array<double, 4> &p_corners, double p_tangent) {
	const auto is_steep = [&](size_t p_a, size_t p_b) { return std::abs(p_corners[p_a] - p_corners[p_b]) > p_tangent * GROUND_TEXEL; };
	return is_steep(0, 1) || is_steep(2, 3) || is_steep(0, 2) || is_steep(1, 3);
}

} // namespace

LedgeFinder::LedgeFinder(
		const Eigen::Array2i &p_first, const Eigen::Array2i &p_last, double p_slope, bool p_is_sheet, bool p_skips_missing) :
		_first_wanted(p_first - 1),
		_last_wanted(p_last),
		_first(p_first - margin(p_is_sheet)),
		_size(p_last - p_first + 2 * margin(p_is_sheet)),
		_tangent(ledge_tangent(p_slope)),
		_is_sheet(p_is_sheet),
		_skips_missing(p_skips_missing),
		_is_examined(size_t(_size.x()) * size_t(_size.y())) {}

int LedgeFinder::steps_to_wanted(int p_i, int p_j) const {
	const Eigen::Array2i at(p_i, p_j);
	return (_first_wanted - at).max(at - _last_wanted).max(0).sum();
}

bool LedgeFinder::work(const HeightBlock &p_heights, GroundPlaces &r_places) {
	for (const int64_t count = int64_t(_is_examined.size()); _probed < count; _probed++) {
		if (!r_places.has(PROBES * PROBES)) {
			return false;
		}
		const int i = _first.x() + int(_probed % _size.x()), j = _first.y() + int(_probed / _size.x());
		if (steps_to_wanted(i, j) <= FOLLOWS && is_suspect(p_heights, i, j, r_places)) {
			add(i, j, 0);
		}
	}
	for (; !_waiting.empty(); _waiting.pop_front()) {
		if (!r_places.has(CELL_PLACES)) {
			return false;
		}
		examine(p_heights, Waiting(_waiting.front()), r_places);
	}
	return true;
}

std::array<double, 4> LedgeFinder::corners(const HeightBlock &p_heights, int p_i, int p_j) const {
	return { p_heights.at(p_i, p_j), p_heights.at(p_i + 1, p_j), p_heights.at(p_i, p_j + 1), p_heights.at(p_i + 1, p_j + 1) };
}

// Returns the height at a place of a cell. p_x, p_z: share of the way through it.
double LedgeFinder::height(const HeightBlock &p_heights, int p_i, int p_j, double p_x, double p_z, GroundPlaces &r_places) const {
	return _is_sheet ? blend_corners(corners(p_heights, p_i, p_j), p_x, p_z)
					 : r_places.between(HeightBlock::centre(p_i, p_j) + Eigen::Vector2d(p_x, p_z) * GROUND_TEXEL);
}

// Returns whether a cell may have a ledge, by a few random places in it: so a wall or a gap along the rows of texels is not missed
// everywhere.
bool LedgeFinder::is_suspect(const HeightBlock &p_heights, int p_i, int p_j, GroundPlaces &r_places) const {
	const std::array<double, 4> four = corners(p_heights, p_i, p_j);
	const auto missing = std::count_if(four.begin(), four.end(), [](double p_height) { return !std::isfinite(p_height); });
	if (missing > 0) {
		return missing < 4 && !_skips_missing && !_is_sheet;
	}
	if (is_any_steep(four, _tangent)) {
		return true;
	}
	for (int n = 0; !_is_sheet && n < PROBES * PROBES; n++) {
		const uint32_t bits = grass_hash(uint32_t(p_i) * 73856093u ^ uint32_t(p_j) * 19349663u ^ uint32_t(n) * 83492791u);
		const int column = n % PROBES, row = n / PROBES;
		const double x = (column + double(bits & 0xffffu) / 65536.0) / PROBES, z = (row + double(bits >> 16) / 65536.0) / PROBES;
		if (!(std::abs(height(p_heights, p_i, p_j, x, z, r_places) - blend_corners(four, x, z)) <= SUSPECT)) {
			return true;
		}
	}
	return false;
}

// Leaves out what cannot lead to a wanted cell.
void LedgeFinder::add(int p_i, int p_j, int p_steps) {
	const Eigen::Array2i at = Eigen::Array2i(p_i, p_j) - _first;
	if (p_steps + steps_to_wanted(p_i, p_j) > FOLLOWS || (at < 0).any() || (at >= _size).any()) {
		return;
	}
	uint8_t &is_examined = _is_examined[size_t(at.y()) * size_t(_size.x()) + size_t(at.x())];
	if (!is_examined) {
		is_examined = 1;
		_waiting.push_back({ p_i, p_j, p_steps });
	}
}

// Examines a cell closely. A ledge that leaves the cell makes its neighbour suspect, so it is followed from where it was found.
void LedgeFinder::examine(const HeightBlock &p_heights, const Waiting &p_cell, GroundPlaces &r_places) {
	const std::array<double, 4> four = corners(p_heights, p_cell.i, p_cell.j);
	LedgeCell cell{ p_cell.i, p_cell.j, {} };
	std::array<bool, 4> leaves{}; // towards -x, +x, -z, +z
	double most = 0.0;
	for (int row = 0; row < POINTS; row++) {
		for (int column = 0; column < POINTS; column++) {
			const bool is_corner = column % SPOTS == 0 && row % SPOTS == 0;
			const double x = double(column) / SPOTS, z = double(row) / SPOTS;
			cell.at(column, row) =
					is_corner ? four[size_t(column / SPOTS + 2 * (row / SPOTS))] : height(p_heights, p_cell.i, p_cell.j, x, z, r_places);
			const double off = std::abs(cell.at(column, row) - blend_corners(four, x, z));
			const bool is_off = !(off <= SUSPECT);
			most = is_off && !std::isfinite(off) ? std::numeric_limits<double>::infinity() : std::max(most, off);
			const std::array<bool, 4> borders = { column == 0, column == SPOTS, row == 0, row == SPOTS };
			for (size_t n = 0; n < 4; n++) {
				leaves[n] = leaves[n] || (borders[n] && is_off);
			}
		}
	}
	if (!is_any_steep(four, _tangent) && !(most > SUSPECT && jumps(p_heights, cell, r_places))) {
		return;
	}
	if (is_wanted(p_cell.i, p_cell.j)) {
		_cells.push_back(cell);
	}
	constexpr std::array<std::array<int, 2>, 4> WAYS = { { { -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } } };
	for (size_t n = 0; n < 4; n++) {
		if (leaves[n] && !_is_sheet) {
			add(p_cell.i + WAYS[n][0], p_cell.j + WAYS[n][1], p_cell.steps + 1);
		}
	}
}

// Returns whether the ground, where it rises most between two points, is steeper than a slope.
bool LedgeFinder::jumps(const HeightBlock &p_heights, const LedgeCell &p_cell, GroundPlaces &r_places) const {
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
		const double between = height(p_heights, p_cell.i, p_cell.j, middle.x(), middle.y(), r_places);
		if (!std::isfinite(between)) {
			return true;
		}
		const bool is_first_half = std::abs(between - low) > std::abs(high - between);
		(is_first_half ? to : from) = middle;
		(is_first_half ? high : low) = between;
	}
	return std::abs(high - low) > _tangent * (to - from).matrix().norm() * GROUND_TEXEL;
}

} // namespace grass
