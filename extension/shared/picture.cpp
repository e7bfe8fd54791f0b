// SPDX-License-Identifier: MIT
#include "shared/picture.h"

#include <algorithm>

using namespace godot;

namespace grass {

Ref<Image> read_picture(const Ref<Image> &p_picture, String &r_problem) {
	if (p_picture.is_null() || p_picture->is_empty()) {
		return {};
	}
	const int64_t width = p_picture->get_width(), height = p_picture->get_height();
	if (std::max(width, height) > PICTURE_SIDE_MAX) {
		r_problem =
				vformat("has %d x %d texels, but at most %d along a side are read. Use a smaller one.", width, height, PICTURE_SIDE_MAX);
		return {};
	}
	Ref<Image> copy = p_picture->duplicate();
	if (copy->is_compressed() && copy->decompress() != OK) {
		r_problem = "is compressed in a way that cannot be read. Import it as Lossless or VRAM Uncompressed.";
		return {};
	}
	return copy;
}

} // namespace grass
