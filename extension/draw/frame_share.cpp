// SPDX-License-Identifier: MIT
#include "draw/frame_share.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/time.hpp>

#include <algorithm>

namespace grass {

namespace {

// No work begins later than this after a frame's first piece of work. More: frames stutter. Less: changes take longer to show.
constexpr uint64_t SHARE = 4000; // microseconds
// The same while a world streams, in which there is work in most frames: with the last piece it is below a millisecond.
constexpr uint64_t SHARE_OF_WORLDS = 500; // microseconds
// Parts of streamed fields in a frame, at most. More: what a frame does is bounded by the clock alone. Fewer: plots take longer to come.
constexpr int64_t PARTS = 4;

int worlds = 0;

// The frame of the process, when its first work began, and what was done in it.
struct {
	uint64_t frame = UINT64_MAX;
	uint64_t begin = 0; // microseconds
	FrameShare::Most done;
} current;

FrameShare::Most most;

void enter_frame(uint64_t p_now) {
	if (const uint64_t this_frame = godot::Engine::get_singleton()->get_process_frames(); current.frame != this_frame) {
		current = { this_frame, p_now, {} };
	}
}

} // namespace

bool FrameShare::has_time() {
	const uint64_t now = godot::Time::get_singleton()->get_ticks_usec();
	enter_frame(now);
	return now - current.begin < (worlds > 0 ? SHARE_OF_WORLDS : SHARE);
}

bool FrameShare::has_part() {
	if (!has_time() || current.done.parts >= PARTS) {
		return false;
	}
	current.done.parts++;
	most.parts = std::max(most.parts, current.done.parts);
	return true;
}

void FrameShare::count_bytes(int64_t p_bytes) {
	enter_frame(godot::Time::get_singleton()->get_ticks_usec());
	current.done.bytes += p_bytes;
	most.bytes = std::max(most.bytes, current.done.bytes);
}

void FrameShare::spare(bool p_begins) {
	worlds += p_begins ? 1 : -1;
	most = p_begins && worlds == 1 ? Most() : most;
}

FrameShare::Most FrameShare::get_most() {
	return most;
}

} // namespace grass
