// SPDX-License-Identifier: MIT
// The .gdextension of this library: where it lies, and which libraries it names for an export.
#pragma once

#include <godot_cpp/classes/config_file.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace grass {

inline constexpr char UNIVERSAL[] = "universal"; // the architecture of libraries on macOS that serve both of its processors

struct NamedLibrary {
	godot::String path; // "": none fits
	godot::PackedStringArray tags; // the features that it is for
};

class ExtensionFile {
public:
	static constexpr char NAME[] = "grass_field.gdextension";

	// Loads the file. Returns false if the engine did not load this library from such a file, or if it cannot be read.
	bool load();
	const godot::String &get_path() const { return _path; }
	// Returns the library for an export. p_architecture: "" if the export names none.
	NamedLibrary find_library(const godot::PackedStringArray &p_features, const godot::String &p_architecture) const;
	// Returns the architectures for which an export may need a library, or "" if it names none.
	static godot::PackedStringArray find_architectures(const godot::PackedStringArray &p_features);

private:
	godot::String _path;
	godot::Ref<godot::ConfigFile> _config;
};

} // namespace grass
