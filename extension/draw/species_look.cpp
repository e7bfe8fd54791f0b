// SPDX-License-Identifier: MIT
#include "draw/species_look.h"

#include "convert.h"
#include "core/half.h"

#include <godot_cpp/classes/image.hpp>

#include <vector>

using namespace godot;

namespace grass {

Ref<ImageTexture> make_look_texture(std::span<const SpeciesLook> p_looks) {
	static_assert(
			GRASS_LOOK_DRY == GRASS_LOOK_COLORS && GRASS_LOOK_CANOPY == GRASS_LOOK_DRY + 1 && GRASS_LOOK_TEXELS == GRASS_LOOK_CANOPY + 1);
	std::vector<uint16_t> halves;
	const auto put = [&](float p_r, float p_g, float p_b, float p_a) {
		for (const float value : { p_r, p_g, p_b, p_a }) {
			halves.push_back(float_to_half(value));
		}
	};
	for (const SpeciesLook &look : p_looks) {
		for (const Color &color : look.colors) {
			put(color.r, color.g, color.b, 1.0f);
		}
		put(look.dry_color.r, look.dry_color.g, look.dry_color.b, look.dry);
		put(look.canopy_among_others, look.canopy_alone, 0.0f, 0.0f);
	}
	return ImageTexture::create_from_image(Image::create_from_data(
			GRASS_LOOK_TEXELS, int32_t(p_looks.size()), false, Image::FORMAT_RGBAH, to_bytes(std::span<const uint16_t>(halves))));
}

} // namespace grass
