// SPDX-License-Identifier: MIT
// The records that TileManager hands to the backend.
#include "core/tiles/tiles.h"

#include <limits>
#include <utility>

namespace grass {

// Removes the meetings of tiles that are not simulated, counts the others by slot, and packs the colliders in use. Forces have no entries
// in the list: each is only a bit in a tile's record.
void TileManager::count_meetings(std::span<const ColliderShape> p_colliders) {
	_colliders.clear();
	std::fill(_entries.begin(), _entries.end(), 0);
	size_t kept = 0;
	uint32_t last = std::numeric_limits<uint32_t>::max(), number = 0;
	std::vector<TileMeetings::Meeting> &meetings = _meetings.get();
	std::fill(_forces.begin(), _forces.end(), 0);
	for (const TileMeetings::Meeting &meeting : meetings) { // ascending by collider
		const int slot = meeting.slot, force = p_colliders[meeting.collider].force;
		if (force != ColliderShape::NO_FORCE) {
			_forces[size_t(slot)] |= uint16_t(1u << force);
		} else if (!_skipped.has(slot)) {
			if (meeting.collider != last) {
				last = meeting.collider;
				number = _colliders.add(p_colliders[last], _grid, _params.segment);
			}
			_entries[size_t(slot)]++;
			meetings[kept++] = { slot, number };
		}
	}
	meetings.resize(kept);
	_statistics.list_entries = int(kept);
}

// Writes one record for each awake tile that is simulated.
void TileManager::write_records() {
	const uint32_t mapped = _params.is_mapped ? GRASS_SLOT_MAPPED : 0;
	uint32_t entries = 0;
	GrassSlot *record = _records.data() + _record_count;
	_simulated.take_difference(_used, _skipped);
	for (const int slot : _simulated) {
		const Place &place = _places[size_t(slot)];
		const int x = place.tile.x, z = place.tile.z;
		const uint32_t count = std::exchange(_entries[size_t(slot)], entries);
		const uint32_t flags = (_fresh.has(slot) ? GRASS_SLOT_FRESH : 0) | (_settling.has(slot) ? GRASS_SLOT_SETTLING : 0) | mapped |
				uint32_t(_forces[size_t(slot)]) << GRASS_SLOT_FORCES;
		*record++ = { { x, z, _grid.get_index(x, z), slot }, { place.start, entries, count, flags }, { blend_of(slot), 0.0f, 0.0f, 0.0f } };
		entries += count;
	}
	_record_count = size_t(record - _records.data());
	_statistics.awake = _used.count();
	_statistics.simulated = _simulated.count();
	_statistics.settling = _settling.count();
	_statistics.tile_steps += uint64_t(_statistics.simulated);
	_statistics.unseen_steps += uint64_t(_statistics.awake - _statistics.simulated - _statistics.still);
	_statistics.still_steps += uint64_t(_statistics.still);
	_statistics.high_water = std::max(_statistics.high_water, _statistics.awake);
	_met.clear();
	_stirred.clear();
	_fresh.clear();
}

// Writes each tile's colliders, in the order in which update() got them.
void TileManager::write_list() {
	_collider_list.resize(_meetings.get().size());
	for (const TileMeetings::Meeting &meeting : _meetings.get()) {
		_collider_list[_entries[size_t(meeting.slot)]++] = meeting.collider;
	}
}

} // namespace grass
