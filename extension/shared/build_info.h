// SPDX-License-Identifier: MIT
// What makes a bug report useful: the build of the extension, and the system on which it ran.
#pragma once

#include <godot_cpp/variant/string.hpp>

namespace grass {

// Returns the version of the extension, as in the file VERSION: "1.2.3".
godot::String get_version();

// Returns the graphics card as the renderer names it; "" if nothing is drawn.
godot::String get_device();

// Returns its driver: name and version if the system reports them, otherwise the version of the graphics API; "" if nothing is drawn. The
// first call may take some milliseconds.
godot::String get_driver();

} // namespace grass
