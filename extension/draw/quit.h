// SPDX-License-Identifier: MIT
// Lets a game end while the renderer's pipelines are still being made.
#pragma once

#include <godot_cpp/classes/node.hpp>

namespace grass {

// Must be called when a field enters the tree with this root.
void watch_for_quit(godot::Node *p_root);

} // namespace grass
