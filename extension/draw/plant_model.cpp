// SPDX-License-Identifier: MIT
#include "draw/plant_model.h"

#include "core/plants/species.h"

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

constexpr int TEXTURE_STEPS = 32; // places of a texture along each side that its mean colour is taken from

// Linear; alpha: share of the texture that is opaque.
Color mean_of(const Ref<Texture2D> &p_texture, float p_scissor) {
	const Ref<Image> found = p_texture.is_valid() ? p_texture->get_image() : Ref<Image>();
	if (found.is_null() || found->is_empty()) {
		return Color(1, 1, 1, 1);
	}
	const Ref<Image> image = found->duplicate(); // get_image() may hand out the texture's own
	if (image->is_compressed() && image->decompress() != OK) {
		return Color(1, 1, 1, 1);
	}
	Color sum(0, 0, 0, 0);
	for (int y = 0; y < TEXTURE_STEPS; y++) {
		for (int x = 0; x < TEXTURE_STEPS; x++) {
			const Color color =
					image->get_pixel(x * image->get_width() / TEXTURE_STEPS, y * image->get_height() / TEXTURE_STEPS).srgb_to_linear();
			sum += color.a < p_scissor ? Color(0, 0, 0, 0) : Color(color.r, color.g, color.b, 1);
		}
	}
	const float opaque = std::max(float(sum.a), 1.0f);
	return Color(sum.r / opaque, sum.g / opaque, sum.b / opaque, sum.a / float(TEXTURE_STEPS * TEXTURE_STEPS));
}

// What the drawing takes over of a material; vertices keep their colours where it shows them.
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

// Adds a surface; its triangles to the model's area, and to the sum of what they show.
void add_surface(PlantModel &r_model, const Ref<Mesh> &p_mesh, int p_surface, float p_height, Color &r_shown) {
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
	const Color mean = mean_of(surface.texture, surface.scissor), albedo = surface.color.srgb_to_linear();
	for (int64_t i = 0; i + 2 < indices.size(); i += 3) {
		const int64_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
		const float area = float((places[b] - places[a]).cross(places[c] - places[a]).length()) * 0.5f * float(mean.a);
		const Color tint = shows_colors ? colors[a].srgb_to_linear() : Color(1, 1, 1);
		r_shown += albedo * mean * tint * area;
		r_model.area += 0.5f * area; // turned every way, a face shows half of itself
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
	constexpr int64_t VERTEX = 12 + 4 + 8 + 12; // place, normal, UV, colour
	return vertices * VERTEX + indices * (vertices > 65536 ? 4 : 2);
}

PlantReading read_plant(const Ref<Mesh> &p_mesh) {
	const float height = highest_of(p_mesh);
	auto model = std::make_shared<PlantModel>();
	Color shown(0, 0, 0, 0);
	int surfaces = 0;
	int64_t vertices = 0;
	for (int s = 0; s < p_mesh->get_surface_count(); s++) {
		const PackedVector3Array places = p_mesh->surface_get_arrays(s)[Mesh::ARRAY_VERTEX];
		vertices += places.size();
		surfaces += int(!places.is_empty());
	}
	if (vertices == 0) {
		return { nullptr, "it has no vertices. Give it a surface of triangles." };
	}
	if (vertices > PlantModel::VERTICES) {
		return { nullptr, vformat("it has %d vertices, more than %d. Use a simpler mesh.", vertices, PlantModel::VERTICES) };
	}
	if (surfaces > GRASS_PLANT_SURFACES) {
		return { nullptr, vformat("it has %d surfaces, more than %d. Join some.", surfaces, GRASS_PLANT_SURFACES) };
	}
	if (!(height > 0.0f)) {
		return { nullptr, "nothing of it lies above y = 0, where its root is. Move its vertices up." };
	}
	for (int s = 0; s < p_mesh->get_surface_count(); s++) {
		const PackedVector3Array places = p_mesh->surface_get_arrays(s)[Mesh::ARRAY_VERTEX];
		const ArrayMesh *arrays = Object::cast_to<ArrayMesh>(p_mesh.ptr());
		const bool is_triangles = arrays == nullptr || arrays->surface_get_primitive_type(s) == Mesh::PRIMITIVE_TRIANGLES;
		if (!places.is_empty() && is_triangles) {
			add_surface(*model, p_mesh, s, height, shown);
		}
	}
	if (model->indices == 0) {
		return { nullptr, "it has no triangles. Give it a surface of triangles." };
	}
	const float whole = 1.0f / std::max(2.0f * model->area, 1e-9f);
	model->color = Color(shown.r * whole, shown.g * whole, shown.b * whole);
	model->area = std::min(model->area, 2.0f * model->reach); // what stands behind other faces covers no more
	return { model, String() };
}

Ref<ArrayMesh> make_plant_mesh(const PlantModel &p_model) {
	Ref<ArrayMesh> mesh;
	mesh.instantiate();
	// Not four bytes: the Compatibility renderer reads as many channels of a format as it has floats, so their red alone (seen in 4.6).
	const int64_t format = int64_t(Mesh::ARRAY_CUSTOM_RGB_FLOAT) << Mesh::ARRAY_FORMAT_CUSTOM0_SHIFT;
	for (const PlantModel::Surface &surface : p_model.surfaces) {
		mesh->add_surface_from_arrays(Mesh::PRIMITIVE_TRIANGLES, surface.arrays, TypedArray<Array>(), Dictionary(), format);
	}
	return mesh;
}

} // namespace grass
