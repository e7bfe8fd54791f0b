// SPDX-License-Identifier: MIT
// "Fill Now" as a step of the editor's history.
#pragma once

namespace grass {

// Lets nodes reach the editor while the plugin runs, see shared/editor_hooks.h.
void set_editor_hooks();
void clear_editor_hooks();

} // namespace grass
