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

Color mean_color(const Ref<Image> &p_image, int p_steps, float p_scissor) {
	Color sum(0, 0, 0, 0);
	for (int y = 0; y < p_steps; y++) {
		for (int x = 0; x < p_steps; x++) {
			const Color color =
					p_image->get_pixel(x * p_image->get_width() / p_steps, y * p_image->get_height() / p_steps).srgb_to_linear();
			sum += color.a < p_scissor ? Color(0, 0, 0, 0) : Color(color.r, color.g, color.b, 1);
		}
	}
	const float opaque = std::max(float(sum.a), 1.0f);
	return Color(sum.r / opaque, sum.g / opaque, sum.b / opaque, sum.a / float(p_steps * p_steps));
}

} // namespace grass
