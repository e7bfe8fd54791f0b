// SPDX-License-Identifier: MIT
#include "editor/export_check.h"

#include <godot_cpp/classes/config_file.hpp>
#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/editor_export_platform.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/gd_extension_manager.hpp>
#include <godot_cpp/classes/packed_scene.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/scene_state.hpp>

#include <vector>

using namespace godot;

namespace grass {

namespace {

constexpr char EXTENSION[] = "grass_field.gdextension";
constexpr const char *ARCHITECTURES[] = { "x86_32", "x86_64", "arm32", "arm64", "rv64", "ppc64", "loongarch64", "wasm32" };
constexpr const char *SYSTEMS[] = { "linux", "windows", "macos", "android", "ios", "web" };
constexpr char UNIVERSAL[] = "universal"; // on macOS: for both of its processors

String find_extension() {
	for (const String &path : GDExtensionManager::get_singleton()->get_loaded_extensions()) {
		if (path.get_file() == EXTENSION) {
			return path;
		}
	}
	return String();
}

bool is_architecture(const String &p_feature) {
	for (const char *architecture : ARCHITECTURES) {
		if (p_feature == architecture) {
			return true;
		}
	}
	return p_feature == UNIVERSAL;
}

String system_of(const PackedStringArray &p_features) {
	for (const char *system : SYSTEMS) {
		if (p_features.has(system)) {
			return system;
		}
	}
	return "unknown";
}

// Returns the architectures for which an export may need a library, or "" if it names none.
PackedStringArray architectures_of(const PackedStringArray &p_features) {
	PackedStringArray architectures;
	for (const String &feature : p_features) {
		if (is_architecture(feature)) {
			architectures.push_back(feature);
		}
	}
	if (architectures.is_empty()) {
		architectures.push_back(String());
	}
	return architectures;
}

// Chooses as the engine does: among the libraries whose tags are all features of the export, the one with the most tags. "": none.
String find_library(
		const ConfigFile &p_extension, const String &p_folder, const PackedStringArray &p_features, const String &p_architecture) {
	String found;
	int64_t most = 0;
	for (const String &key : p_extension.get_section_keys("libraries")) {
		const PackedStringArray tags = key.split(".");
		bool fits = tags.size() > most;
		for (const String &tag : tags) {
			fits = fits && (is_architecture(tag) ? tag == p_architecture : p_features.has(tag));
		}
		if (fits) {
			const String path = p_extension.get_value("libraries", key);
			found = path.is_absolute_path() ? path : p_folder.path_join(path);
			most = tags.size();
		}
	}
	return found;
}

// Returns the folders of the worlds in a packed scene.
PackedStringArray find_folders(const String &p_scene) {
	PackedStringArray folders;
	if (p_scene.get_extension() == "tscn" && !FileAccess::get_file_as_string(p_scene).contains("GrassWorld")) {
		return folders; // loading it would load everything that it uses
	}
	const Ref<PackedScene> scene = ResourceLoader::get_singleton()->load(p_scene, "PackedScene");
	const Ref<SceneState> state = scene.is_valid() ? scene->get_state() : Ref<SceneState>();
	for (int32_t node = 0; state.is_valid() && node < state->get_node_count(); node++) {
		for (int32_t i = 0; state->get_node_type(node) == StringName("GrassWorld") && i < state->get_node_property_count(node); i++) {
			if (state->get_node_property_name(node, i) == StringName("folder")) {
				folders.push_back(state->get_node_property_value(node, i));
			}
		}
	}
	return folders;
}

bool is_there(const String &p_library) {
	return !p_library.is_empty() &&
			(FileAccess::file_exists(p_library) || DirAccess::dir_exists_absolute(p_library)); // frameworks are folders
}

} // namespace

void ExportCheck::_export_begin(const PackedStringArray &p_features, bool p_is_debug, const String &p_path, uint32_t p_flags) {
	(void)p_path; // the path does not matter
	(void)p_flags;
	_has_extension = false;
	_scenes.clear();
	_maps.clear();
	const String path = find_extension();
	Ref<ConfigFile> extension;
	extension.instantiate();
	if (path.is_empty() || extension->load(path) != OK) {
		return; // the engine has reported that already
	}
	const String system = system_of(p_features), target = p_is_debug ? "debug" : "release";
	const auto find = [&](const String &p_architecture) {
		return find_library(**extension, path.get_base_dir(), p_features, p_architecture);
	};
	for (const String &architecture : architectures_of(p_features)) {
		const String library = find(architecture);
		if (is_there(library) || (architecture == UNIVERSAL && is_there(find("x86_64")) && is_there(find("arm64")))) {
			continue;
		}
		const String missing =
				library.is_empty() ? vformat("%s names no library for", EXTENSION) : vformat("%s is missing, the library for", library);
		const String wanted = architecture.is_empty() ? String() : vformat(" arch=%s", architecture);
		get_export_platform()->add_message(EditorExportPlatform::EXPORT_MESSAGE_ERROR, "GrassField",
				vformat("%s %s %s (%s): the exported game will have no grass. Build it (./grass build platform=%s%s target=%s), or take "
						"it from the add-on's release zip.",
						missing, system, architecture, target, system, wanted, target));
	}
}

void ExportCheck::_export_file(const String &p_path, const String &p_type, const PackedStringArray &p_features) {
	(void)p_features;
	_has_extension = _has_extension || p_path.get_file() == EXTENSION;
	if (p_type == "PackedScene") {
		_scenes.push_back(p_path);
	} else if (p_path.get_extension() == "grassmap") {
		_maps.push_back(p_path);
	}
}

// Reports files that an export of selected scenes leaves out, since no scene refers to them.
void ExportCheck::_export_end() {
	if (!_has_extension && !find_extension().is_empty()) {
		get_export_platform()->add_message(EditorExportPlatform::EXPORT_MESSAGE_ERROR, "GrassField",
				vformat("%s is not exported, so the game will have no grass. Add '*.gdextension' to the export filters for non-resource "
						"files (Resources tab), or export all resources.",
						EXTENSION));
	}
	check_plots();
}

void ExportCheck::check_plots() {
	for (const String &scene : _scenes) {
		for (const String &folder : find_folders(scene)) {
			int64_t missing = 0;
			for (const String &file : DirAccess::get_files_at(folder)) {
				missing += file.get_extension() == "grassmap" && !_maps.has(folder.path_join(file)) ? 1 : 0;
			}
			if (missing > 0) {
				get_export_platform()->add_message(EditorExportPlatform::EXPORT_MESSAGE_WARNING, "GrassField",
						vformat("%d plots in '%s', the `folder` of a GrassWorld in %s, are not exported, so the game's grass will look as "
								"if nothing had been painted there. Add '%s' to the export filters for non-resource files (Resources tab), "
								"or export all resources.",
								missing, folder, scene, folder.trim_prefix("res://").path_join("*.grassmap")));
			}
		}
	}
}

} // namespace grass
