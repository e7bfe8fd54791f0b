// SPDX-License-Identifier: MIT
#include "draw/frame_share.h"

#include "core/base/frame_turns.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/time.hpp>

#include <algorithm>

namespace grass {

namespace {

// No work begins after a frame's turns have taken this long. More: frames stutter. Less: changes take longer to show.
constexpr uint64_t SHARE = 4000; // microseconds
// The same while a world streams, which brings work in most frames: with the last piece the total stays below a millisecond.
constexpr uint64_t SHARE_OF_WORLDS = 500; // microseconds
// Most parts of streamed fields in a frame. More: only the clock bounds a frame's work. Fewer: plots take longer to appear.
constexpr int64_t PARTS = 4;

int worlds = 0;

// The current frame of the process, and what was done in it.
struct {
	uint64_t frame = UINT64_MAX;
	uint64_t taken = 0; // microseconds, of finished turns
	FrameShare::Most done;
} so_far;

// Turns within turns add no time of their own.
int open_turns = 0;
uint64_t open_since = 0; // microseconds

FrameTurns turns;
FrameShare::Most most;

uint64_t now() {
	return godot::Time::get_singleton()->get_ticks_usec();
}

void enter_frame() {
	if (const uint64_t this_frame = godot::Engine::get_singleton()->get_process_frames(); so_far.frame != this_frame) {
		so_far = { this_frame, 0, {} };
		turns.enter_frame(this_frame);
	}
}

bool is_time_left() {
	return so_far.taken + (now() - open_since) < (worlds > 0 ? SHARE_OF_WORLDS : SHARE);
}

} // namespace

FrameShare::Turn::Turn(const void *p_user) : _user(p_user) {
	enter_frame();
	if (open_turns++ == 0) {
		open_since = now();
	}
}

FrameShare::Turn::~Turn() {
	if (--open_turns == 0) {
		so_far.taken += now() - open_since;
	}
}

bool FrameShare::Turn::has_time() {
	return turns.ask(_user, is_time_left());
}

bool FrameShare::Turn::has_part() {
	const int64_t room = PARTS - (turns.is_owed(_user) ? 1 : 0);
	if (!turns.ask(_user, so_far.done.parts < room && is_time_left())) {
		return false;
	}
	so_far.done.parts++;
	most.parts = std::max(most.parts, so_far.done.parts);
	return true;
}

void FrameShare::count_bytes(int64_t p_bytes) {
	enter_frame();
	so_far.done.bytes += p_bytes;
	most.bytes = std::max(most.bytes, so_far.done.bytes);
}

void FrameShare::spare(bool p_begins) {
	worlds += p_begins ? 1 : -1;
	most = p_begins && worlds == 1 ? Most() : most;
}

FrameShare::Most FrameShare::get_most() {
	return most;
}

} // namespace grass
