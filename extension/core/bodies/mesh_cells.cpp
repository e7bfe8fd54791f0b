// SPDX-License-Identifier: MIT
#include "core/bodies/mesh_cells.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// Cells along the longest side. More: finer cuts, and time by its third power.
constexpr int CELLS = 20;
// Number of a box's cells between which ways are tested, and number of places tested on each way.
constexpr int STATIONS = 48, STOPS = 3;
// The least size in metres, so that a line or a point has a volume too.
constexpr double SIZE_MIN = 1e-4;

} // namespace

MeshCells::MeshCells(std::span<const Eigen::Vector3d> p_corners) {
	Eigen::Vector3d low = p_corners.front(), high = low;
	for (const Eigen::Vector3d &corner : p_corners) {
		low = low.cwiseMin(corner);
		high = high.cwiseMax(corner);
	}
	_side = std::max((high - low).maxCoeff(), SIZE_MIN) / (CELLS - 1);
	_origin = low.array() - 0.5 * _side; // keeps everything away from the border
	_counts = ((high - _origin) / _side).array().floor().cast<int>() + 1;
	_kinds.assign(size_t(_counts.prod()), ENCLOSED);
	_places.resize(_kinds.size());
	for (size_t i = 0; i + 2 < p_corners.size(); i += 3) {
		mark_face(p_corners[i], p_corners[i + 1], p_corners[i + 2]);
	}
	flood();
}

Eigen::Vector3i MeshCells::cell_at(const Eigen::Vector3d &p_place) const {
	const Eigen::Vector3i cell = ((p_place - _origin) / _side).array().floor().cast<int>();
	return cell.cwiseMax(0).cwiseMin(_counts - Eigen::Vector3i::Ones());
}

// Marks the cells of a face by testing places on it, at most half a cell apart.
void MeshCells::mark_face(const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c) {
	const double longest = std::max({ (p_b - p_a).norm(), (p_c - p_b).norm(), (p_a - p_c).norm() });
	const int steps = std::max(1, int(std::ceil(longest / (0.5 * _side))));
	for (int i = 0; i <= steps; i++) {
		for (int k = 0; k + i <= steps; k++) {
			const Eigen::Vector3d place = p_a + (p_b - p_a) * (double(i) / steps) + (p_c - p_a) * (double(k) / steps);
			const size_t index = size_t(index_of(cell_at(place)));
			if (_kinds[index] != PASSED) {
				_kinds[index] = PASSED;
				_places[index] = place;
			}
		}
	}
}

// Marks what can be reached from the border as outside; what remains is enclosed.
void MeshCells::flood() {
	std::vector<Eigen::Vector3i> open;
	const auto reach = [&](const Eigen::Vector3i &p_cell) {
		Kind &kind = _kinds[size_t(index_of(p_cell))];
		if (kind == ENCLOSED) {
			kind = OUTSIDE;
			open.push_back(p_cell);
		}
	};
	for (int x = 0; x < _counts.x(); x++) {
		for (int y = 0; y < _counts.y(); y++) {
			for (int z = 0; z < _counts.z(); z++) {
				const Eigen::Vector3i cell(x, y, z);
				_places[size_t(index_of(cell))] = _kinds[size_t(index_of(cell))] == PASSED
						? _places[size_t(index_of(cell))]
						: Eigen::Vector3d(corner_of(cell).array() + 0.5 * _side);
				if ((cell.array() == 0).any() || (cell.array() == _counts.array() - 1).any()) {
					reach(cell);
				}
			}
		}
	}
	while (!open.empty()) {
		const Eigen::Vector3i cell = open.back();
		open.pop_back();
		for (int axis = 0; axis < 3; axis++) {
			for (const int step : { -1, 1 }) {
				Eigen::Vector3i next = cell;
				next[axis] += step;
				if (next[axis] >= 0 && next[axis] < _counts[axis]) {
					reach(next);
				}
			}
		}
	}
}

MeshCells::Shape MeshCells::look_at(const CellBox &p_box) const {
	std::vector<int> filled;
	for (int x = p_box.low.x(); x < p_box.high.x(); x++) {
		for (int y = p_box.low.y(); y < p_box.high.y(); y++) {
			const int first = index_of({ x, y, 0 });
			for (int z = p_box.low.z(); z < p_box.high.z(); z++) {
				if (_kinds[size_t(first + z)] != OUTSIDE) {
					filled.push_back(first + z);
				}
			}
		}
	}
	const size_t stations = std::min(filled.size(), size_t(STATIONS));
	int outside = 0, looks = 0;
	for (size_t i = 0; i < stations; i++) {
		const Eigen::Vector3d &from = _places[size_t(filled[i * filled.size() / stations])];
		for (size_t k = i + 1; k < stations; k++) {
			const Eigen::Vector3d &to = _places[size_t(filled[k * filled.size() / stations])];
			for (int stop = 1; stop <= STOPS; stop++) {
				outside += is_outside(from + (to - from) * (double(stop) / (STOPS + 1))) ? 1 : 0;
				looks++;
			}
		}
	}
	return { int(filled.size()), looks > 0 ? double(outside) / looks : 0.0 };
}

std::vector<Eigen::Vector3d> MeshCells::enclosed_corners(const CellBox &p_box) const {
	std::vector<Eigen::Vector3d> corners;
	for (int i = 0; i < 8; i++) {
		const Eigen::Vector3i corner(
				i & 1 ? p_box.high.x() : p_box.low.x(), i & 2 ? p_box.high.y() : p_box.low.y(), i & 4 ? p_box.high.z() : p_box.low.z());
		// Corners at the grid's border are outside, and so are those clamped to it.
		if (_kinds[size_t(index_of(corner.cwiseMin(_counts - Eigen::Vector3i::Ones())))] == ENCLOSED) {
			corners.push_back(corner_of(corner));
		}
	}
	return corners;
}

} // namespace grass
