// SPDX-License-Identifier: MIT
// Keeps a map filled by a rule while rule, sources, ground and map change: queues the chunks to fill again, and fills a few at a time.
#pragma once

#include "core/fill/fill.h"

#include <set>

namespace grass {

class LiveFill {
public:
	// Sets the rule, sources and area to fill by. Queues only the chunks that this changes, so it may be called as often as needed.
	void set(const FillRule &p_rule, const FillSources &p_sources, const MapRegion &p_area);
	// Queues chunks that were changed by other means than filling. p_replaced: anything in them may differ (a snapshot, a file). Otherwise
	// only new ground counts, since filling respects paint by hand already.
	void touch(const PaintMap &p_map, std::span<const MapKey> p_keys, bool p_replaced);
	void touch_all();
	// Queues the chunks of a region where the terrain shows other textures.
	void touch_textures(const MapRegion &p_region);
	// Fills up to p_count of the waiting chunks; all of them if negative.
	FillResult work(PaintMap &r_map, int p_count, const ParallelFor &p_parallel_for = serial_for);
	// Removes the rule and what it filled: everything returns to the map's base density.
	FillResult remove(PaintMap &r_map, const ParallelFor &p_parallel_for = serial_for);

	bool is_set() const { return _is_set; }
	int64_t get_waiting() const { return int64_t(_waiting.size()); } // chunks

private:
	using Ground = std::array<std::shared_ptr<const MapTexels>, 3>; // height, normal, ledges

	static Ground ground_of(const PaintMap &p_map, const MapKey &p_key);
	bool asks_ground() const { return _rule.asks_slope() || _rule.asks_height() || !_sources.obstacles.empty(); }
	void wait(const MapRegion &p_area);
	void wait(const FillObstacle &p_obstacle);
	bool is_waiting(const FillObstacle &p_obstacle) const; // whether a place where it changes the grass is

	bool _is_set = false;
	FillRule _rule;
	FillSources _sources;
	MapRegion _area;
	std::set<MapKey> _waiting;
	// The ground on which each chunk was filled. While this shares the texels, the map copies them before a change, so that their pointer
	// changes.
	std::map<MapKey, Ground> _filled_on;
};

} // namespace grass
