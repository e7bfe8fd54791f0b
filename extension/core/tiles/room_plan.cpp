// SPDX-License-Identifier: MIT
#include "core/tiles/room_plan.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace grass {

namespace {

// The first slots that a tile makes room for; then their number doubles. More: each field that a single body visits takes more memory.
// Fewer: more often all of them are copied.
constexpr int FIRST_ROOM = 16;
// Slots are freed once so many times as many exist as the awake tiles need, for so many seconds; room for twice the tiles is kept. Less:
// memory comes and goes with every body that passes.
constexpr int MUCH = 4;
constexpr double TRIM_AFTER = 3.0;

// Returns the room for a number of awake tiles.
int room_for(int p_tiles) {
	return p_tiles > 0 ? std::max(FIRST_ROOM, int(std::bit_ceil(unsigned(p_tiles)))) : 0;
}

} // namespace

void RoomPlan::set_ready(int p_at_once, int p_prepared) {
	_at_once = p_at_once;
	_prepared = p_prepared;
}

int RoomPlan::find_trimmed(int p_used, int p_room, double p_delta) {
	const int needed = room_for(p_used);
	_slack_time = p_room > 0 && needed * MUCH <= p_room ? _slack_time + std::max(p_delta, 0.0) : 0.0;
	_trimmed = _slack_time >= TRIM_AFTER ? 2 * needed : 0;
	if (_slack_time < TRIM_AFTER || (_trimmed > _at_once && _trimmed != _prepared)) {
		return KEEP;
	}
	_slack_time = 0.0;
	return std::exchange(_trimmed, 0);
}

int RoomPlan::find_possible(int p_needed, int p_room, int p_most) const {
	const int wanted = std::min(room_for(p_needed), p_most);
	if (p_needed <= p_room) {
		return p_room;
	}
	return wanted <= _at_once ? wanted : std::max(std::min(std::max(_at_once, _prepared), p_most), p_room);
}

int RoomPlan::find_next(int p_needed, int p_room, int p_most) {
	const int next = find_possible(p_needed, p_room, p_most);
	if (p_needed <= next) {
		_wanted = 0;
	} else if (_wanted <= next) { // else what was begun goes on
		_wanted = std::min(room_for(p_needed), p_most);
	}
	return next;
}

} // namespace grass
