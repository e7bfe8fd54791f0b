// SPDX-License-Identifier: MIT
// The head of a picture's file: what must be known before unpacking its pixels, which may take a thousand times the bytes of the file.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace grass {

struct PictureHeader {
	enum Kind { UNKNOWN, PNG, EXR };
	Kind kind = UNKNOWN;
	int64_t width = 0, height = 0; // 0: the file is cut off or damaged
	std::string reason; // why its numbers would change when they are read, and what to do, following the file's name; "": they would not
};

PictureHeader read_picture_header(std::span<const uint8_t> p_bytes);

} // namespace grass
