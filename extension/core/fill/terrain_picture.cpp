// SPDX-License-Identifier: MIT
#include "core/fill/terrain_picture.h"

#include <algorithm>

namespace grass {

std::vector<TerrainColor> picture_of(const TerrainColors &p_colors) {
	const std::span<const TerrainColor> texels = p_colors.get_texels();
	const int width = p_colors.get_width(), depth = p_colors.get_depth();
	std::vector<TerrainColor> picture(texels.begin(), texels.end());
	const auto lend = [&](int p_i, int p_j, const TerrainColor &p_color) {
		for (int j = std::max(p_j - 1, 0); j <= std::min(p_j + 1, depth - 1); j++) {
			for (int i = std::max(p_i - 1, 0); i <= std::min(p_i + 1, width - 1); i++) {
				TerrainColor &texel = picture[size_t(j) * size_t(width) + size_t(i)];
				texel = texel.alpha == 0 ? p_color : texel;
			}
		}
	};
	for (int j = 0; j < depth; j++) {
		for (int i = 0; i < width; i++) {
			if (const TerrainColor &told = texels[size_t(j) * size_t(width) + size_t(i)]; told.alpha > 0) {
				lend(i, j, { told.red, told.green, told.blue, 0 });
			}
		}
	}
	return picture;
}

} // namespace grass
