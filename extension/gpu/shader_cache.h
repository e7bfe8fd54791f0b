// SPDX-License-Identifier: MIT
// Files with what the engine made of compute passes in earlier runs (core/base/shader_file.h), beside the engine's own cache of shaders.
// Where the folder cannot be written, or the project has shader caches off, nothing is kept and nothing is said.
#pragma once

#include <godot_cpp/variant/packed_byte_array.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace grass {

// Belongs to the worker thread that compiles: files may be slow.
class ShaderCache {
public:
	// What RenderingDevice.shader_compile_binary_from_spirv() returned for this code on this driver. Empty if no sound file says.
	godot::PackedByteArray read(std::span<const uint32_t> p_spirv);
	// Stores it, replacing what the file holds.
	void write(std::span<const uint32_t> p_spirv, const godot::PackedByteArray &p_shader);

private:
	bool is_on();
	std::string key_of(std::span<const uint32_t> p_spirv) const;
	bool make_folder() const;
	void remove_surplus() const;

	bool _has_looked = false;
	// Of the standard library: a String must not outlive the engine.
	std::string _folder; // empty: nothing is kept
	std::string _driver, _versions;
};

} // namespace grass
