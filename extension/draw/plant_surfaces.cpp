// SPDX-License-Identifier: MIT
#include "draw/plant_surfaces.h"

#include "shared/convert.h"
#include "shared/picture.h"

#include <godot_cpp/classes/image.hpp>
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

// Returns a surface with colours as shaders/draw/plant.gdshader shows them.
PictureSurface surface_of(const PlantModel::Surface &p_surface) {
	const PackedVector3Array places = p_surface.arrays[Mesh::ARRAY_VERTEX], normals = p_surface.arrays[Mesh::ARRAY_NORMAL];
	const PackedVector2Array uvs = p_surface.arrays[Mesh::ARRAY_TEX_UV];
	const PackedFloat32Array tints = p_surface.arrays[Mesh::ARRAY_CUSTOM0];
	const PackedInt32Array indices = p_surface.arrays[Mesh::ARRAY_INDEX];
	const Eigen::Vector3f albedo = to_vector(p_surface.color.srgb_to_linear());
	PictureSurface surface;
	for (int64_t i = 0; i < places.size(); i++) {
		const Eigen::Array3f tint(tints[3 * i], tints[3 * i + 1], tints[3 * i + 2]);
		surface.places.push_back(to_eigen(places[i]).cast<float>());
		surface.normals.push_back(to_eigen(normals[i]).cast<float>());
		surface.colors.push_back((albedo.array() * tint.pow(2.2f)).matrix());
		surface.uvs.push_back(to_eigen(uvs[i]).cast<float>());
	}
	surface.indices.assign(indices.ptr(), indices.ptr() + indices.size());
	surface.scissor = p_surface.scissor;
	add_texture(p_surface.texture, surface);
	return surface;
}

} // namespace

std::vector<PictureSurface> picture_surfaces(const PlantModel &p_model) {
	std::vector<PictureSurface> surfaces;
	std::ranges::transform(p_model.surfaces, std::back_inserter(surfaces), surface_of);
	return surfaces;
}

} // namespace grass
