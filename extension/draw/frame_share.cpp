// SPDX-License-Identifier: MIT
#include "draw/frame_share.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/time.hpp>

namespace grass {

namespace {

// No work begins later than this after a frame's first piece of work. More: frames stutter. Less: changes take longer to show.
constexpr uint64_t SHARE = 4000; // microseconds
// The same while a world streams, in which there is work in most frames: with the last piece it is below a millisecond.
constexpr uint64_t SHARE_OF_WORLDS = 500; // microseconds

int worlds = 0;

// The frame of the process, and when its first work began.
struct {
	uint64_t frame = UINT64_MAX;
	uint64_t begin = 0; // microseconds
} current;

} // namespace

bool FrameShare::has_time() {
	const uint64_t now = godot::Time::get_singleton()->get_ticks_usec();
	if (const uint64_t this_frame = godot::Engine::get_singleton()->get_process_frames(); current.frame != this_frame) {
		current = { this_frame, now };
	}
	return now - current.begin < (worlds > 0 ? SHARE_OF_WORLDS : SHARE);
}

void FrameShare::spare(bool p_begins) {
	worlds += p_begins ? 1 : -1;
}

} // namespace grass
