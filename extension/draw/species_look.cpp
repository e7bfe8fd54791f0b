// SPDX-License-Identifier: MIT
#include "draw/species_look.h"

#include "core/base/half.h"
#include "core/species/card_coverage.h"
#include "shared/convert.h"
#include "shared/picture.h"

#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

Color mean_color(const Ref<Image> &p_image) {
	return mean_color(p_image, Cards::SIDE / 4, 0.5f);
}

namespace {

// Returns the mean colour of several pictures, each weighted by its opaque share.
Color mean_color(std::span<const Ref<Image>> p_images) {
	Color sum(0, 0, 0, 0);
	for (const Ref<Image> &image : p_images) {
		const Color mean = grass::mean_color(image);
		sum += Color(mean.a * mean.r, mean.a * mean.g, mean.a * mean.b, mean.a);
	}
	const float opaque = std::max(float(sum.a), 1e-6f);
	return Color(sum.r / opaque, sum.g / opaque, sum.b / opaque, sum.a / float(std::max(p_images.size(), size_t(1))));
}

float luminance(const Color &p_color) {
	return 0.2126f * p_color.r + 0.7152f * p_color.g + 0.0722f * p_color.b;
}

// Returns all images that become layers, in their order.
std::vector<Ref<Image>> images_of(std::span<const SpeciesLook> p_looks) {
	std::vector<Ref<Image>> images;
	for (const SpeciesLook &look : p_looks) {
		images.insert(images.end(), look.card.begin(), look.card.end());
		if (look.leaf.is_valid()) {
			images.push_back(look.leaf);
		}
	}
	return images;
}

// Makes each mipmap of an image cover as much as the image does.
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

std::vector<Ref<Image>> read_card(const Ref<Texture2D> &p_texture, int p_pictures, const String &p_who) {
	String problem;
	const Ref<Image> image = read_picture(p_texture.is_valid() ? p_texture->get_image() : Ref<Image>(), problem);
	ERR_FAIL_COND_V_MSG(!problem.is_empty(), {}, vformat("%s %s", p_who, problem));
	if (image.is_null()) {
		return {};
	}
	image->clear_mipmaps();
	image->convert(Image::FORMAT_RGBA8);
	image->resize(p_pictures * Cards::SIDE, Cards::SIDE, Image::INTERPOLATE_LANCZOS);
	std::vector<Ref<Image>> pictures;
	for (int i = 0; i < p_pictures; i++) {
		const Ref<Image> picture = image->get_region(Rect2i(i * Cards::SIDE, 0, Cards::SIDE, Cards::SIDE));
		picture->generate_mipmaps();
		pictures.push_back(with_kept_coverage(picture));
	}
	return pictures;
}

bool are_made_of(const Cards &p_cards, std::span<const SpeciesLook> p_looks) {
	const auto same = [&](size_t p_species) {
		const bool has_card = p_species < p_looks.size() && !p_looks[p_species].card.empty();
		const bool has_leaf = p_species < p_looks.size() && p_looks[p_species].leaf.is_valid();
		return p_cards.flowers[p_species].pictures == (has_card ? int(p_looks[p_species].card.size()) : 0) &&
				p_cards.leaves[p_species].pictures == int(has_leaf);
	};
	for (size_t s = 0; s < p_cards.flowers.size(); s++) { // the same pictures may belong to other species
		if (!same(s)) {
			return false;
		}
	}
	return p_cards.images == images_of(p_looks);
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
	cards.images = images_of(p_looks);
	int layer = 0;
	for (size_t s = 0; s < p_looks.size(); s++) {
		const SpeciesLook &look = p_looks[s];
		if (!look.card.empty()) {
			cards.flowers[s] = { layer, int(look.card.size()), mean_color(std::span(look.card)) };
			layer += int(look.card.size());
		}
		if (look.leaf.is_valid()) {
			cards.leaves[s] = { layer++, 1, mean_color(look.leaf) };
		}
	}
	TypedArray<Ref<Image>> images;
	for (const Ref<Image> &image : cards.images) {
		images.push_back(image);
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
			GRASS_LOOK_CARD_FAR == GRASS_LOOK_CARD_COLOR + 1 && GRASS_LOOK_LEAF == GRASS_LOOK_CARD_FAR + 1 &&
			GRASS_LOOK_TEXELS == GRASS_LOOK_LEAF + 1);
	std::vector<uint16_t> halves;
	const auto put = [&](float p_r, float p_g, float p_b, float p_a) {
		for (const float value : { p_r, p_g, p_b, p_a }) {
			halves.push_back(float_to_half(value));
		}
	};
	for (size_t s = 0; s < p_looks.size(); s++) {
		const SpeciesLook &look = p_looks[s];
		for (const Color &color : look.colors) {
			put(color.r, color.g, color.b, look.hue_variation);
		}
		put(look.dry_color.r, look.dry_color.g, look.dry_color.b, look.dry);
		put(look.canopy_among_others, look.canopy_alone, look.blade_area, look.leaf_width);
		const Cards::Seen &flower = p_cards.flowers[s], &leaf = p_cards.leaves[s];
		const Color &tint = look.card_color, far = tint * flower.color;
		put(look.card_width, look.card_height, float(flower.layer), look.card_share);
		put(tint.r, tint.g, tint.b, 1.0f / std::max(luminance(leaf.color), 0.1f));
		put(far.r, far.g, far.b, far.a * look.card_width * look.card_height / std::max(look.blade_area, 1e-6f));
		put(look.leaf_size, float(leaf.layer), look.card_flatness, float(look.card.size()));
	}
	return ImageTexture::create_from_image(Image::create_from_data(
			GRASS_LOOK_TEXELS, int32_t(p_looks.size()), false, Image::FORMAT_RGBAH, to_bytes(std::span<const uint16_t>(halves))));
}

} // namespace grass
