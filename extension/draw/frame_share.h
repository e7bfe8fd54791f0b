// SPDX-License-Identifier: MIT
// A frame's time for work that could as well run in the next one. All fields share it.
#pragma once

namespace grass {

class FrameShare {
public:
	// Whether this frame has some left. Main thread only.
	static bool has_time();
	// While a world streams, frames give less: true for each world that begins, false for each that ends.
	static void spare(bool p_begins);
};

} // namespace grass
