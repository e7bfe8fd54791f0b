// SPDX-License-Identifier: MIT
#include "draw/patch_texture.h"

#include "core/blades/leaf_pictures.h"
#include "draw/shared_shader.h"
#include "shared/convert.h"

#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cmath>
#include <vector>

using namespace godot;

namespace grass {

Ref<Image> make_patch_image(const Patch &p_patch) {
	return Image::create_from_data(
			Patch::WIDTH, Patch::HEIGHT * p_patch.species, false, Image::FORMAT_RGBAH, to_bytes(std::span<const uint16_t>(p_patch.texels)));
}

Ref<ImageTexture> patch_texture(const std::shared_ptr<const Patch> &p_patch) {
	struct Made {
		std::weak_ptr<const Patch> patch;
		uint64_t texture; // the object's instance id, since fields keep it alive
	};
	static std::vector<Made> made;
	std::erase_if(made, [](const Made &p_made) { return p_made.patch.expired() || ObjectDB::get_instance(p_made.texture) == nullptr; });
	for (const Made &one : made) {
		if (one.patch.lock() == p_patch) {
			return Ref<ImageTexture>(Object::cast_to<ImageTexture>(ObjectDB::get_instance(one.texture)));
		}
	}
	Ref<ImageTexture> texture = ImageTexture::create_from_image(make_patch_image(*p_patch));
	made.push_back({ p_patch, texture->get_instance_id() });
	return texture;
}

namespace {

Ref<ImageTexture> make_lattice_texture() {
	std::vector<uint8_t> texels;
	texels.reserve(4 * GRASS_LATTICE_CELLS * GRASS_LATTICE_CELLS);
	for (int y = 0; y < GRASS_LATTICE_CELLS; y++) {
		for (int x = 0; x < GRASS_LATTICE_CELLS; x++) {
			const glsl::vec4 numbers = glsl::grass_lattice(glsl::ivec2(x, y));
			for (const float number : { numbers.x, numbers.y, numbers.z, numbers.w }) {
				texels.push_back(uint8_t(std::lround(number * 255.0f)));
			}
		}
	}
	return ImageTexture::create_from_image(Image::create_from_data(
			GRASS_LATTICE_CELLS, GRASS_LATTICE_CELLS, false, Image::FORMAT_RGBA8, to_bytes(std::span<const uint8_t>(texels))));
}

Ref<Texture2DArray> make_leaf_textures() {
	TypedArray<Ref<Image>> layers;
	for (int picture = 0; picture < GRASS_LEAF_PICTURES; picture++) {
		const std::vector<uint8_t> texels = make_leaf_picture(picture);
		const Ref<Image> image =
				Image::create_from_data(LEAF_ACROSS, LEAF_ALONG, false, Image::FORMAT_RGBA8, to_bytes(std::span<const uint8_t>(texels)));
		image->generate_mipmaps();
		layers.push_back(image);
	}
	Ref<Texture2DArray> textures;
	textures.instantiate();
	textures->create_from_images(layers);
	return textures;
}

Ref<ImageTexture> shared_lattice;
Ref<Texture2DArray> shared_leaves;

} // namespace

Ref<ImageTexture> lattice_texture() {
	if (shared_lattice.is_null()) {
		shared_lattice = make_lattice_texture();
	}
	return shared_lattice;
}

Ref<Texture2DArray> leaf_textures() {
	if (shared_leaves.is_null()) {
		shared_leaves = make_leaf_textures();
	}
	return shared_leaves;
}

void free_shared_textures() {
	shared_lattice.unref();
	shared_leaves.unref();
}

int shader_features(const FieldSetup &p_setup) {
	return (p_setup.is_mapped ? SHADER_MAP : 0) | (p_setup.species ? SHADER_SPECIES : 0) | (p_setup.card_size > 0.0f ? SHADER_CARDS : 0) |
			(p_setup.has_plants ? SHADER_PLANTS : 0) | (p_setup.has_terrain ? SHADER_TERRAIN : 0);
}

AABB field_bounds(const FieldSetup &p_setup, const TileCover *p_cover) {
	const double low = p_cover ? p_cover->get_low() : 0.0, high = p_cover ? p_cover->get_high() : 0.0;
	const double margin = p_setup.blade_length() + p_setup.tip_size(); // a blade blown or pressed flat
	const Vector3 half(real_t(0.5 * p_setup.grid.get_size_x() + margin), 0, real_t(0.5 * p_setup.grid.get_size_z() + margin));
	return AABB(Vector3(0, real_t(low), 0) - half, 2.0 * half + Vector3(0, real_t(high - low + margin), 0));
}

} // namespace grass
