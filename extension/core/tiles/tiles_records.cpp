// SPDX-License-Identifier: MIT
// The records that TileManager hands to the backend.
#include "core/tiles/tiles.h"

#include <utility>

namespace grass {

namespace {

// Steps in which a blade gets to where the one that it follows now has it, after other blades of its tile are simulated than before.
// Fewer: it jumps. More: it is behind in the meantime.
constexpr uint8_t STEPS_APART = 16;

int left_out(int p_blades) {
	return GRASS_BLADES_PER_TILE - p_blades;
}

} // namespace

// Removes the meetings of tiles that are not simulated, counts the others by slot, and packs the colliders in use. Forces have no entries
// in the list: each is only a bit in a tile's record.
void TileManager::count_meetings(std::span<const ColliderShape> p_colliders) {
	_colliders.clear();
	std::fill(_entries.begin(), _entries.end(), 0);
	size_t kept = 0;
	uint32_t last = std::numeric_limits<uint32_t>::max(), number = 0;
	std::vector<TileMeetings::Meeting> &meetings = _meetings.get();
	std::fill(_forces.begin(), _forces.end(), 0);
	std::fill(_air.begin(), _air.end(), 0.0f);
	for (const TileMeetings::Meeting &meeting : meetings) { // ascending by collider
		const int slot = meeting.slot, force = p_colliders[meeting.collider].force;
		if (force != ColliderShape::NO_FORCE) {
			_forces[size_t(slot)] |= uint16_t(1u << force);
			_air[size_t(slot)] += p_colliders[meeting.collider].air;
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

// Returns whether the blades of a tile move by their strains. A chain that a body has bent swings freely first, and so comes near to their
// few functions; one that only a breeze has moved is near them from the start. p_colliders: in the tile.
bool TileManager::is_alone(int p_slot, uint32_t p_colliders) {
	const Blades &blades = _blades[size_t(p_slot)];
	Times &times = _times[size_t(p_slot)];
	if (p_colliders > 0 || blades.drawn > blades.simulated || double(_air[size_t(p_slot)]) > _params.alone_air) {
		times.chained = _time;
	}
	return _time - times.chained > _params.alone_time;
}

// Writes one record for each awake tile that is simulated.
void TileManager::write_records() {
	const uint32_t mapped = _params.is_mapped ? GRASS_SLOT_MAPPED : 0;
	uint32_t entries = 0;
	GrassSlot *record = _records.data() + _record_count;
	_followers.clear();
	_simulated.take_difference(_used, _skipped);
	for (const int slot : _simulated) {
		const Place &place = _places[size_t(slot)];
		const int x = place.tile.x, z = place.tile.z;
		const uint32_t count = std::exchange(_entries[size_t(slot)], entries);
		const bool is_far = _params.contact_distance > 0.0 && !_detail.is_within(x, z, _params.contact_distance);
		const uint32_t flags = (is_alone(slot, count) ? GRASS_SLOT_ALONE : 0) | (is_far ? GRASS_SLOT_FAR : 0) |
				(_fresh.has(slot) ? GRASS_SLOT_FRESH : 0) | (_settling.has(slot) ? GRASS_SLOT_SETTLING : 0) | mapped |
				uint32_t(_forces[size_t(slot)]) << GRASS_SLOT_FORCES;
		// All blades of a fresh tile are put to rest, so that those which are not simulated afterwards are in the picture once they are
		// drawn.
		const int blades = _fresh.has(slot) ? GRASS_BLADES_PER_TILE : int(_blades[size_t(slot)].simulated);
		*record = { { x, z, _grid.get_index(x, z), slot }, { place.start, entries, count, flags },
			{ blend_of(slot), float(left_out(blades)), 0.0f, 0.0f }, {} };
		write_follower(*record++);
		entries += count;
		_statistics.left_out_blades += uint64_t(left_out(blades));
	}
	_record_count = size_t(record - _records.data());
	_statistics.awake = _used.count();
	_statistics.simulated = _simulated.count();
	_statistics.settling = _settling.count();
	_statistics.tile_steps += uint64_t(_statistics.simulated);
	_statistics.high_water = std::max(_statistics.high_water, _statistics.awake);
	_met.clear();
	_stirred.clear();
	_fresh.clear();
}

// Writes the record of a tile's followers. A fresh tile has none: all of its blades take the step. Followers in a tile that comes to rest
// come to rest, too.
void TileManager::write_follower(const GrassSlot &p_record) {
	Blades &blades = _blades[size_t(p_record.tile.w)];
	if (blades.drawn <= blades.simulated || (p_record.list.w & GRASS_SLOT_FRESH) != 0) {
		blades.steps_apart = 0;
		return;
	}
	const float share = std::max(1.0f / float(std::max<int>(blades.steps_apart, 1)), p_record.blend.x);
	blades.steps_apart -= blades.steps_apart > 0 ? 1 : 0;
	_followers.push_back(p_record);
	const float sources = float(left_out(blades.simulated));
	_followers.back().blend = { share, float(left_out(blades.drawn)), sources, sources };
	_statistics.followed_blades += uint64_t(blades.drawn - blades.simulated);
}

std::span<const GrassSlot> TileManager::widen() {
	_widened.clear();
	for (const int slot : _used) {
		const Place &place = _places[size_t(slot)];
		Blades &blades = _blades[size_t(slot)];
		const int x = place.tile.x, z = place.tile.z, wanted = _detail.blades_of(x, z, blades.drawn);
		if (wanted > blades.drawn) {
			const uint32_t mapped = _params.is_mapped ? GRASS_SLOT_MAPPED : 0;
			_widened.push_back({ { x, z, _grid.get_index(x, z), slot }, { place.start, 0, 0, mapped },
					{ 1.0f, float(left_out(wanted)), float(left_out(blades.drawn)), float(left_out(blades.simulated)) }, {} });
		}
		const int simulated = _detail.simulated_of(x, z, blades.simulated, wanted);
		blades = { uint8_t(wanted), uint8_t(simulated), simulated == blades.simulated ? blades.steps_apart : STEPS_APART };
	}
	_statistics.widened += _widened.size();
	return _widened;
}

// Writes each tile's colliders, in the order in which update() got them.
void TileManager::write_list() {
	_collider_list.resize(_meetings.get().size());
	for (const TileMeetings::Meeting &meeting : _meetings.get()) {
		_collider_list[_entries[size_t(meeting.slot)]++] = meeting.collider;
	}
}

} // namespace grass
