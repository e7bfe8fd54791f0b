// SPDX-License-Identifier: MIT
#include "ground/terrain_share.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/time.hpp>

#include <utility>

using namespace godot;

namespace grass {

namespace {

// Most places read in a frame (plus a row). More: a terrain of scripts takes the frame's whole share. Less: a field of 1 km^2, a million
// places, takes longer to read.
constexpr int64_t QUERIES_A_FRAME = 16384;
// Places read in a frame even without time left, so that reading always finishes: two rows, or as many as fit in LEAST_TIME (microseconds)
// if a terrain is slow, and always at least one.
constexpr int64_t PLACES_AT_LEAST = 132;
constexpr uint64_t LEAST_TIME = 500;

uint64_t now() {
	return Time::get_singleton()->get_ticks_usec();
}

// Returns whether this field is the first of all in a frame: only that one has a guaranteed number of places.
bool is_first_in(uint64_t p_frame) {
	static uint64_t frame_of_first = UINT64_MAX;
	return std::exchange(frame_of_first, p_frame) != p_frame;
}

} // namespace

TerrainShare::Turn::Turn(TerrainShare &r_share) :
		_share(r_share),
		_turn(&r_share),
		_is_first(is_first_in(Engine::get_singleton()->get_process_frames())),
		_queries_before(r_share._queries),
		_since(now()) {
	const uint64_t frame = Engine::get_singleton()->get_process_frames();
	if (std::exchange(r_share._frame, frame) != frame) { // a field may have several turns in a frame
		r_share._last_query = r_share._queries + QUERIES_A_FRAME;
	}
}

bool TerrainShare::Turn::may_go_on() {
	if (_share._queries >= _share._last_query) {
		return false;
	}
	const int64_t read = _share._queries - _queries_before;
	return (_is_first && (read == 0 || (read < PLACES_AT_LEAST && now() - _since < LEAST_TIME))) || _turn.has_time();
}

} // namespace grass
