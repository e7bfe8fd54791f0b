// SPDX-License-Identifier: MIT
// What TileManager hands to the backend.
#include "core/tiles.h"

#include <limits>

namespace grass {

// Drops the touches of tiles that got no slot or are not simulated, counts the others by slot, and packs the objects in use.
void TileManager::count_touches(std::span<const ColliderShape> p_colliders) {
	_colliders.clear();
	_planes.clear();
	size_t kept = 0;
	uint32_t last = std::numeric_limits<uint32_t>::max();
	for (const Touch &touch : _touches) { // rising by collider
		const int slot = touch.slot >= 0 ? touch.slot : _given_slots[size_t(~touch.slot)];
		if (slot != SlotSet::NONE && !_marks[size_t(slot)].is_unseen) {
			if (touch.collider != last) {
				last = touch.collider;
				pack_collider(p_colliders[last]);
			}
			_marks[size_t(slot)].list_count++;
			_touches[kept++] = { slot, uint32_t(_colliders.size() - 1) };
		}
	}
	_touches.resize(kept);
	_statistics.colliders = int(_colliders.size());
	_statistics.list_entries = int(kept);
}

void TileManager::pack_collider(const ColliderShape &p_collider) {
	_colliders.push_back(p_collider.pack(_grid, int(_planes.size())));
	if (p_collider.type == GRASS_HULL) {
		_planes.insert(_planes.end(), p_collider.planes.begin(), p_collider.planes.end());
	}
}

// One pass over the awake tiles, which also readies them for the next step: they are many, and lie far apart in memory.
void TileManager::write_records() {
	_statistics.awake = _statistics.simulated = _statistics.settling = 0;
	uint32_t entries = 0;
	for (const int slot : _used) {
		const Place &place = _places[size_t(slot)];
		Mark &mark = _marks[size_t(slot)];
		_statistics.awake++;
		if (mark.is_unseen) {
			_statistics.unseen_steps++;
		} else {
			const uint32_t flags = (mark.is_fresh ? GRASS_SLOT_FRESH : 0) | (mark.is_settling ? GRASS_SLOT_SETTLING : 0) |
					(_params.is_mapped ? GRASS_SLOT_MAPPED : 0);
			_records.push_back({ { place.x, place.z, place.tile, slot }, { place.start, entries, mark.list_count, flags },
					{ mark.blend, 0.0f, 0.0f, 0.0f } });
			_statistics.simulated++;
		}
		_statistics.settling += mark.is_settling ? 1 : 0;
		const uint32_t count = mark.list_count;
		mark.list_count = 0;
		mark.list_next = entries;
		mark.is_fresh = mark.is_unseen = false;
		entries += count;
	}
	_touched.reset(_params.pool_size, false);
	_stirred.reset(_params.pool_size, false);
	_statistics.tile_steps += uint64_t(_statistics.simulated);
	_statistics.high_water = std::max(_statistics.high_water, _statistics.awake);
}

// Each tile's objects, in the order in which they were given.
void TileManager::write_list() {
	_collider_list.resize(_touches.size());
	for (const Touch &touch : _touches) {
		_collider_list[_marks[size_t(touch.slot)].list_next++] = touch.collider;
	}
}

} // namespace grass
