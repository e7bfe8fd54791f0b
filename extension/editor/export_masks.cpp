// SPDX-License-Identifier: MIT
#include "editor/export_masks.h"

#include "resources/grass_fill_rule.h"

#include <godot_cpp/classes/editor_export_preset.hpp>
#include <godot_cpp/classes/editor_file_system.hpp>
#include <godot_cpp/classes/editor_file_system_directory.hpp>
#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/file_access.hpp>

using namespace godot;

namespace grass {

namespace {

void add_files(EditorFileSystemDirectory *p_folder, PackedStringArray &r_files) {
	for (int file = 0; file < p_folder->get_file_count(); file++) {
		const String path = p_folder->get_file_path(file);
		r_files.push_back(vformat("%s:%d", path, int64_t(FileAccess::get_modified_time(path))));
	}
	for (int folder = 0; folder < p_folder->get_subdir_count(); folder++) {
		add_files(p_folder->get_subdir(folder), r_files);
	}
}

} // namespace

// Does not use the feature "dedicated_server", since plugins are called before the engine adds it (Godot 4.6).
bool ExportMasks::_begin_customize_resources(const Ref<EditorExportPlatform> &, const PackedStringArray &) const {
	const Ref<EditorExportPreset> preset = get_export_preset();
	return preset.is_valid() && preset->get_export_filter() == EditorExportPreset::EXPORT_CUSTOMIZED &&
			preset->get_customized_files().values().has("strip");
}

// Returns a rule that keeps its mask, or null to keep the resource as it is. p_path: the file if the resource is a file's main resource,
// otherwise empty.
Ref<Resource> ExportMasks::_customize_resource(const Ref<Resource> &p_resource, const String &p_path) {
	const GrassFillRule *rule = Object::cast_to<GrassFillRule>(p_resource.ptr());
	if (rule == nullptr || rule->get_kept_mask().is_valid() || rule->get_mask_state() == GrassFillRule::MASK_STATE_NONE) {
		return {};
	}
	if (p_path.is_empty() && !rule->is_built_in()) {
		return {}; // its own file keeps the mask
	}
	if (!_kept.has(p_resource)) {
		const Ref<GrassFillRule> kept = rule->with_kept_mask();
		_kept[p_resource] = kept;
		if (kept.is_null()) {
			get_export_platform()->add_message(EditorExportPlatform::EXPORT_MESSAGE_WARNING, "GrassField",
					vformat("The mask of the GrassFillRule '%s' has no picture while the export runs (%s), and the export strips it: on "
							"the server nothing grows by this rule. Save the picture as a file and use that.",
							p_path.is_empty() ? rule->get_path() : p_path, rule->get_mask()->get_class()));
		}
	}
	return _kept[p_resource];
}

// The engine caches customized resources until their own file or this number changes. A mask's picture comes from other files.
uint64_t ExportMasks::_get_customization_configuration_hash() const {
	PackedStringArray files;
	add_files(EditorInterface::get_singleton()->get_resource_filesystem()->get_filesystem(), files);
	return uint64_t(String("|").join(files).hash());
}

} // namespace grass
