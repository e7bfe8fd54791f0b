// SPDX-License-Identifier: MIT
#include "editor/species_preview.h"

#include "core/species/plant_picture.h"
#include "core/species/species_picture.h"
#include "shared/convert.h"
#include "shared/picture.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>
#include <iterator>

using namespace godot;

namespace grass {

namespace {

constexpr int TEXTURE_SIDE = 256; // texels of a plant's texture that a small picture needs

Eigen::Vector3f to_vector(const Color &p_color) {
	return { p_color.r, p_color.g, p_color.b };
}

Ref<Image> to_image(const std::vector<uint8_t> &p_texels, int p_side) {
	return Image::create_from_data(p_side, p_side, false, Image::FORMAT_RGBA8, to_bytes(std::span<const uint8_t>(p_texels)));
}

void add_texture(const Ref<Texture2D> &p_texture, PictureSurface &r_surface) {
	String problem; // what draws the plant says it
	const Ref<Image> image = read_picture(p_texture.is_valid() ? p_texture->get_image() : Ref<Image>(), problem);
	if (image.is_null()) {
		return;
	}
	image->resize(std::min(image->get_width(), TEXTURE_SIDE), std::min(image->get_height(), TEXTURE_SIDE), Image::INTERPOLATE_NEAREST);
	image->convert(Image::FORMAT_RGBA8);
	const PackedByteArray texels = image->get_data();
	r_surface.texture_width = image->get_width();
	r_surface.texture_height = image->get_height();
	r_surface.texture.assign(texels.ptr(), texels.ptr() + 4 * r_surface.texture_width * r_surface.texture_height); // without mipmaps
}

PictureSurface surface_of(const PlantModel::Surface &p_surface) {
	const PackedVector3Array places = p_surface.arrays[Mesh::ARRAY_VERTEX];
	const PackedVector2Array uvs = p_surface.arrays[Mesh::ARRAY_TEX_UV];
	const PackedFloat32Array tints = p_surface.arrays[Mesh::ARRAY_CUSTOM0];
	const PackedInt32Array indices = p_surface.arrays[Mesh::ARRAY_INDEX];
	const Eigen::Vector3f albedo = to_vector(p_surface.color.srgb_to_linear());
	PictureSurface surface;
	for (int64_t i = 0; i < places.size(); i++) {
		const Color tint = Color(tints[3 * i], tints[3 * i + 1], tints[3 * i + 2]).srgb_to_linear();
		surface.places.push_back(to_eigen(places[i]).cast<float>());
		surface.colors.push_back(albedo.cwiseProduct(to_vector(tint)));
		surface.uvs.push_back(to_eigen(uvs[i]).cast<float>());
	}
	surface.indices.assign(indices.ptr(), indices.ptr() + indices.size());
	surface.scissor = p_surface.scissor;
	add_texture(p_surface.texture, surface);
	return surface;
}

// On the editor's thread. A script that is a mesh must not be called there.
std::shared_ptr<const PlantModel> read_plant_of(const GrassSpecies &p_species) {
	const Ref<Mesh> mesh = p_species.get_plant_mesh();
	const bool is_read = mesh.is_valid() && Variant(mesh->get_script()).get_type() == Variant::NIL;
	return is_read ? read_plant(mesh, "GrassSpecies").model : nullptr;
}

} // namespace

Ref<Image> draw_picture(
		const GrassSpecies &p_species, const SpeciesLook &p_look, const std::shared_ptr<const PlantModel> &p_plant, int p_side) {
	if (p_plant) {
		std::vector<PictureSurface> surfaces;
		std::ranges::transform(p_plant->surfaces, std::back_inserter(surfaces), surface_of);
		return to_image(draw_plant(surfaces, p_side), p_side);
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
