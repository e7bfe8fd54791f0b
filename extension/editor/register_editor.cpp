// SPDX-License-Identifier: MIT
#include "editor/register_editor.h"

#include "editor/grass_editor_plugin.h"
#include "editor/kept_plots_dialog.h"
#include "editor/limit_slider.h"
#include "editor/limits_button.h"
#include "editor/own_map_dialog.h"
#include "editor/species_preview.h"

#include "class_docs.gen.h"

#include <gdextension_interface.h>
#include <godot_cpp/classes/editor_plugin_registration.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace grass {

void register_editor() {
	GDREGISTER_INTERNAL_CLASS(LimitSlider);
	GDREGISTER_INTERNAL_CLASS(LimitsButton);
	GDREGISTER_INTERNAL_CLASS(BrushMenu);
	GDREGISTER_INTERNAL_CLASS(SpeciesPalette);
	GDREGISTER_INTERNAL_CLASS(BrushToolbar);
	GDREGISTER_INTERNAL_CLASS(ViewDrop);
	GDREGISTER_INTERNAL_CLASS(GrassExportPlugin);
	GDREGISTER_INTERNAL_CLASS(ExportMasks);
	GDREGISTER_INTERNAL_CLASS(KeptPlotsDialog);
	GDREGISTER_INTERNAL_CLASS(OwnMapDialog);
	GDREGISTER_INTERNAL_CLASS(SpeciesPreview);
	GDREGISTER_INTERNAL_CLASS(SizeHandles);
	GDREGISTER_INTERNAL_CLASS(GrassEditorPlugin);
	EditorPlugins::add_by_type<GrassEditorPlugin>();
	for (const std::string_view &text : CLASS_DOCS) {
		gdextension_interface::editor_help_load_xml_from_utf8_chars_and_len(text.data(), int64_t(text.size()));
	}
}

} // namespace grass
