// SPDX-License-Identifier: MIT
// Reports an error when a project is exported to a platform without a library: the engine would export it all the same, and the game would
// have no grass. Does the same if the extension itself is not packed, and warns if the plots of a world are not.
#pragma once

#include <godot_cpp/classes/editor_export_plugin.hpp>

namespace grass {

class ExportCheck : public godot::EditorExportPlugin {
	GDCLASS(ExportCheck, godot::EditorExportPlugin)

public:
	godot::String _get_name() const override { return "GrassField"; }
	void _export_begin(const godot::PackedStringArray &p_features, bool p_is_debug, const godot::String &p_path, uint32_t p_flags) override;
	void _export_file(const godot::String &p_path, const godot::String &p_type, const godot::PackedStringArray &p_features) override;
	void _export_end() override;

protected:
	static void _bind_methods() {}

private:
	void check_plots();

	// Data of the current export.
	bool _has_extension = false;
	godot::PackedStringArray _scenes, _maps; // paths
};

} // namespace grass
