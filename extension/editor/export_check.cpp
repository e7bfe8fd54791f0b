// SPDX-License-Identifier: MIT
#include "editor/export_check.h"

#include <godot_cpp/classes/config_file.hpp>
#include <godot_cpp/classes/dir_access.hpp>
#include <godot_cpp/classes/editor_export_platform.hpp>
#include <godot_cpp/classes/file_access.hpp>
#include <godot_cpp/classes/gd_extension_manager.hpp>

#include <vector>

using namespace godot;

namespace grass {

namespace {

constexpr char EXTENSION[] = "grass_field.gdextension";
constexpr const char *ARCHITECTURES[] = { "x86_32", "x86_64", "arm32", "arm64", "rv64", "ppc64", "loongarch64", "wasm32" };
constexpr const char *SYSTEMS[] = { "linux", "windows", "macos", "android", "ios", "web" };
constexpr char UNIVERSAL[] = "universal"; // of macOS: for both of its processors

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

// What an export may need a library for: each of its architectures, or "" where it names none.
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

// Chooses as the engine does: of the libraries all of whose tags are features of the export, that with the most tags. "": none is named.
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

bool is_there(const String &p_library) {
	return !p_library.is_empty() &&
			(FileAccess::file_exists(p_library) || DirAccess::dir_exists_absolute(p_library)); // frameworks are folders
}

} // namespace

void ExportCheck::_export_begin(const PackedStringArray &p_features, bool p_is_debug, const String &p_path, uint32_t p_flags) {
	(void)p_path; // wherever it goes
	(void)p_flags;
	const String path = find_extension();
	Ref<ConfigFile> extension;
	extension.instantiate();
	if (path.is_empty() || extension->load(path) != OK) {
		return; // then the engine has said so
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

} // namespace grass
