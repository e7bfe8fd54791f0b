// SPDX-License-Identifier: MIT
// What TileManager hands to the backend.
#include "core/bodies/collider.h"
#include "core/tiles/tiles.h"

#include <limits>
#include <utility>

namespace grass {

// Drops the meetings of tiles that are not simulated, counts the others by slot, and packs the colliders in use. Forces have no entries in
// the list: a bit in each tile's record is all.
void TileManager::count_meetings(std::span<const ColliderShape> p_colliders) {
	_colliders.clear();
	_planes.clear();
	_sharp.clear();
	std::fill(_entries.begin(), _entries.end(), 0);
	size_t kept = 0;
	uint32_t last = std::numeric_limits<uint32_t>::max();
	std::fill(_forces.begin(), _forces.end(), 0);
	for (const Meeting &meeting : _meetings) { // rising by collider
		const int slot = meeting.slot, force = p_colliders[meeting.collider].force;
		if (force != ColliderShape::NO_FORCE) {
			_forces[size_t(slot)] |= uint16_t(1u << force);
		} else if (!_skipped.has(slot)) {
			if (meeting.collider != last) {
				last = meeting.collider;
				pack_collider(p_colliders[last]);
			}
			_entries[size_t(slot)]++;
			_meetings[kept++] = { slot, uint32_t(_colliders.size() - 1) };
		}
	}
	_meetings.resize(kept);
	_statistics.list_entries = int(kept);
}

void TileManager::pack_collider(const ColliderShape &p_collider) {
	_colliders.push_back(p_collider.pack(_grid, int(_planes.size())));
	_sharp.push_back(is_sharp(_colliders.back(), float(_params.segment)));
	if (p_collider.type == GRASS_HULL) {
		_planes.insert(_planes.end(), p_collider.planes.begin(), p_collider.planes.end());
	}
}

// One record each of the awake tiles that are simulated.
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

// Each tile's colliders, in the order in which update() got them.
void TileManager::write_list() {
	_collider_list.resize(_meetings.size());
	for (const Meeting &meeting : _meetings) {
		_collider_list[_entries[size_t(meeting.slot)]++] = meeting.collider;
	}
}

} // namespace grass
