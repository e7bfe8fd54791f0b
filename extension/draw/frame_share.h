// SPDX-License-Identifier: MIT
// A frame's time for work that could also run in the next one. All fields share it, and those that wait get a piece in turn
// (core/base/frame_turns.h).
#pragma once

#include <cstdint>

namespace grass {

class FrameShare {
public:
	// The work of one user while this object lives. Only that time counts, not what the engine does between two users. A user must request
	// each piece of work before beginning it. Main thread only.
	class Turn {
	public:
		explicit Turn(const void *p_user); // the user that waits if a request is denied
		Turn(const Turn &) = delete;
		Turn &operator=(const Turn &) = delete;
		~Turn();
		// Returns whether this frame has time left.
		bool has_time();
		// Returns the same for one more part of making a streamed field, and counts it. A frame allows only a few, however short they are.
		bool has_part();

	private:
		const void *_user;
	};

	// Counts bytes that such parts hand to the renderer.
	static void count_bytes(int64_t p_bytes);

	// Reduces the time in each frame while a world streams. Call with true for each world that begins, and false for each that ends.
	static void spare(bool p_begins);
	// The most that any frame has taken since a world began.
	struct Most {
		int64_t parts = 0, bytes = 0;
	};
	static Most get_most();
};

} // namespace grass
