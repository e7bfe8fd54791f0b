// SPDX-License-Identifier: MIT
// Says as an error, while a project is exported, that the library is missing for what it is exported to: the engine goes on then, and the
// game would have no grass.
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
