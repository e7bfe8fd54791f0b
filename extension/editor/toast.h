// SPDX-License-Identifier: MIT
// A message in the editor's corner.
#pragma once

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_toaster.hpp>

namespace grass {

inline void toast(const godot::String &p_text, godot::EditorToaster::Severity p_severity = godot::EditorToaster::SEVERITY_WARNING) {
	godot::EditorInterface::get_singleton()->get_editor_toaster()->push_toast(p_text, p_severity);
}

} // namespace grass
