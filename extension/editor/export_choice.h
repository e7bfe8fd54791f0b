// SPDX-License-Identifier: MIT
// What a preset chooses to export.
#pragma once

#include <godot_cpp/classes/editor_export_preset.hpp>

namespace grass {

class ExportChoice {
public:
	explicit ExportChoice(const godot::Ref<godot::EditorExportPreset> &p_preset) : _preset(p_preset) {}

	// Selected scenes or resources, and what they refer to: the engine leaves out everything else.
	bool is_selection() const;
	// Of a selection. True if the preset itself names a file.
	bool has(const godot::String &p_path) const;
	// True if the preset's filters leave a file out, as its author wants.
	bool excludes(const godot::String &p_path) const;

private:
	godot::Ref<godot::EditorExportPreset> _preset;
};

} // namespace grass
