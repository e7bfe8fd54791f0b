// SPDX-License-Identifier: MIT
#include "core/paint/picture_header.h"

#include "core/base/bytes.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace grass {

namespace {

constexpr std::string_view PNG_MAGIC("\x89PNG\r\n\x1a\n", 8), EXR_MAGIC("\x76\x2f\x31\x01", 4);
constexpr size_t PNG_HEADER_BYTES = 33; // magic, and the chunk IHDR

bool begins_with(std::span<const uint8_t> p_bytes, std::string_view p_magic) {
	return p_bytes.size() >= p_magic.size() && std::memcmp(p_bytes.data(), p_magic.data(), p_magic.size()) == 0;
}

uint32_t get_big_endian(std::span<const uint8_t> p_bytes, size_t p_at) {
	return uint32_t(p_bytes[p_at]) << 24 | uint32_t(p_bytes[p_at + 1]) << 16 | uint32_t(p_bytes[p_at + 2]) << 8 | p_bytes[p_at + 3];
}

// Returns whether the gamma is another than that of sRGB: the decoder would convert it, which changes the bytes. Without a gamma it takes
// them as they are.
bool has_other_gamma(std::span<const uint8_t> p_bytes) {
	constexpr int64_t SRGB_GAMMA = 45455, SAME_GAMMA = 500; // in units of 1e-5
	bool has_other = false;
	for (size_t at = PNG_HEADER_BYTES; at + 12 <= p_bytes.size();) {
		const size_t size = get_big_endian(p_bytes, at);
		const std::string_view name(reinterpret_cast<const char *>(&p_bytes[at + 4]), 4);
		if (name == "sRGB" || name == "IDAT") { // the former overrules a gamma
			return name == "IDAT" && has_other;
		}
		has_other = has_other || (name == "gAMA" && std::llabs(int64_t(get_big_endian(p_bytes, at + 8)) - SRGB_GAMMA) > SAME_GAMMA);
		at += 12 + size;
	}
	return false;
}

PictureHeader read_png(std::span<const uint8_t> p_bytes) {
	PictureHeader header{ PictureHeader::PNG, 0, 0, {} };
	if (p_bytes.size() >= PNG_HEADER_BYTES) {
		header.width = get_big_endian(p_bytes, 16);
		header.height = get_big_endian(p_bytes, 20);
		if (p_bytes[24] > 8) {
			header.reason = "has 16 bits a channel, of which reading would keep 8, in other colours. Save it with 8 bits, or as EXR.";
		} else if (has_other_gamma(p_bytes)) {
			header.reason =
					"is in a colour space other than sRGB, so reading would change its numbers. Save it as sRGB, or without a gamma.";
		}
	}
	return header;
}

PictureHeader read_exr(std::span<const uint8_t> p_bytes) {
	constexpr std::string_view WINDOW("dataWindow\0box2i\0\x10\0\0\0", 21); // an attribute: xMin, yMin, xMax, yMax follow
	PictureHeader header{ PictureHeader::EXR, 0, 0, {} };
	const auto found = std::search(p_bytes.begin(), p_bytes.end(), WINDOW.begin(), WINDOW.end(),
			[](uint8_t p_byte, char p_letter) { return p_byte == uint8_t(p_letter); });
	const size_t at = size_t(found - p_bytes.begin()) + WINDOW.size();
	if (at + 16 <= p_bytes.size()) {
		const auto corner = [&](size_t p_n) { return int64_t(int32_t(get_u32(p_bytes, at + 4 * p_n))); };
		header.width = corner(2) - corner(0) + 1;
		header.height = corner(3) - corner(1) + 1;
	}
	return header;
}

} // namespace

PictureHeader read_picture_header(std::span<const uint8_t> p_bytes) {
	return begins_with(p_bytes, PNG_MAGIC) ? read_png(p_bytes) : (begins_with(p_bytes, EXR_MAGIC) ? read_exr(p_bytes) : PictureHeader());
}

} // namespace grass
