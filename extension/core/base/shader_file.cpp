// SPDX-License-Identifier: MIT
#include "core/base/shader_file.h"

#include "core/base/bytes.h"

#include <algorithm>
#include <bit>
#include <tuple>

namespace grass {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");

namespace {

constexpr std::string_view SHADER_MAGIC = "GRASSSHD", SHADER_SUFFIX = ".shader", UNFINISHED_SUFFIX = ".tmp";
constexpr size_t SHADER_HEADER_BYTES = 24, SUM_AT = 20;

std::span<const uint8_t> bytes_of(std::string_view p_text) {
	return { reinterpret_cast<const uint8_t *>(p_text.data()), p_text.size() };
}

// Returns the FNV-1a hash.
uint64_t hash_bytes(std::span<const uint8_t> p_bytes) {
	uint64_t hash = 0xcbf29ce484222325u;
	for (const uint8_t byte : p_bytes) {
		hash = (hash ^ byte) * 0x100000001b3u;
	}
	return hash;
}

std::string to_hex(uint64_t p_value) {
	std::string text;
	for (int shift = 60; shift >= 0; shift -= 4) {
		text += "0123456789abcdef"[p_value >> shift & 15u];
	}
	return text;
}

// Returns the checksum of a file's bytes, leaving out those of the checksum itself.
uint32_t sum_of(std::span<const uint8_t> p_bytes) {
	std::vector<uint8_t> summed(p_bytes.begin(), p_bytes.begin() + SUM_AT);
	const std::span<const uint8_t> rest = p_bytes.subspan(SHADER_HEADER_BYTES);
	summed.insert(summed.end(), rest.begin(), rest.end());
	return checksum(summed);
}

} // namespace

std::string shader_key(std::initializer_list<std::string_view> p_made_for, std::span<const uint32_t> p_spirv) {
	std::string key;
	for (const std::string_view part : p_made_for) {
		(key += part) += '\n';
	}
	const std::span<const uint8_t> code(reinterpret_cast<const uint8_t *>(p_spirv.data()), p_spirv.size_bytes());
	return key + to_hex(hash_bytes(code)) + ' ' + std::to_string(code.size()) + '\n';
}

std::string shader_file_name(std::string_view p_key) {
	return to_hex(hash_bytes(bytes_of(p_key))).append(SHADER_SUFFIX);
}

bool is_shader_file_name(std::string_view p_name) {
	return p_name.ends_with(SHADER_SUFFIX) || p_name.ends_with(UNFINISHED_SUFFIX);
}

std::vector<uint8_t> write_shader_file(std::string_view p_key, std::span<const uint8_t> p_shader) {
	if (p_shader.empty() || p_shader.size() > SHADER_BYTES_MOST || p_key.size() > SHADER_KEY_BYTES_MOST) {
		return {};
	}
	const std::span<const uint8_t> magic = bytes_of(SHADER_MAGIC), key = bytes_of(p_key);
	std::vector<uint8_t> bytes(magic.begin(), magic.end());
	for (const uint32_t value : { SHADER_FILE_VERSION, uint32_t(key.size()), uint32_t(p_shader.size()), 0u }) {
		put_u32(bytes, value);
	}
	bytes.insert(bytes.end(), key.begin(), key.end());
	bytes.insert(bytes.end(), p_shader.begin(), p_shader.end());
	const uint32_t sum = sum_of(bytes);
	std::memcpy(&bytes[SUM_AT], &sum, 4);
	return bytes;
}

size_t shader_file_bytes_most(std::string_view p_key) {
	return SHADER_HEADER_BYTES + p_key.size() + SHADER_BYTES_MOST;
}

std::span<const uint8_t> read_shader_file(std::string_view p_key, std::span<const uint8_t> p_bytes) {
	if (p_bytes.size() <= SHADER_HEADER_BYTES + p_key.size() || p_bytes.size() > shader_file_bytes_most(p_key) ||
			!std::ranges::equal(p_bytes.first(SHADER_MAGIC.size()), bytes_of(SHADER_MAGIC))) {
		return {};
	}
	const std::span<const uint8_t> key = p_bytes.subspan(SHADER_HEADER_BYTES, p_key.size()),
								   shader = p_bytes.subspan(SHADER_HEADER_BYTES + p_key.size());
	const bool is_ours = get_u32(p_bytes, 8) == SHADER_FILE_VERSION && get_u32(p_bytes, 12) == key.size() &&
			get_u32(p_bytes, 16) == shader.size() && std::ranges::equal(key, bytes_of(p_key));
	return is_ours && get_u32(p_bytes, SUM_AT) == sum_of(p_bytes) ? shader : std::span<const uint8_t>();
}

std::vector<std::string> surplus_files(std::vector<KeptFile> p_files, size_t p_most) {
	std::ranges::sort(p_files, {}, [](const KeptFile &p_file) { return std::tie(p_file.written, p_file.name); });
	std::vector<std::string> surplus;
	for (size_t i = 0; i + p_most < p_files.size(); i++) {
		surplus.push_back(std::move(p_files[i].name));
	}
	return surplus;
}

} // namespace grass
