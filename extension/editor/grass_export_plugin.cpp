// SPDX-License-Identifier: MIT
#include "editor/grass_export_plugin.h"

#include "editor/export_choice.h"
#include "editor/plot_folders.h"
#include "world/world_files.h"

#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/gd_extension_manager.hpp>
#include <godot_cpp/classes/project_settings.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr const char *SYSTEMS[] = { "linux", "windows", "macos", "android", "ios", "web" };

String system_of(const PackedStringArray &p_features) {
	for (const char *system : SYSTEMS) {
		if (p_features.has(system)) {
			return system;
		}
	}
	return "unknown";
}

bool is_there(const String &p_library) {
	return !p_library.is_empty() &&
			(FileAccess::file_exists(p_library) || DirAccess::dir_exists_absolute(p_library)); // frameworks are folders
}

// Returns the file in which the engine looks up what to load when a game starts.
String list_path() {
	const bool is_hidden = ProjectSettings::get_singleton()->get_setting("application/config/use_hidden_project_data_directory", true);
	return is_hidden ? "res://.godot/extension_list.cfg" : "res://godot/extension_list.cfg";
}

// Returns whether the export has an extension: then the engine writes the list itself, and its own replaces ours.
bool packs_an_extension(const ExportChoice &p_choice) {
	for (const String &path : GDExtensionManager::get_singleton()->get_loaded_extensions()) {
		if (p_choice.has(path) && !p_choice.excludes(path)) {
			return true;
		}
	}
	return false;
}

} // namespace

void GrassExportPlugin::say(EditorExportPlatform::ExportMessageType p_type, const String &p_text) {
	get_export_platform()->add_message(p_type, "GrassField", p_text);
}

void GrassExportPlugin::_export_begin(const PackedStringArray &p_features, bool p_is_debug, const String &p_path, uint32_t p_flags) {
	(void)p_path; // the path does not matter
	(void)p_flags;
	_has_extension = false;
	_scenes.clear();
	_plots.clear();
	ExtensionFile extension;
	if (extension.load()) { // otherwise the engine has reported that already
		check_libraries(extension, p_features, p_is_debug);
		add_extension(extension, p_features);
	}
}

void GrassExportPlugin::check_libraries(const ExtensionFile &p_extension, const PackedStringArray &p_features, bool p_is_debug) {
	const String system = system_of(p_features), target = p_is_debug ? "debug" : "release";
	const auto find = [&](const String &p_architecture) { return p_extension.find_library(p_features, p_architecture).path; };
	for (const String &architecture : ExtensionFile::find_architectures(p_features)) {
		const String library = find(architecture);
		if (is_there(library) || (architecture == UNIVERSAL && is_there(find("x86_64")) && is_there(find("arm64")))) {
			continue;
		}
		const String missing = library.is_empty() ? vformat("%s names no library for", ExtensionFile::NAME)
												  : vformat("%s is missing, the library for", library);
		const String wanted = (architecture.is_empty() ? String() : vformat(" arch=%s", architecture)) +
				(p_features.has("double") ? " precision=double" : "");
		say(EditorExportPlatform::EXPORT_MESSAGE_ERROR,
				vformat("%s %s %s (%s): the exported game will have no grass. Build it (./grass build platform=%s%s target=%s), or take "
						"it from the add-on's release zip.",
						missing, system, architecture, target, system, wanted, target));
	}
}

void GrassExportPlugin::add_extension(const ExtensionFile &p_extension, const PackedStringArray &p_features) {
	const ExportChoice choice(get_export_preset());
	const String &path = p_extension.get_path();
	if (!choice.is_selection() || choice.excludes(path) || packs_an_extension(choice)) {
		return;
	}
	add_file(path, FileAccess::get_file_as_bytes(path), false);
	add_file(list_path(), (path + String("\n")).to_utf8_buffer(), false);
	PackedStringArray added;
	for (const String &architecture : ExtensionFile::find_architectures(p_features)) {
		const NamedLibrary library = p_extension.find_library(p_features, architecture);
		if (is_there(library.path) && !added.has(library.path)) {
			add_shared_object(library.path, library.tags, String());
			added.push_back(library.path);
		}
	}
	_has_extension = true;
	const String with = added.is_empty() ? String() : vformat(" and %s", String(" and ").join(added));
	say(EditorExportPlatform::EXPORT_MESSAGE_INFO, vformat("Added %s%s, since no scene refers to the add-on's library.", path, with));
}

void GrassExportPlugin::_export_file(const String &p_path, const String &p_type, const PackedStringArray &) {
	_has_extension = _has_extension || p_path.get_file() == ExtensionFile::NAME;
	if (p_type == "PackedScene") {
		_scenes.push_back(p_path);
		add_plots(p_path);
	} else if (p_path.get_extension() == "grassmap") {
		_plots.push_back(p_path);
	}
}

void GrassExportPlugin::add_plots(const String &p_scene) {
	const ExportChoice choice(get_export_preset());
	if (!choice.is_selection()) {
		return;
	}
	for (const String &folder : find_plot_folders(p_scene)) {
		int64_t added = 0;
		for (const String &plot : WorldFiles::find_plots(folder)) {
			if (_plots.has(plot) || choice.has(plot) || choice.excludes(plot)) {
				continue;
			}
			if (const PackedByteArray data = FileAccess::get_file_as_bytes(plot); !data.is_empty()) {
				add_file(plot, data, false);
				_plots.push_back(plot);
				added++;
			}
		}
		if (added > 0) {
			say(EditorExportPlatform::EXPORT_MESSAGE_INFO,
					vformat("Added %d painted plots in '%s', the `folder` of a GrassWorld in %s.", added, folder, p_scene));
		}
	}
}

// Reports what the game will lack.
void GrassExportPlugin::_export_end() {
	if (ExtensionFile extension; !_has_extension && extension.load()) {
		say(EditorExportPlatform::EXPORT_MESSAGE_ERROR,
				vformat("%s is not exported, so the game will have no grass. Add '*.gdextension' to the export filters for non-resource "
						"files (Resources tab) and take it out of the filters that exclude files, or export all resources.",
						ExtensionFile::NAME));
	}
	check_plots();
}

void GrassExportPlugin::check_plots() {
	for (const String &scene : _scenes) {
		for (const String &folder : find_plot_folders(scene)) {
			int64_t missing = 0;
			for (const String &plot : WorldFiles::find_plots(folder)) {
				missing += _plots.has(plot) ? 0 : 1;
			}
			if (missing > 0) {
				say(EditorExportPlatform::EXPORT_MESSAGE_WARNING,
						vformat("%d plots in '%s', the `folder` of a GrassWorld in %s, are not exported, so the game's grass will look as "
								"if nothing had been painted there. Add '%s' to the export filters for non-resource files (Resources tab), "
								"or export all resources.",
								missing, folder, scene, folder.trim_prefix("res://").path_join("*.grassmap")));
			}
		}
	}
}

} // namespace grass
