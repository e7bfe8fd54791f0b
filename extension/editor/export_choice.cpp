// SPDX-License-Identifier: MIT
#include "editor/export_choice.h"

#include <godot_cpp/variant/packed_string_array.hpp>

using namespace godot;

namespace grass {

namespace {

// Returns whether a path matches filters as the engine reads them: wildcards between commas, with or without res://.
bool matches(const String &p_path, const String &p_filters) {
	for (const String &part : p_filters.split(",", false)) {
		const String filter = part.strip_edges();
		if (!filter.is_empty() && (p_path.matchn(filter) || p_path.trim_prefix("res://").matchn(filter))) {
			return true;
		}
	}
	return false;
}

} // namespace

bool ExportChoice::is_selection() const {
	if (_preset.is_null()) {
		return false;
	}
	const EditorExportPreset::ExportFilter filter = _preset->get_export_filter();
	return filter == EditorExportPreset::EXPORT_SELECTED_SCENES || filter == EditorExportPreset::EXPORT_SELECTED_RESOURCES;
}

bool ExportChoice::has(const String &p_path) const {
	const bool is_chosen =
			_preset->get_export_filter() == EditorExportPreset::EXPORT_SELECTED_RESOURCES && _preset->get_files_to_export().has(p_path);
	return is_chosen || matches(p_path, _preset->get_include_filter());
}

bool ExportChoice::excludes(const String &p_path) const {
	return _preset.is_valid() && matches(p_path, _preset->get_exclude_filter());
}

} // namespace grass
