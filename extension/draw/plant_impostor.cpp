// SPDX-License-Identifier: MIT
#include "draw/plant_impostor.h"

#include "core/base/beside.h"
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
#include <chrono>
#include <utility>

#include "species/constants.inc"

using namespace godot;

namespace grass {

namespace {

constexpr std::array<float, 3> ROWS = { 0.0f, 0.5f, 1.0f }; // of the card that turns: it bends with the blade
constexpr float MEAN_DROOP = float(0.5 * (GRASS_PLANT_DROOPS_LEAST + GRASS_PLANT_DROOPS_MOST));

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
	float aslant = 0.0f;

	void add(const Vector3 &p_place, const Vector2 &p_uv, float p_lies) {
		places.push_back(p_place);
		normals.push_back(Vector3(0, 1, 0));
		uvs.push_back(p_uv);
		for (const float kind : { p_lies, aslant, 0.0f }) {
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

PlantImpostor::PlantImpostor(const PlantModel &p_model) : _reach(std::max(p_model.reach, 1e-3f)) {
	std::vector<PictureSurface> surfaces = picture_surfaces(p_model);
	for (PictureSurface &surface : surfaces) {
		for (Eigen::Vector3f &place : surface.places) {
			place.y() -= MEAN_DROOP * (place.x() * place.x() + place.z() * place.z());
		}
	}
	_drawing = run_beside(
			[this, surfaces = std::move(surfaces)] { return draw_views(surfaces, _reach, GRASS_IMPOSTOR_SIDES, TEXELS, &_is_stopped); });
}

bool PlantImpostor::is_drawn() const {
	return !_drawing.valid() || _drawing.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

const PlantImpostor::Pictures &PlantImpostor::get_pictures() const {
	if (_drawing.valid()) {
		const PlantViews drawn = _drawing.get();
		TypedArray<Ref<Image>> colors, normals;
		for (const PlantView &view : drawn.views) {
			colors.push_back(to_image(view.colors));
			normals.push_back(to_image(view.normals));
		}
		_pictures = { to_layers(colors), to_layers(normals), std::clamp(drawn.views.back().depth, 0.0f, 1.0f), drawn.aslant };
	}
	return _pictures;
}

Ref<ArrayMesh> make_impostor_mesh(const PlantImpostor &p_impostor) {
	const PlantImpostor::Pictures &pictures = p_impostor.get_pictures();
	CardArrays cards;
	cards.aslant = pictures.aslant;
	const float reach = p_impostor.get_reach();
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
			cards.add(Vector3((2.0f * side - 1.0f) * reach, pictures.above, (2.0f * down - 1.0f) * reach), Vector2(side, down), 1.0f);
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
