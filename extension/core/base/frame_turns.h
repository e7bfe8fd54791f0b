// SPDX-License-Identifier: MIT
// Who may do work that could as well wait for the next frame. Whoever asks first may use up a frame's time; so one piece of work in each
// frame belongs to whoever has waited longest, and all of those who wait get their turn, however busy the others are.
#pragma once

#include <cstdint>
#include <map>

namespace grass {

class FrameTurns {
public:
	void enter_frame(uint64_t p_frame);
	// Whether p_user may do a piece of work now. p_has_room: the frame has time for it.
	bool ask(const void *p_user, bool p_has_room);
	// Whether somebody else has waited since an earlier frame, and is to have this one's piece.
	bool is_owed(const void *p_user) const;

private:
	// Frames without a request after which a user is forgotten.
	static constexpr uint64_t FORGOTTEN = 3;

	struct Waiting {
		uint64_t since = 0, asked = 0; // frames: the first one in vain, and the last one
		uint64_t order = 0; // among those of one frame
	};
	bool is_next(const void *p_user, const Waiting &p_waiting) const;

	std::map<const void *, Waiting> _waiting;
	uint64_t _frame = UINT64_MAX, _asks = 0;
	bool _is_given = false; // this frame's piece
};

} // namespace grass
