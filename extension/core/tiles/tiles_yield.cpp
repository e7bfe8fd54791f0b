// SPDX-License-Identifier: MIT
// Which tiles give their slots to others while the pool is full: the calmest of those that nothing touches, and those under bodies that
// cameras see less well than others.
#include "core/tiles/tiles.h"

#include <bit>
#include <functional>

namespace grass {

// Retires the calmest tile that no collider meets in this step, and returns its slot. There must be such a tile. Never takes one that is
// met, since two tiles under colliders would take the slot from each other in every step. p_wanted: how many slots this step still needs.
int TileManager::take_calmest_slot(size_t p_wanted) {
	if (!_yielding_known) {
		_yielding_known = true;
		find_yielding(p_wanted);
	}
	const int slot = int(_yielding.back() & ((1 << SLOT_BITS) - 1));
	_yielding.pop_back();
	retire(slot, blend_of(slot) >= 1.0f);
	return slot;
}

TileManager::Calm TileManager::calm_of(int p_slot) const {
	const Motion &motion = _motions[size_t(p_slot)];
	constexpr uint32_t OLDEST = (1u << AGE_BITS) - 1;
	const uint32_t age = std::min(uint32_t(_step_number) - motion.met_step, OLDEST); // steps since the last meeting
	const Calm is_held = _held.has(p_slot) ? 1 : 0, is_up = _settling.has(p_slot) ? 0 : 1;
	return (((is_held << 32 | is_up << 31 | std::bit_cast<uint32_t>(motion.energy)) << AGE_BITS) | (OLDEST - age)) << SLOT_BITS |
			Calm(p_slot);
}

// Retires awake tiles in favour of those in view that waited in the last step, the least well seen first: out of view, then far away. Each
// gives way to one that is seen clearly better, so that no two of them take a slot from each other in turns.
void TileManager::yield_to_waiting() {
	_held.clear();
	_yielded.clear();
	if (!_meetings.is_short() || _view.sees_all()) {
		return;
	}
	_seen_worst.clear();
	for (const int slot : _used) {
		const TileBounds::Tile tile = _places[size_t(slot)].tile;
		const int band = _view.get_band({ tile.x, tile.x + 1, tile.z, tile.z + 1 }, TileParams::HELD_MARGIN);
		_held.insert_if(slot, band != TileView::UNSEEN);
		_seen_worst.push_back(band << SLOT_BITS | slot);
	}
	_statistics.ranked += _seen_worst.size();
	const std::span<const TileMeetings::Waiting> waiting = _meetings.get_waiting();
	const size_t most = std::min(waiting.size(), _seen_worst.size());
	std::partial_sort(_seen_worst.begin(), _seen_worst.begin() + std::ptrdiff_t(most), _seen_worst.end(), std::greater());
	size_t yielded = 0;
	while (yielded < most && waiting[yielded].band + TileParams::FARTHER_BANDS <= _seen_worst[yielded] >> SLOT_BITS) {
		const int slot = _seen_worst[yielded++] & ((1 << SLOT_BITS) - 1);
		retire(slot, blend_of(slot) >= 1.0f);
		_free.give_back(slot);
		_held.erase(slot);
		_yielded.push_back(_grid.get_index(_places[size_t(slot)].tile.x, _places[size_t(slot)].tile.z));
	}
	_statistics.yielded += yielded;
}

// Finds the calmest p_wanted tiles, calmest last.
void TileManager::find_yielding(size_t p_wanted) {
	constexpr size_t SAMPLES = 64;
	_calm.resize(size_t(_room));
	_yielding.resize(size_t(_room));
	size_t count = 0;
	_unmet.take_difference(_used, _met);
	for (const int slot : _unmet) {
		_calm[count++] = calm_of(slot);
	}
	// Few of many are wanted: a sample shows roughly how calm these are, and the others drop out unsorted.
	Calm bound = ~Calm(0);
	if (count > SAMPLES * 4) {
		std::array<Calm, SAMPLES> samples;
		for (size_t i = 0; i < SAMPLES; i++) {
			samples[i] = _calm[i * count / SAMPLES];
		}
		std::sort(samples.begin(), samples.end());
		const size_t rank = p_wanted * SAMPLES / count + SAMPLES / 16;
		bound = rank < SAMPLES ? samples[rank] : bound;
	}
	size_t chosen = 0;
	for (size_t i = 0; i < count; i++) {
		_yielding[chosen] = _calm[i];
		chosen += _calm[i] <= bound ? 1 : 0;
	}
	if (chosen < p_wanted) { // the sample was not representative
		std::copy_n(_calm.begin(), count, _yielding.begin());
		chosen = count;
	}
	_yielding.resize(chosen);
	if (p_wanted < chosen) {
		std::nth_element(_yielding.begin(), _yielding.begin() + std::ptrdiff_t(p_wanted), _yielding.end());
		_yielding.resize(p_wanted);
	}
	std::sort(_yielding.begin(), _yielding.end(), std::greater());
}

} // namespace grass
