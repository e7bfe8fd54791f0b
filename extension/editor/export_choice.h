// SPDX-License-Identifier: MIT
// What a preset chooses to export.
#pragma once

#include <godot_cpp/classes/editor_export_preset.hpp>

namespace grass {

class ExportChoice {
public:
	explicit ExportChoice(const godot::Ref<godot::EditorExportPreset> &p_preset) : _preset(p_preset) {}

	// Returns whether it is a selection of scenes or resources, with what they refer to: the engine leaves out everything else.
	bool is_selection() const;
	// Returns whether the preset of a selection names a file itself.
	bool has(const godot::String &p_path) const;
	// Returns whether the preset's filters leave a file out, as its author wants.
	bool excludes(const godot::String &p_path) const;

private:
	godot::Ref<godot::EditorExportPreset> _preset;
};

} // namespace grass
