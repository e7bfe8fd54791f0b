// SPDX-License-Identifier: MIT
#include "editor/species_preview.h"

#include "core/species/species_picture.h"
#include "draw/plant_surfaces.h"
#include "shared/convert.h"

#include <godot_cpp/classes/image_texture.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

Eigen::Vector3f to_vector(const Color &p_color) {
	return { p_color.r, p_color.g, p_color.b };
}

Ref<Image> to_image(const std::vector<uint8_t> &p_texels, int p_side) {
	return Image::create_from_data(p_side, p_side, false, Image::FORMAT_RGBA8, to_bytes(std::span<const uint8_t>(p_texels)));
}

// Reads the plant on the editor's thread, where a script that is a mesh must not be called.
std::shared_ptr<const PlantModel> read_plant_of(const GrassSpecies &p_species) {
	const Ref<Mesh> mesh = p_species.get_plant_mesh();
	const bool is_read = mesh.is_valid() && Variant(mesh->get_script()).get_type() == Variant::NIL;
	return is_read ? read_plant(mesh, "GrassSpecies").model : nullptr;
}

} // namespace

Ref<Image> draw_picture(
		const GrassSpecies &p_species, const SpeciesLook &p_look, const std::shared_ptr<const PlantModel> &p_plant, int p_side) {
	if (p_plant) {
		return to_image(draw_plant(picture_surfaces(*p_plant), p_side), p_side);
	}
	PictureLook picture;
	for (const Color &color : p_look.colors) {
		picture.colors.push_back(to_vector(color));
	}
	picture.dry_color = to_vector(p_look.dry_color);
	picture.dry = p_look.dry;
	picture.card_color = to_vector(p_look.card_color);
	picture.card_share = p_look.card_share;
	picture.card_width = p_look.card_width;
	picture.card_height = p_look.card_height;
	picture.leaf_size = p_look.leaf_size;
	const PackedByteArray card = p_look.card.empty() ? PackedByteArray() : p_look.card.front()->get_data();
	const PackedByteArray leaf = p_look.leaf.is_valid() ? p_look.leaf->get_data() : PackedByteArray();
	picture.card = { card.ptr(), size_t(card.size()) };
	picture.leaf = { leaf.ptr(), size_t(leaf.size()) };
	picture.card_side = Cards::SIDE;
	const Ref<GrassPatch> patch = p_species.get_patch();
	return to_image(draw_species(patch.is_valid() ? patch->get_params() : PatchParams(), picture, p_side), p_side);
}

bool SpeciesPreview::_handles(const String &p_type) const {
	return p_type == "GrassSpecies";
}

Ref<Texture2D> SpeciesPreview::_generate(const Ref<Resource> &p_resource, const Vector2i &p_size, const Dictionary &) const {
	const GrassSpecies *species = Object::cast_to<GrassSpecies>(p_resource.ptr());
	const int side = std::min(p_size.x, p_size.y);
	if (species == nullptr || side <= 0) {
		return {};
	}
	const std::vector<Ref<Image>> card = species->read_card(), leaf = species->read_leaf();
	const SpeciesLook look = species->make_look(card, leaf.empty() ? Ref<Image>() : leaf.front());
	return ImageTexture::create_from_image(draw_picture(*species, look, read_plant_of(*species), side));
}

} // namespace grass
