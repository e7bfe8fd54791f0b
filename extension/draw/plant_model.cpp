// SPDX-License-Identifier: MIT
#include "draw/plant_model.h"

#include "shared/picture.h"

#include <godot_cpp/classes/base_material3d.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/packed_color_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace grass {

namespace {

constexpr int FACE_STEPS = 4; // parts of a triangle's side; each part counts by its centre
// Share of a distant blade's rows that are placed where the plant is wide. 0: a flower becomes a streak down its stem; 1: a thin stem has
// no rows.
constexpr float WIDE_ROWS = 0.85f;
constexpr int TEXTURE_STEPS = 32; // places along each side of a texture at which its mean colour is sampled

// Returns the mean colour of a texture, linear; alpha: the share of it that is opaque.
Color mean_of(const Ref<Texture2D> &p_texture, float p_scissor, const String &p_who) {
	String problem;
	const Ref<Image> image = read_picture(p_texture.is_valid() ? p_texture->get_image() : Ref<Image>(), problem);
	if (!problem.is_empty()) {
		WARN_PRINT(vformat("%s: far plants are drawn as if they were white, since an albedo texture %s", p_who, problem));
	}
	return image.is_valid() ? mean_color(image, TEXTURE_STEPS, p_scissor) : Color(1, 1, 1, 1);
}

// Reads what drawing takes from a material. Returns whether it shows vertex colours.
bool read_material(const Ref<Material> &p_material, PlantModel::Surface &r_surface) {
	r_surface.color = Color(1, 1, 1);
	const BaseMaterial3D *material = Object::cast_to<BaseMaterial3D>(p_material.ptr());
	if (material == nullptr) {
		return true;
	}
	r_surface.color = material->get_albedo();
	r_surface.texture = material->get_texture(BaseMaterial3D::TEXTURE_ALBEDO);
	const BaseMaterial3D::Transparency transparency = material->get_transparency();
	r_surface.scissor = transparency == BaseMaterial3D::TRANSPARENCY_DISABLED ? 0.0f
			: transparency == BaseMaterial3D::TRANSPARENCY_ALPHA_SCISSOR      ? float(material->get_alpha_scissor_threshold())
																			  : 0.5f;
	return material->get_flag(BaseMaterial3D::FLAG_ALBEDO_FROM_VERTEX_COLOR);
}

float highest_of(const Ref<Mesh> &p_mesh) {
	const AABB bounds = p_mesh->get_aabb();
	return float(bounds.position.y + bounds.size.y);
}

// What the triangles of a plant show, and how much of it, in bands from the root up. Areas in squared heights.
struct BandSums {
	std::array<Color, GRASS_PLANT_BANDS> colors; // times area
	std::array<float, GRASS_PLANT_BANDS> areas, reaches; // reaches: farthest from the blade

	BandSums() {
		colors.fill(Color(0, 0, 0, 0));
		areas.fill(0.0f);
		reaches.fill(0.0f);
	}

	// Adds a triangle. p_places: its corners, in heights; p_colors: their colours, linear.
	void add(const Vector3 (&p_places)[3], const Color (&p_colors)[3], float p_area) {
		const float part = p_area / float(FACE_STEPS * FACE_STEPS);
		for (int i = 0; i < FACE_STEPS; i++) {
			for (int j = 0; j < 2 * (FACE_STEPS - i) - 1; j++) { // upright parts and those between them
				const int column = j / 2;
				const float third = j % 2 == 0 ? 1.0f / 3.0f : 2.0f / 3.0f;
				const float b = (float(i) + third) / FACE_STEPS, c = (float(column) + third) / FACE_STEPS, a = 1.0f - b - c;
				const Vector3 place = p_places[0] * a + p_places[1] * b + p_places[2] * c;
				const size_t band = size_t(std::clamp(int(place.y * GRASS_PLANT_BANDS), 0, GRASS_PLANT_BANDS - 1));
				areas[band] += part;
				reaches[band] = std::max(reaches[band], float(std::hypot(place.x, place.z)));
				colors[band] += (p_colors[0] * a + p_colors[1] * b + p_colors[2] * c) * part;
			}
		}
	}
};

// Derives the model's colours and area from what all of its triangles show.
void find_looks(PlantModel &r_model, const BandSums &p_shown) {
	Color sum(0, 0, 0, 0);
	float area = 0.0f;
	for (size_t k = 0; k < p_shown.areas.size(); k++) {
		sum += p_shown.colors[k];
		area += p_shown.areas[k];
	}
	const auto mean_of = [](const Color &p_sum, float p_area) { return Color(p_sum.r / p_area, p_sum.g / p_area, p_sum.b / p_area); };
	const float whole = std::max(area, 1e-9f);
	r_model.color = mean_of(sum, whole);
	// Averaged over all directions, a face shows half of its area; faces behind others do not add to what is covered.
	r_model.area = std::min(0.5f * area, 2.0f * r_model.reach);
	for (size_t k = 0; k < p_shown.areas.size(); k++) {
		const float own = p_shown.areas[k], widest = 2.0f * p_shown.reaches[k] / std::max(r_model.area, 1e-9f);
		const float width = std::min(own / whole * GRASS_PLANT_BANDS, widest);
		r_model.bands[k] = { own > 1e-4f * whole ? mean_of(p_shown.colors[k], own) : r_model.color, width };
	}
	float squares = 0.0f, rows = 0.0f;
	for (const PlantModel::Band &band : r_model.bands) {
		squares += band.width * band.width;
	}
	for (PlantModel::Band &band : r_model.bands) {
		const float even = 1.0f / GRASS_PLANT_BANDS, wide = band.width * band.width / std::max(squares, 1e-9f);
		rows += even + (wide - even) * WIDE_ROWS;
		band.rows = rows;
	}
}

// Adds a surface, and its triangles to what is shown.
void add_surface(PlantModel &r_model, const Ref<Mesh> &p_mesh, int p_surface, float p_height, BandSums &r_shown, const String &p_who) {
	const Array from = p_mesh->surface_get_arrays(p_surface);
	PackedVector3Array places = from[Mesh::ARRAY_VERTEX];
	const PackedColorArray colors = from[Mesh::ARRAY_COLOR];
	PackedInt32Array indices = from[Mesh::ARRAY_INDEX];
	PackedVector3Array normals = from[Mesh::ARRAY_NORMAL];
	PackedVector2Array uvs = from[Mesh::ARRAY_TEX_UV];
	PlantModel::Surface surface;
	const bool shows_colors = read_material(p_mesh->surface_get_material(p_surface), surface) && colors.size() == places.size();
	PackedFloat32Array tints;
	tints.resize(places.size() * 3);
	const bool has_normals = normals.size() == places.size();
	normals.resize(places.size());
	uvs.resize(places.size());
	for (int64_t i = 0; i < places.size(); i++) {
		const Vector3 place = places[i] / p_height;
		places.set(i, place);
		r_model.reach = std::max({ r_model.reach, float(std::hypot(place.x, place.z)), -float(place.y) });
		normals.set(i, has_normals ? normals[i] : Vector3(0, 1, 0));
		const Color tint = shows_colors ? colors[i] : Color(1, 1, 1);
		const float channels[3] = { float(tint.r), float(tint.g), float(tint.b) };
		for (int64_t c = 0; c < 3; c++) {
			tints.set(3 * i + c, std::clamp(channels[c], 0.0f, 1.0f));
		}
	}
	if (indices.is_empty()) {
		indices.resize(places.size());
		for (int64_t i = 0; i < indices.size(); i++) {
			indices.set(i, int32_t(i));
		}
	}
	const Color mean = mean_of(surface.texture, surface.scissor, p_who), albedo = surface.color.srgb_to_linear();
	for (int64_t i = 0; i + 2 < indices.size(); i += 3) {
		const int64_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
		const float area = float((places[b] - places[a]).cross(places[c] - places[a]).length()) * 0.5f * float(mean.a);
		const auto color_of = [&](int64_t p_vertex) {
			return albedo * mean * (shows_colors ? colors[p_vertex].srgb_to_linear() : Color(1, 1, 1));
		};
		r_shown.add({ places[a], places[b], places[c] }, { color_of(a), color_of(b), color_of(c) }, area);
	}
	r_model.vertices += places.size();
	r_model.indices += indices.size();
	surface.arrays.resize(Mesh::ARRAY_MAX);
	surface.arrays[Mesh::ARRAY_VERTEX] = places;
	surface.arrays[Mesh::ARRAY_NORMAL] = normals;
	surface.arrays[Mesh::ARRAY_TEX_UV] = uvs;
	surface.arrays[Mesh::ARRAY_CUSTOM0] = tints;
	surface.arrays[Mesh::ARRAY_INDEX] = indices;
	r_model.surfaces.push_back(surface);
}

} // namespace

int64_t PlantModel::get_memory_usage() const {
	constexpr int64_t VERTEX = 12 + 4 + 8 + 12; // position, normal, UV, colour
	return vertices * VERTEX + indices * (vertices > 65536 ? 4 : 2);
}

PlantReading read_plant(const Ref<Mesh> &p_mesh, const String &p_who) {
	const float height = highest_of(p_mesh);
	auto model = std::make_shared<PlantModel>();
	BandSums shown;
	int surfaces = 0;
	int64_t vertices = 0;
	for (int s = 0; s < p_mesh->get_surface_count(); s++) {
		const PackedVector3Array places = p_mesh->surface_get_arrays(s)[Mesh::ARRAY_VERTEX];
		vertices += places.size();
		surfaces += int(!places.is_empty());
	}
	if (p_mesh->is_class("PlaceholderMesh")) {
		return { nullptr, height, "this export has stripped it (*Strip Visuals*). A server draws nothing, so all else is as with it." };
	}
	if (vertices == 0) {
		return { nullptr, height, "it has no vertices. Give it a surface of triangles." };
	}
	if (vertices > PlantModel::VERTICES) {
		return { nullptr, height, vformat("it has %d vertices, more than %d. Use a simpler mesh.", vertices, PlantModel::VERTICES) };
	}
	if (surfaces > GRASS_PLANT_SURFACES) {
		return { nullptr, height, vformat("it has %d surfaces, more than %d. Join some of them.", surfaces, GRASS_PLANT_SURFACES) };
	}
	if (!(height > 0.0f)) {
		return { nullptr, height, "no part of it is above y = 0, where its root is. Move its vertices up." };
	}
	for (int s = 0; s < p_mesh->get_surface_count(); s++) {
		const PackedVector3Array places = p_mesh->surface_get_arrays(s)[Mesh::ARRAY_VERTEX];
		const ArrayMesh *arrays = Object::cast_to<ArrayMesh>(p_mesh.ptr());
		const bool is_triangles = arrays == nullptr || arrays->surface_get_primitive_type(s) == Mesh::PRIMITIVE_TRIANGLES;
		if (!places.is_empty() && is_triangles) {
			add_surface(*model, p_mesh, s, height, shown, p_who);
		}
	}
	if (model->indices == 0) {
		return { nullptr, height, "it has no triangles. Give it a surface of triangles." };
	}
	find_looks(*model, shown);
	return { model, height, String() };
}

Ref<ArrayMesh> make_plant_mesh(const PlantModel &p_model) {
	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	// Not four bytes: the Compatibility renderer reads as many channels as the format has floats, so only their red (seen in 4.6).
	const int64_t format = int64_t(Mesh::ARRAY_CUSTOM_RGB_FLOAT) << Mesh::ARRAY_FORMAT_CUSTOM0_SHIFT;
	for (const PlantModel::Surface &surface : p_model.surfaces) {
		mesh->add_surface_from_arrays(Mesh::PRIMITIVE_TRIANGLES, surface.arrays, TypedArray<Array>(), Dictionary(), format);
	}
	return mesh;
}

} // namespace grass
