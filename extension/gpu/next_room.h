// SPDX-License-Identifier: MIT
// Makes the memory of slots on a thread, beside the frames, before a field needs it. Main thread only.
#pragma once

#include "gpu/pool_room.h"

#include <future>
#include <memory>

namespace grass {

class NextRoom {
public:
	~NextRoom() { drop(); }

	// Begins to make memory for p_slots slots; 0: none. Must be called in each tick. Returns true once exactly that many are ready.
	bool prepare(int p_slots, const PoolRoom::Kind &p_kind);
	// Returns the memory for p_slots slots, or null if it is not ready.
	std::shared_ptr<PoolRoom> take(int p_slots);
	// Frees what is ready, and what is being made, on the render thread.
	void drop();

private:
	std::future<std::shared_ptr<PoolRoom>> _to_come;
	std::shared_ptr<PoolRoom> _room;
};

} // namespace grass
