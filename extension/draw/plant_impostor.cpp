// SPDX-License-Identifier: MIT
#include "draw/plant_impostor.h"

#include "core/species/plant_views.h"
#include "draw/plant_surfaces.h"
#include "shared/convert.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <array>

using namespace godot;

namespace grass {

namespace {

constexpr std::array<float, 3> ROWS = { 0.0f, 0.5f, 1.0f }; // of the card that turns: it bends with the blade

Ref<Image> to_image(const std::vector<uint8_t> &p_texels) {
	return Image::create_from_data(
			PlantImpostor::TEXELS, PlantImpostor::TEXELS, true, Image::FORMAT_RGBA8, to_bytes(std::span<const uint8_t>(p_texels)));
}

Ref<Texture2DArray> to_layers(const TypedArray<Ref<Image>> &p_images) {
	Ref<Texture2DArray> layers;
	layers.instantiate();
	layers->create_from_images(p_images);
	return layers;
}

// The arrays of a mesh of cards.
struct CardArrays {
	PackedVector3Array places, normals;
	PackedVector2Array uvs;
	PackedFloat32Array kinds; // CUSTOM0
	PackedInt32Array indices;

	void add(const Vector3 &p_place, const Vector2 &p_uv, float p_lies) {
		places.push_back(p_place);
		normals.push_back(Vector3(0, 1, 0));
		uvs.push_back(p_uv);
		for (const float kind : { p_lies, 0.0f, 0.0f }) {
			kinds.push_back(kind);
		}
	}
	void add_quad(int32_t p_first) {
		for (const int32_t corner : { 0, 2, 1, 1, 2, 3 }) {
			indices.push_back(p_first + corner);
		}
	}
};

} // namespace

int64_t PlantImpostor::get_memory_usage() const {
	return int64_t(2) * (GRASS_IMPOSTOR_SIDES + 1) * TEXELS * TEXELS * 4 * 4 / 3;
}

std::shared_ptr<const PlantImpostor> make_impostor(const PlantModel &p_model) {
	const std::vector<PictureSurface> surfaces = picture_surfaces(p_model);
	const float reach = std::max(p_model.reach, 1e-3f);
	TypedArray<Ref<Image>> colors, normals;
	auto impostor = std::make_shared<PlantImpostor>();
	for (const PlantView &view : draw_views(surfaces, reach, GRASS_IMPOSTOR_SIDES, PlantImpostor::TEXELS)) {
		colors.push_back(to_image(view.colors));
		normals.push_back(to_image(view.normals));
		impostor->above = std::clamp(view.depth, 0.0f, 1.0f); // of the last one in the end
	}
	impostor->colors = to_layers(colors);
	impostor->normals = to_layers(normals);
	impostor->reach = reach;
	return impostor;
}

Ref<ArrayMesh> make_impostor_mesh(const PlantImpostor &p_impostor) {
	CardArrays cards;
	const float reach = p_impostor.reach;
	for (const float row : ROWS) {
		for (const float side : { 0.0f, 1.0f }) {
			cards.add(Vector3((2.0f * side - 1.0f) * reach, row, 0), Vector2(side, 1.0f - row), 0.0f);
		}
	}
	for (int32_t row = 0; row + 1 < int32_t(ROWS.size()); row++) {
		cards.add_quad(2 * row);
	}
	const int32_t first = int32_t(cards.places.size());
	for (const float down : { 0.0f, 1.0f }) {
		for (const float side : { 0.0f, 1.0f }) {
			cards.add(Vector3((2.0f * side - 1.0f) * reach, p_impostor.above, (2.0f * down - 1.0f) * reach), Vector2(side, down), 1.0f);
		}
	}
	cards.add_quad(first);
	Array arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_VERTEX] = cards.places;
	arrays[Mesh::ARRAY_NORMAL] = cards.normals;
	arrays[Mesh::ARRAY_TEX_UV] = cards.uvs;
	arrays[Mesh::ARRAY_CUSTOM0] = cards.kinds;
	arrays[Mesh::ARRAY_INDEX] = cards.indices;
	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	const int64_t format = int64_t(Mesh::ARRAY_CUSTOM_RGB_FLOAT) << Mesh::ARRAY_FORMAT_CUSTOM0_SHIFT;
	mesh->add_surface_from_arrays(Mesh::PRIMITIVE_TRIANGLES, arrays, TypedArray<Array>(), Dictionary(), format);
	return mesh;
}

} // namespace grass
