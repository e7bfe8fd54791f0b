// SPDX-License-Identifier: MIT
#include "draw/patch_texture.h"

#include "convert.h"
#include "draw/shared_shader.h"

#include <godot_cpp/classes/image.hpp>

#include <cmath>

using namespace godot;

namespace grass {

Ref<Image> make_patch_image(const Patch &p_patch) {
	return Image::create_from_data(
			Patch::WIDTH, Patch::HEIGHT * p_patch.species, false, Image::FORMAT_RGBAH, to_bytes(std::span<const uint16_t>(p_patch.texels)));
}

Ref<ImageTexture> make_patch_texture(const Patch &p_patch) {
	return ImageTexture::create_from_image(make_patch_image(p_patch));
}

void update_patch_texture(const Ref<ImageTexture> &p_texture, const Patch &p_patch) {
	const Ref<Image> image = make_patch_image(p_patch);
	if (p_texture->get_height() == image->get_height()) {
		p_texture->update(image);
	} else { // another number of species
		p_texture->set_image(image);
	}
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

Ref<ImageTexture> shared_lattice;

} // namespace

Ref<ImageTexture> lattice_texture() {
	if (shared_lattice.is_null()) {
		shared_lattice = make_lattice_texture();
	}
	return shared_lattice;
}

void free_shared_textures() {
	shared_lattice.unref();
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
