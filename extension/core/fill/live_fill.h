// SPDX-License-Identifier: MIT
// Keeps a map filled by a rule while rule, sources, ground and map change: queues the chunks to fill again, and fills a
// few at a time.
#pragma once

#include "core/fill/fill.h"

#include <set>

namespace grass {

class LiveFill {
public:
	// Sets what the map shall be filled by. Queues only the chunks that this changes: call it as often as you like.
	void set(const FillRule &p_rule, const FillSources &p_sources, const MapRegion &p_area);
	// Somebody else changed these chunks. p_replaced: anything in them may differ (a snapshot, a file). Otherwise only new
	// ground counts, since the fill already respects what hands painted.
	void touch(const PaintMap &p_map, std::span<const MapKey> p_keys, bool p_replaced);
	void touch_all() { wait(_area); }
	// The terrain's textures are others there.
	void touch_textures(const MapRegion &p_region);
	// Fills up to p_count of the chunks that wait; all, if negative.
	FillResult work(PaintMap &r_map, int p_count, const ParallelFor &p_parallel_for = serial_for);
	// Removes the rule and what it filled: all of it returns to the map's base density.
	FillResult remove(PaintMap &r_map, const ParallelFor &p_parallel_for = serial_for);

	bool is_set() const { return _is_set; }
	int64_t get_waiting() const { return int64_t(_waiting.size()); } // chunks

private:
	using Ground = std::array<std::shared_ptr<const MapTexels>, 3>; // height, normal, ledges

	static Ground ground_of(const PaintMap &p_map, const MapKey &p_key);
	bool asks_ground() const { return _rule.asks_slope() || _rule.asks_height() || !_sources.obstacles.empty(); }
	void wait(const MapRegion &p_area);

	bool _is_set = false;
	FillRule _rule;
	FillSources _sources;
	MapRegion _area;
	std::set<MapKey> _waiting;
	// The ground that each chunk was filled on. While this holds the texels, a change makes the map copy them: a new pointer.
	std::map<MapKey, Ground> _filled_on;
};

} // namespace grass
