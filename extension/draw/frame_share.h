// SPDX-License-Identifier: MIT
// A frame's time for work that could as well run in the next one. All fields share it.
#pragma once

#include <cstdint>

namespace grass {

class FrameShare {
public:
	// Whether this frame has some left. Main thread only.
	static bool has_time();
	// The same for one more part of a streamed field's making: a few a frame, however short they are. Counts it.
	static bool has_part();
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
