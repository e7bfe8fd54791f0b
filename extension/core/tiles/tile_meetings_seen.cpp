// SPDX-License-Identifier: MIT
// Which sleeping tiles get the slots of a pool that is too small, where cameras see some of them.
#include "core/tiles/tile_meetings.h"

namespace grass {

// Queues tiles in view before all others, those near an eye first, and notes those in view that find no slot. p_room: slots that there are
// to give. Returns how many of them all tiles together may have: those out of view take none from an awake tile in view.
size_t TileMeetings::queue_seen_tiles(size_t p_room) {
	_waiting.clear();
	size_t asleep = 0;
	for (const Block &block : get_blocks()) {
		for (const Way &way : block.ways) {
			asleep += size_t(way.asleep);
		}
	}
	_is_short = asleep > p_room;
	_refused = _is_short ? int(asleep - p_room) : 0;
	if (!_is_short || _tiles->view.sees_all()) {
		return p_room;
	}
	find_seen_ways();
	const size_t most_waiting = size_t(_tiles->params.most_yielding());
	for (const SeenWay &seen : _seen_ways) {
		if (_wanted.size() >= p_room && _waiting.size() >= most_waiting) {
			break;
		}
		queue_seen_tiles_of(seen, p_room, most_waiting);
	}
	std::ranges::sort(_waiting, {}, &Waiting::tile); // two bodies may wait for one tile
	const auto is_same = [](const Waiting &p_a, const Waiting &p_b) { return p_a.tile == p_b.tile; };
	_waiting.erase(std::unique(_waiting.begin(), _waiting.end(), is_same), _waiting.end());
	std::ranges::sort(_waiting, {}, &Waiting::band);
	_unmet_seen.take_difference(_tiles->held, _tiles->met);
	return std::max(p_room - std::min(p_room, size_t(_unmet_seen.count())), _wanted.size());
}

// Finds the ways that cameras see, nearest first; within a band in the order of colliders.
void TileMeetings::find_seen_ways() {
	_seen_ways.clear();
	for (Block &block : get_blocks()) {
		for (const Way &way : block.ways) {
			if (way.asleep == 0) {
				continue;
			}
			const int band = _tiles->view.get_band(way.range, TileParams::SEEN_MARGIN);
			_tiles->statistics.ranked++;
			if (band != TileView::UNSEEN) {
				_seen_ways.push_back({ &way, &block, band });
			}
		}
	}
	std::ranges::stable_sort(_seen_ways, {}, &SeenWay::band);
}

void TileMeetings::queue_seen_tiles_of(const SeenWay &p_seen, size_t p_room, size_t p_most_waiting) {
	Block &block = *p_seen.block;
	const int met = keep_met(find_asleep(*p_seen.way, false, block), p_seen.way->swept, block);
	for (int n = 0; n < met; n++) {
		const int x = block.found[size_t(n)].x, z = block.found[size_t(n)].z, tile = _tiles->grid.get_index(x, z);
		if (_place_of_tile.find(tile) != TileMap::NONE) {
			continue;
		}
		const int band = _tiles->view.get_band({ x, x + 1, z, z + 1 }, TileParams::SEEN_MARGIN);
		_tiles->statistics.ranked++;
		if (band == TileView::UNSEEN) {
			continue;
		}
		if (_wanted.size() < p_room) {
			queue(x, z);
		} else if (_waiting.size() < p_most_waiting) {
			_waiting.push_back({ tile, band });
		}
	}
}

// Returns the place in get_wanted().
int TileMeetings::queue(int p_x, int p_z) {
	const int tile = _tiles->grid.get_index(p_x, p_z), place = int(_wanted.size());
	_wanted.push_back(tile);
	_place_of_tile.insert(tile, place);
	_queued.add(p_x / SlotMap::SIDE, p_z / SlotMap::SIDE);
	return place;
}

} // namespace grass
