// SPDX-License-Identifier: MIT
// Decides who may do work that could also wait for the next frame. The first request might use up the time of every frame, so each
// frame reserves one piece of work for the user that has waited longest. Every user gets a turn this way, however busy the others are.
#pragma once

#include <cstdint>
#include <map>

namespace grass {

class FrameTurns {
public:
	void enter_frame(uint64_t p_frame);
	// Returns whether p_user may do a piece of work now. p_has_room: the frame has time for it.
	bool ask(const void *p_user, bool p_has_room);
	// Returns whether another user has waited since an earlier frame, and should get this frame's piece of work.
	bool is_owed(const void *p_user) const;

private:
	// Frames without a request after which a user is forgotten.
	static constexpr uint64_t FORGOTTEN = 3;

	struct Waiting {
		uint64_t since = 0, asked = 0; // the first frame that refused it, and the frame of its last request
		uint64_t order = 0; // position among the users of one frame
	};
	bool is_next(const void *p_user, const Waiting &p_waiting) const;

	std::map<const void *, Waiting> _waiting;
	uint64_t _frame = UINT64_MAX, _asks = 0;
	bool _is_given = false; // whether this frame's piece of work is taken
};

} // namespace grass
