// SPDX-License-Identifier: MIT
#include "editor/extension_file.h"

#include <godot_cpp/classes/gd_extension_manager.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

constexpr const char *ARCHITECTURES[] = { "x86_32", "x86_64", "arm32", "arm64", "rv64", "ppc64", "loongarch64", "wasm32", UNIVERSAL };

bool is_architecture(const String &p_feature) {
	return std::ranges::any_of(ARCHITECTURES, [&](const char *p_architecture) { return p_feature == p_architecture; });
}

} // namespace

bool ExtensionFile::load() {
	_path = String();
	for (const String &path : GDExtensionManager::get_singleton()->get_loaded_extensions()) {
		if (path.get_file() == NAME) {
			_path = path;
		}
	}
	_config.instantiate();
	return !_path.is_empty() && _config->load(_path) == OK;
}

// Chooses as the engine does: among the libraries whose tags are all features of the export, the one with the most tags.
NamedLibrary ExtensionFile::find_library(const PackedStringArray &p_features, const String &p_architecture) const {
	NamedLibrary found;
	for (const String &key : _config->get_section_keys("libraries")) {
		const PackedStringArray tags = key.split(".");
		bool fits = tags.size() > found.tags.size();
		for (const String &tag : tags) {
			fits = fits && (is_architecture(tag) ? tag == p_architecture : p_features.has(tag));
		}
		if (fits) {
			const String path = _config->get_value("libraries", key);
			found = { path.is_absolute_path() ? path : _path.get_base_dir().path_join(path), tags };
		}
	}
	return found;
}

PackedStringArray ExtensionFile::find_architectures(const PackedStringArray &p_features) {
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

} // namespace grass
