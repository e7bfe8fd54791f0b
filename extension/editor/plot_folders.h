// SPDX-License-Identifier: MIT
// Where the worlds of a scene read their painted plots: no scene refers to those files.
#pragma once

#include <godot_cpp/variant/packed_string_array.hpp>

namespace grass {

// Returns the folders in res:// that a packed scene sets as `folder` of its worlds.
godot::PackedStringArray find_plot_folders(const godot::String &p_scene);

} // namespace grass
