// SPDX-License-Identifier: MIT
// Files with the compute passes that the engine compiled in earlier runs (core/base/shader_file.h), beside the engine's own shader cache.
// If the folder cannot be written, or the project has shader caches off, nothing is stored and nothing is reported.
#pragma once

#include <godot_cpp/variant/packed_byte_array.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace grass {

// Used only by the worker thread that compiles, since files may be slow.
class ShaderCache {
public:
	// Returns the result of RenderingDevice.shader_compile_binary_from_spirv() for this code on this driver; empty if no valid file has it.
	godot::PackedByteArray read(std::span<const uint32_t> p_spirv);
	// Stores it, replacing the file's contents.
	void write(std::span<const uint32_t> p_spirv, const godot::PackedByteArray &p_shader);

private:
	bool is_on();
	std::string key_of(std::span<const uint32_t> p_spirv) const;
	bool make_folder() const;
	void remove_surplus() const;

	bool _has_looked = false;
	// Standard strings, since a String must not outlive the engine.
	std::string _folder; // empty: nothing is stored
	std::string _driver, _versions;
};

} // namespace grass
