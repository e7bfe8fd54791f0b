// SPDX-License-Identifier: MIT
// What makes a bug report useful: which build of the extension ran, and on what.
#pragma once

#include <godot_cpp/variant/string.hpp>

namespace grass {

// Of the extension, as in the file VERSION: "1.2.3".
godot::String get_version();

// The graphics card as the renderer names it; "" where nothing is drawn.
godot::String get_device();

// Its driver: name and version where the system reports them, else the version of the graphics interface; "" where nothing is drawn. The
// first call may take some milliseconds.
godot::String get_driver();

} // namespace grass
