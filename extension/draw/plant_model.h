// SPDX-License-Identifier: MIT
// A user's mesh as plants are drawn by it: its vertices as shares of its height, which hang on a blade (shaders/draw/plant.gdshader).
#pragma once

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/string.hpp>

#include "core/species/species.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace grass {

// Immutable once read.
struct PlantModel {
	// Vertices of a mesh, at most: each is posed for every plant near a camera.
	static constexpr int64_t VERTICES = 16384;

	struct Surface {
		godot::Array arrays; // of an ArrayMesh
		godot::Color color; // of its material, sRGB
		godot::Ref<godot::Texture2D> texture; // likewise; null: none
		float scissor = 0.0f; // alpha below which nothing is drawn
	};
	// What an eye beside it sees of a part of it, from the root up; each is as high.
	struct Band {
		godot::Color color; // mean, linear
		float width = 1.0f; // over the mean of all
		float rows = 1.0f; // share of a far blade's rows up to its upper end
	};
	std::vector<Surface> surfaces;
	std::array<Band, GRASS_PLANT_BANDS> bands;
	int64_t vertices = 0, indices = 0;
	float reach = 0.0f; // farthest from the blade, heights
	float area = 0.0f; // that it covers in the mean, from the side, heights squared
	godot::Color color; // mean, linear

	int64_t get_memory_usage() const; // bytes on the device
};

struct PlantReading {
	std::shared_ptr<const PlantModel> model; // null: it cannot be drawn
	godot::String problem; // why, and what to do
};

// p_who: begins a message about a texture that is not read; far plants are then as if it were white.
PlantReading read_plant(const godot::Ref<godot::Mesh> &p_mesh, const godot::String &p_who);

// The mesh that a MultiMesh draws, its surfaces without materials.
godot::Ref<godot::ArrayMesh> make_plant_mesh(const PlantModel &p_model);

} // namespace grass
