// SPDX-License-Identifier: MIT
// Decides how many slots exist: as many as awake tiles need, in powers of two. A device takes milliseconds to make many, so they are
// prepared beside the frames, and tiles wait meanwhile.
#pragma once

#include "core/tiles/tile_params.h"

namespace grass {

class RoomPlan {
public:
	static constexpr int KEEP = -1; // no other number of slots

	// Sets up to how many slots can be made when they are needed, and how many more are prepared now, 0: none. Must be called before each
	// step.
	void set_ready(int p_at_once, int p_prepared);
	// Returns how many slots should be prepared, 0: none.
	int get_wanted() const { return _wanted > 0 ? _wanted : _trimmed; }
	// Must be called when the number of slots has changed: what was prepared is used.
	void made() { _prepared = 0; }
	void reset() { *this = {}; }

	// Returns the number of slots to which p_room of them shrink after p_delta seconds in which tiles need p_used, or KEEP.
	int find_trimmed(int p_used, int p_room, double p_delta);
	// Returns how many slots there can be in this step if tiles need p_needed and p_room exist. p_most: slots of a pool.
	int find_possible(int p_needed, int p_room, int p_most) const;
	// Does the same, and notes what should be prepared.
	int find_next(int p_needed, int p_room, int p_most);

private:
	int _at_once = TileParams::MAX_POOL_SIZE, _prepared = 0; // slots
	int _wanted = 0, _trimmed = 0; // slots that should be prepared: more than exist, or fewer; 0: none
	double _slack_time = 0.0; // seconds for which far more slots have existed than were needed
};

} // namespace grass
