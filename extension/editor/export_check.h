// SPDX-License-Identifier: MIT
// Reports an error when a project is exported to a platform that the library is missing for: the engine would export it all the same, and
// the game would have no grass.
#pragma once

#include <godot_cpp/classes/editor_export_plugin.hpp>

namespace grass {

class ExportCheck : public godot::EditorExportPlugin {
	GDCLASS(ExportCheck, godot::EditorExportPlugin)

public:
	godot::String _get_name() const override { return "GrassField"; }
	void _export_begin(const godot::PackedStringArray &p_features, bool p_is_debug, const godot::String &p_path, uint32_t p_flags) override;

protected:
	static void _bind_methods() {}
};

} // namespace grass
