// SPDX-License-Identifier: MIT
// "Fill Now" as a step of the editor's undo history.
#pragma once

namespace grass {

// Let nodes use the editor while the plugin runs, see shared/editor_hooks.h.
void set_editor_hooks();
void clear_editor_hooks();

} // namespace grass
