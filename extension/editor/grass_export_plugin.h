// SPDX-License-Identifier: MIT
// An export of selected scenes leaves out what no scene refers to: the .gdextension, without which the game has no grass, and the plots of
// worlds, without which nothing looks painted. This plugin adds both, and says so. Reports what an export still lacks: the library for its
// platform, the extension, plots.
#pragma once

#include "editor/extension_file.h"

#include <godot_cpp/classes/editor_export_platform.hpp>
#include <godot_cpp/classes/editor_export_plugin.hpp>

namespace grass {

class GrassExportPlugin : public godot::EditorExportPlugin {
	GDCLASS(GrassExportPlugin, godot::EditorExportPlugin)

public:
	godot::String _get_name() const override { return "GrassField"; }
	void _export_begin(const godot::PackedStringArray &p_features, bool p_is_debug, const godot::String &p_path, uint32_t p_flags) override;
	void _export_file(const godot::String &p_path, const godot::String &p_type, const godot::PackedStringArray &p_features) override;
	void _export_end() override;

protected:
	static void _bind_methods() {}

private:
	void check_libraries(const ExtensionFile &p_extension, const godot::PackedStringArray &p_features, bool p_is_debug);
	void add_extension(const ExtensionFile &p_extension, const godot::PackedStringArray &p_features);
	void add_plots(const godot::String &p_scene);
	void check_plots();
	void say(godot::EditorExportPlatform::ExportMessageType p_type, const godot::String &p_text);

	// Data of the current export.
	bool _has_extension = false;
	godot::PackedStringArray _scenes, _plots; // paths
};

} // namespace grass
