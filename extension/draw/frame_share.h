// SPDX-License-Identifier: MIT
// A frame's time for work that could as well run in the next one. All fields share it, and each of those that wait gets a piece in turn
// (core/base/frame_turns.h).
#pragma once

#include <cstdint>

namespace grass {

class FrameShare {
public:
	// The work of one user, as long as this object lives: only that time counts, not what the engine does between two users. A user asks
	// before each piece of work. Main thread only.
	class Turn {
	public:
		explicit Turn(const void *p_user); // who waits where a question is denied
		Turn(const Turn &) = delete;
		Turn &operator=(const Turn &) = delete;
		~Turn();
		// Whether this frame has some left.
		bool has_time();
		// The same for one more part of a streamed field's making: a few a frame, however short they are. Counts it.
		bool has_part();

	private:
		const void *_user;
	};

	// Bytes that such parts hand to the renderer.
	static void count_bytes(int64_t p_bytes);

	// While a world streams, frames give less: true for each world that begins, false for each that ends.
	static void spare(bool p_begins);
	// In one frame, at most, since a world began.
	struct Most {
		int64_t parts = 0, bytes = 0;
	};
	static Most get_most();
};

} // namespace grass
