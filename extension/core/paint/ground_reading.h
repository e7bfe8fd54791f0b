// SPDX-License-Identifier: MIT
// The ground below a block of texels as it is being read, some places at a time: heights, then ledges, then slopes beside ledges. Once it
// is complete, lay_ground() writes it into a map.
#pragma once

#include "core/map/map_layers.h"
#include "core/paint/ledge_finder.h"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace grass {

// What a texel without a height is: ground that is not known, which stays as it was, or a hole in it, in which nothing grows.
enum class MissingGround { STAYS, HOLE };

struct GroundRule {
	MissingGround missing = MissingGround::STAYS;
	double ledge_slope = LEDGE_SLOPE.initial; // degrees
	bool is_sheet = false; // between the centres of texels the ground is one sheet
	GroundGrid grid; // of the map that the ground is for
};

class GroundReading {
public:
	// How far around a change of the ground the laid ground may change, texels.
	static constexpr int REACH = LedgeFinder::FOLLOWS + 2;
	// The fewest places that a call must allow, so that reading makes progress.
	static constexpr int LEAST_PLACES = LedgeFinder::CELL_PLACES;

	// Begins to read every texel whose height lies in p_region and within the map's reach.
	GroundReading(const MapRegion &p_region, const GroundRule &p_rule);

	// Goes on reading, up to p_most places. Returns true once everything is read. p_between: heights anywhere; a sheet needs none.
	bool read(const HeightAt &p_height, const HeightAt &p_between, int64_t p_most = GroundPlaces::ALL);

	const GroundRule &get_rule() const { return _rule; }
	bool is_empty() const { return !_heights; }
	bool is_out_of_reach() const { return _is_out_of_reach; } // some of the region
	int64_t get_sampled() const { return _sampled; } // places read so far
	const Eigen::Array2i &get_first() const { return _first; } // texels
	const Eigen::Array2i &get_last() const { return _last; }

	const HeightBlock &get_heights() const { return *_heights; }
	const std::vector<LedgeCell> &get_ledges() const { return _finder->get_cells(); }
	bool has_ledge(int p_i, int p_j) const { return !_ledges.empty() && _ledges.contains({ p_i, p_j }); }
	// Where a texel's height lies, metres.
	Eigen::Vector2d place(int p_i, int p_j) const { return HeightBlock::centre(p_i, p_j) + _rule.grid.offset(); }
	Eigen::Vector3d normal(int p_i, int p_j) const;

private:
	bool work(GroundPlaces &r_places);
	void list_ledges();

	GroundRule _rule;
	Eigen::Array2i _first = Eigen::Array2i::Zero(), _last = Eigen::Array2i::Zero();
	bool _is_out_of_reach = false;
	std::optional<HeightBlock> _heights;
	std::optional<LedgeFinder> _finder;
	std::set<std::pair<int, int>> _ledges; // first texels of the cells that have one
	std::vector<std::pair<int, int>> _beside; // texels beside a ledge
	std::map<std::pair<int, int>, Eigen::Vector2d> _slopes; // of those, one after the other: rise over run along x, z
	int64_t _sampled = 0;
};

} // namespace grass
