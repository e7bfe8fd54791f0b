// SPDX-License-Identifier: MIT
// A file that caches a shader as the engine compiled it, so that the next start need not compile it again. The reader hands the bytes to
// the driver, and neither the engine nor drivers check them; so a file is used exactly as it was written, or not at all.
//
//   0  8 bytes  "GRASSSHD"
//   8  u32      version, SHADER_FILE_VERSION
//  12  u32      bytes of the key
//  16  u32      bytes of the shader
//  20  u32      checksum of all above and all below
//  24           the key: everything that the shader was made of and for, as text
//               the shader
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace grass {

inline constexpr uint32_t SHADER_FILE_VERSION = 1;
inline constexpr size_t SHADER_BYTES_MOST = 1 << 20; // most bytes of one shader; the largest has 0.2 MB
inline constexpr size_t SHADER_KEY_BYTES_MOST = 4096;
// Most files in the folder. One driver with one version of the add-on needs ten.
inline constexpr size_t SHADER_FILES_MOST = 64;

// Returns the key of a shader. p_made_for: driver and versions; each may compile the same code to another shader.
std::string shader_key(std::initializer_list<std::string_view> p_made_for, std::span<const uint32_t> p_spirv);

// Returns the name of the shader's file. Different keys hardly ever share a name; the key inside the file settles it.
std::string shader_file_name(std::string_view p_key);
bool is_shader_file_name(std::string_view p_name); // true for the name of an unfinished file as well

// Returns the bytes of the file. Empty if the shader or the key is too large.
std::vector<uint8_t> write_shader_file(std::string_view p_key, std::span<const uint8_t> p_shader);
size_t shader_file_bytes_most(std::string_view p_key);
// Returns the shader in the bytes of a file. Empty unless they are exactly what write_shader_file() returned for this key.
std::span<const uint8_t> read_shader_file(std::string_view p_key, std::span<const uint8_t> p_bytes);

struct KeptFile {
	std::string name;
	uint64_t written = 0; // time of writing, seconds
	auto operator<=>(const KeptFile &) const = default;
};
// Returns the names of the oldest files, as many as must go to leave p_most.
std::vector<std::string> surplus_files(std::vector<KeptFile> p_files, size_t p_most);

} // namespace grass
