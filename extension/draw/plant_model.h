// SPDX-License-Identifier: MIT
// A user's mesh in the form in which plants draw it: vertices in shares of its height, attached to a blade (shaders/draw/plant.gdshader).
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
	// Most vertices of a mesh: each is posed for every plant near a camera.
	static constexpr int64_t VERTICES = 16384;

	struct Surface {
		godot::Array arrays; // of an ArrayMesh
		godot::Color color; // of its material, sRGB
		godot::Ref<godot::Texture2D> texture; // of its material; null: none
		float scissor = 0.0f; // alpha below which nothing is drawn
	};
	// The average side view of a band of the plant, from the root up; all bands have the same height.
	struct Band {
		godot::Color color; // mean, linear
		float width = 1.0f; // relative to the mean of all bands
		float rows = 1.0f; // share of a distant blade's rows up to the band's upper end
	};
	std::vector<Surface> surfaces;
	std::array<Band, GRASS_PLANT_BANDS> bands;
	int64_t vertices = 0, indices = 0;
	float reach = 0.0f; // farthest from the blade, heights
	float area = 0.0f; // area that it covers on average, seen from the side, squared heights
	godot::Color color; // mean, linear

	int64_t get_memory_usage() const; // bytes in GPU memory
};

struct PlantReading {
	std::shared_ptr<const PlantModel> model; // null: it cannot be drawn
	float height = 0.0f; // of the mesh in its own units, drawn or not
	godot::String problem; // the reason, and what to do about it
};

// Reads a mesh as a plant. p_who: begins the message about a texture that cannot be read; far plants then look as if it were white.
PlantReading read_plant(const godot::Ref<godot::Mesh> &p_mesh, const godot::String &p_who);

// Returns the mesh for a MultiMesh; its surfaces have no materials.
godot::Ref<godot::ArrayMesh> make_plant_mesh(const PlantModel &p_model);

} // namespace grass
