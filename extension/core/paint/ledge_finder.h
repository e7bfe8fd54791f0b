// SPDX-License-Identifier: MIT
// Finds the cells of a block that have a ledge, some places at a time: by a few probes in each cell, and then in the cells through which a
// ledge goes on from where a probe met it. What it finds in a cell depends on the ground within FOLLOWS cells of it and on nothing else, so
// blocks may be read in any order and cut anywhere.
#pragma once

#include "core/paint/ledges.h"

#include <deque>

namespace grass {

class LedgeFinder {
public:
	// Cells in which a ledge is followed from where a probe met it. More: ever thinner walls are found whole. Less: fewer places are read
	// around a block.
	static constexpr int FOLLOWS = 4;
	// How far around a block of texels heights must be known to find its ledges, texels.
	static constexpr int margin(bool p_is_sheet) { return 1 + (p_is_sheet ? 0 : FOLLOWS); }
	static constexpr int PROBES = 2; // along a side of a cell
	static constexpr int HALVINGS = 4; // of the distance between two points of a cell, to see whether the ground jumps between them
	static constexpr int CELL_PLACES = LedgeCell::POINTS * LedgeCell::POINTS - 4 + HALVINGS; // read in a cell, at most

	// Finds ledges in the cells that have one of the texels from p_first to p_last at a corner. p_slope: degrees. p_skips_missing: cells at
	// a place without a height have no ledge.
	LedgeFinder(const Eigen::Array2i &p_first, const Eigen::Array2i &p_last, double p_slope, bool p_is_sheet, bool p_skips_missing);

	// Goes on reading. Returns true once everything is found.
	bool work(const HeightBlock &p_heights, GroundPlaces &r_places);
	const std::vector<LedgeCell> &get_cells() const { return _cells; }

private:
	static constexpr int POINTS = LedgeCell::POINTS, SPOTS = LedgeCell::SPOTS;
	struct Waiting {
		int i, j, steps; // away from the cell that a probe met
	};

	bool is_wanted(int p_i, int p_j) const { return steps_to_wanted(p_i, p_j) == 0; }
	int steps_to_wanted(int p_i, int p_j) const;
	std::array<double, 4> corners(const HeightBlock &p_heights, int p_i, int p_j) const;
	double height(const HeightBlock &p_heights, int p_i, int p_j, double p_x, double p_z, GroundPlaces &r_places) const;
	bool is_suspect(const HeightBlock &p_heights, int p_i, int p_j, GroundPlaces &r_places) const;
	void add(int p_i, int p_j, int p_steps);
	void examine(const HeightBlock &p_heights, const Waiting &p_cell, GroundPlaces &r_places);
	bool jumps(const HeightBlock &p_heights, const LedgeCell &p_cell, GroundPlaces &r_places) const;

	Eigen::Array2i _first_wanted, _last_wanted; // cells
	Eigen::Array2i _first, _size; // cells that are probed
	double _tangent;
	bool _is_sheet, _skips_missing;
	int64_t _probed = 0; // cells
	std::vector<uint8_t> _is_examined; // or waits to be
	std::deque<Waiting> _waiting; // those met by probes come first
	std::vector<LedgeCell> _cells;
};

} // namespace grass
