// SPDX-License-Identifier: MIT
// Time that a frame has for work which may as well be done in the next one. All fields share it.
#pragma once

namespace grass {

class FrameShare {
public:
	// Whether there is some left in this frame. Main thread only.
	static bool has_time();
};

} // namespace grass
