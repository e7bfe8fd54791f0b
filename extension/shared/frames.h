// SPDX-License-Identifier: MIT
// Whether the engine renders anything.
#pragma once

#include <godot_cpp/classes/display_server.hpp>

namespace grass {

// Returns false in an engine that runs headless: it has no renderer.
inline bool draws_frames() {
	return godot::DisplayServer::get_singleton()->get_name() != "headless";
}

} // namespace grass
