// SPDX-License-Identifier: MIT
#include "editor/species_preview.h"

#include "convert.h"
#include "core/plants/species_picture.h"
#include "nodes/grass_species.h"

#include <godot_cpp/classes/image_texture.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

Eigen::Vector3f to_vector(const Color &p_color) {
	return { p_color.r, p_color.g, p_color.b };
}

} // namespace

bool SpeciesPreview::_handles(const String &p_type) const {
	return p_type == "GrassSpecies";
}

Ref<Texture2D> SpeciesPreview::_generate(const Ref<Resource> &p_resource, const Vector2i &p_size, const Dictionary &p_metadata) const {
	(void)p_metadata;
	const GrassSpecies *species = Object::cast_to<GrassSpecies>(p_resource.ptr());
	const int side = std::min(p_size.x, p_size.y);
	if (species == nullptr || side <= 0) {
		return {};
	}
	const SpeciesLook look = species->make_look(read_card(species->get_card()));
	PictureLook picture;
	for (const Color &color : look.colors) {
		picture.colors.push_back(to_vector(color));
	}
	picture.dry_color = to_vector(look.dry_color);
	picture.dry = look.dry;
	picture.card_color = to_vector(look.card_color);
	picture.card_share = look.card_share;
	picture.card_width = look.card_width;
	picture.card_height = look.card_height;
	const PackedByteArray card = look.card.is_valid() ? look.card->get_data() : PackedByteArray();
	picture.card = { card.ptr(), size_t(card.size()) };
	picture.card_side = look.card.is_valid() ? Cards::SIDE : 0;
	const Ref<GrassPatch> patch = species->get_patch();
	const std::vector<uint8_t> bytes = draw_species(patch.is_valid() ? patch->get_params() : PatchParams(), picture, side);
	return ImageTexture::create_from_image(
			Image::create_from_data(side, side, false, Image::FORMAT_RGBA8, to_bytes(std::span<const uint8_t>(bytes))));
}

} // namespace grass
