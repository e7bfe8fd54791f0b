// SPDX-License-Identifier: MIT
// A file that keeps what the engine made of a shader, so that the next start need not make it again. Whatever reads it hands the bytes
// to the driver, and neither the engine nor drivers check them: so a file is used as it was written, or not at all.
//
//   0  8 bytes  "GRASSSHD"
//   8  u32      version, SHADER_FILE_VERSION
//  12  u32      bytes of the key
//  16  u32      bytes of the shader
//  20  u32      checksum of all above and all below
//  24           the key: all that the shader was made of and for, as text
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
inline constexpr size_t SHADER_BYTES_MOST = 1 << 20; // of one shader; the largest has 0.2 MB
inline constexpr size_t SHADER_KEY_BYTES_MOST = 4096;
// Files in the folder. A driver and a version of the addon need ten.
inline constexpr size_t SHADER_FILES_MOST = 64;

// p_made_for: driver and versions; each may compile the same code to another shader.
std::string shader_key(std::initializer_list<std::string_view> p_made_for, std::span<const uint32_t> p_spirv);

// The name of its file; different keys hardly ever share one; the key inside the file settles it.
std::string shader_file_name(std::string_view p_key);
bool is_shader_file_name(std::string_view p_name); // or that of one which is not finished

// Empty if the shader or the key is too large.
std::vector<uint8_t> write_shader_file(std::string_view p_key, std::span<const uint8_t> p_shader);
size_t shader_file_bytes_most(std::string_view p_key);
// The shader in the bytes of a file. Empty if they are not exactly what write_shader_file() returned for this key.
std::span<const uint8_t> read_shader_file(std::string_view p_key, std::span<const uint8_t> p_bytes);

struct KeptFile {
	std::string name;
	uint64_t written = 0; // seconds
	auto operator<=>(const KeptFile &) const = default;
};
// The names of the oldest of them, without which no more than p_most are left.
std::vector<std::string> surplus_files(std::vector<KeptFile> p_files, size_t p_most);

} // namespace grass
