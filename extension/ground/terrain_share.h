// SPDX-License-Identifier: MIT
// Limits how much of its terrain a field reads in a frame: by time, which all fields share, and by places.
#pragma once

#include "draw/frame_share.h"

#include <cstdint>

namespace grass {

class TerrainShare {
public:
	// A field's reading in one frame. Its time runs while this object lives.
	class Turn {
	public:
		explicit Turn(TerrainShare &r_share);
		// Returns whether one more place may be read.
		bool may_go_on();

	private:
		const TerrainShare &_share;
		FrameShare::Turn _turn;
		const bool _is_first; // of all fields, in this frame
		const int64_t _queries_before;
		const uint64_t _since; // microseconds
	};

	void count(int64_t p_places) { _queries += p_places; }
	int64_t get_queries() const { return _queries; } // places so far

private:
	int64_t _queries = 0;
	uint64_t _frame = UINT64_MAX; // of the process, in which the field last had a turn
	int64_t _last_query = 0; // allowed in that frame
};

} // namespace grass
