// SPDX-License-Identifier: MIT
#include "draw/species_look.h"

#include "convert.h"
#include "core/base/half.h"
#include "core/plants/card_coverage.h"

#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <vector>

using namespace godot;

namespace grass {

namespace {

Color mean_color(const Ref<Image> &p_image) {
	constexpr int STEP = 4, COUNT = (Cards::SIDE / STEP) * (Cards::SIDE / STEP);
	Color sum(0, 0, 0, 0);
	for (int y = 0; y < Cards::SIDE; y += STEP) {
		for (int x = 0; x < Cards::SIDE; x += STEP) {
			const Color color = p_image->get_pixel(x, y).srgb_to_linear();
			sum += color.a < 0.5f ? Color(0, 0, 0, 0) : Color(color.r, color.g, color.b, 1);
		}
	}
	const float opaque = std::max(float(sum.a), 1.0f);
	return Color(sum.r / opaque, sum.g / opaque, sum.b / opaque, sum.a / float(COUNT));
}

// Each smaller version of an image shows as much of it.
Ref<Image> with_kept_coverage(const Ref<Image> &p_image) {
	PackedByteArray bytes = p_image->get_data();
	const std::span<uint8_t> all(bytes.ptrw(), size_t(bytes.size()));
	size_t begin = 0;
	double coverage = 0.0;
	for (int side = Cards::SIDE; side > 0 && begin < all.size(); side /= 2) {
		const std::span<uint8_t> level = all.subspan(begin, std::min(size_t(4 * side * side), all.size() - begin));
		if (begin == 0) {
			coverage = card_coverage(level);
		} else {
			keep_card_coverage(level, coverage);
		}
		begin += level.size();
	}
	return Image::create_from_data(Cards::SIDE, Cards::SIDE, true, Image::FORMAT_RGBA8, bytes);
}

} // namespace

Ref<Image> read_card(const Ref<Texture2D> &p_texture) {
	const Ref<Image> found = p_texture.is_valid() ? p_texture->get_image() : Ref<Image>();
	if (found.is_null() || found->is_empty()) {
		return {};
	}
	Ref<Image> image = found->duplicate(); // get_image() may hand out the texture's own
	ERR_FAIL_COND_V_MSG(image->is_compressed() && image->decompress() != OK, {},
			"GrassSpecies: the texture of `card` is compressed in a way that cannot be read. Import it as Lossless or VRAM Uncompressed.");
	image->clear_mipmaps();
	image->convert(Image::FORMAT_RGBA8);
	image->resize(Cards::SIDE, Cards::SIDE, Image::INTERPOLATE_LANCZOS);
	image->generate_mipmaps();
	return with_kept_coverage(image);
}

bool are_made_of(const Cards &p_cards, std::span<const SpeciesLook> p_looks) {
	for (size_t s = 0; s < p_cards.images.size(); s++) {
		if (p_cards.images[s] != (s < p_looks.size() ? p_looks[s].card : Ref<Image>())) {
			return false;
		}
	}
	return true;
}

int64_t Cards::get_memory_usage() const {
	int64_t bytes = 0;
	for (const Ref<Image> &image : images) {
		bytes += image.is_valid() ? image->get_data_size() : 0;
	}
	return bytes;
}

Cards make_cards(std::span<const SpeciesLook> p_looks) {
	Cards cards;
	TypedArray<Ref<Image>> images;
	for (size_t s = 0; s < p_looks.size(); s++) {
		const Ref<Image> &image = p_looks[s].card;
		cards.images[s] = image;
		if (image.is_valid()) {
			cards.colors[s] = mean_color(image);
			cards.layers[s] = int(images.size());
			images.push_back(image);
		}
	}
	if (!images.is_empty()) {
		cards.textures.instantiate();
		cards.textures->create_from_images(images);
	}
	return cards;
}

Ref<ImageTexture> make_look_texture(std::span<const SpeciesLook> p_looks, const Cards &p_cards) {
	static_assert(GRASS_LOOK_DRY == GRASS_LOOK_COLORS && GRASS_LOOK_CANOPY == GRASS_LOOK_DRY + 1 &&
			GRASS_LOOK_CARD == GRASS_LOOK_CANOPY + 1 && GRASS_LOOK_CARD_COLOR == GRASS_LOOK_CARD + 1 &&
			GRASS_LOOK_CARD_FAR == GRASS_LOOK_CARD_COLOR + 1 && GRASS_LOOK_TEXELS == GRASS_LOOK_CARD_FAR + 1);
	std::vector<uint16_t> halves;
	const auto put = [&](float p_r, float p_g, float p_b, float p_a) {
		for (const float value : { p_r, p_g, p_b, p_a }) {
			halves.push_back(float_to_half(value));
		}
	};
	for (size_t s = 0; s < p_looks.size(); s++) {
		const SpeciesLook &look = p_looks[s];
		for (const Color &color : look.colors) {
			put(color.r, color.g, color.b, 1.0f);
		}
		put(look.dry_color.r, look.dry_color.g, look.dry_color.b, look.dry);
		put(look.canopy_among_others, look.canopy_alone, look.blade_area, 0.0f);
		const Color &tint = look.card_color, far = tint * p_cards.colors[s];
		put(look.card_width, look.card_height, float(p_cards.layers[s]), look.card_share);
		put(tint.r, tint.g, tint.b, 1.0f);
		put(far.r, far.g, far.b, far.a * look.card_width * look.card_height / std::max(look.blade_area, 1e-6f));
	}
	return ImageTexture::create_from_image(Image::create_from_data(
			GRASS_LOOK_TEXELS, int32_t(p_looks.size()), false, Image::FORMAT_RGBAH, to_bytes(std::span<const uint16_t>(halves))));
}

} // namespace grass
