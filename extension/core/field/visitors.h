// SPDX-License-Identifier: MIT
// Finds which bodies are in the grass, from tick to tick.
#pragma once

#include "core/bodies/body_shape.h"
#include "core/tiles/tiles.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace grass {

class Visitors {
public:
	struct Change {
		std::vector<uint64_t> exited, entered; // owners, ascending
	};

	// Returns the owners of colliders that entered grass in this tick, and of those that left it. Must be called after a tick of p_tiles
	// with p_colliders.
	Change update(const TileManager &p_tiles, std::span<const ColliderShape> p_colliders) {
		std::vector<uint64_t> now;
		for (size_t i = 0; i < p_colliders.size(); i++) {
			if (p_colliders[i].owner != 0 && p_colliders[i].force == ColliderShape::NO_FORCE && p_tiles.has_met_grass(i)) {
				now.push_back(p_colliders[i].owner);
			}
		}
		std::ranges::sort(now);
		now.erase(std::unique(now.begin(), now.end()), now.end());
		Change change;
		std::ranges::set_difference(_in_grass, now, std::back_inserter(change.exited));
		std::ranges::set_difference(now, _in_grass, std::back_inserter(change.entered));
		_in_grass.swap(now);
		return change;
	}
	// Must be called when the grass is removed. Returns the owners that were in it.
	std::vector<uint64_t> leave() { return std::exchange(_in_grass, {}); }

private:
	std::vector<uint64_t> _in_grass; // in the last tick, ascending
};

} // namespace grass
