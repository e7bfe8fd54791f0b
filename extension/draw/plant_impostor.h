// SPDX-License-Identifier: MIT
// The impostor of a plant, drawn in place of its mesh at some distance: a card that turns to the eye with pictures of the mesh from all
// sides, and one that lies with a picture from above (shaders/draw/plant.gdshader with GRASS_IMPOSTOR).
#pragma once

#include "draw/plant_model.h"

#include <godot_cpp/classes/texture2d_array.hpp>

#include <memory>

#include "species/stages.inc"

namespace grass {

// Immutable once made.
struct PlantImpostor {
	static constexpr int TEXELS = 128; // along the side of a picture
	static constexpr int64_t VERTICES = 10;

	godot::Ref<godot::Texture2DArray> colors, normals; // GRASS_IMPOSTOR_SIDES + 1 layers, the last one from above
	float reach = 0.0f; // of the plant to each side, heights
	float above = 0.0f; // height of what is seen from above, heights

	int64_t get_memory_usage() const; // bytes in GPU memory
};

// Draws the pictures: some hundredths of a second.
std::shared_ptr<const PlantImpostor> make_impostor(const PlantModel &p_model);

// Returns the cards for a MultiMesh; CUSTOM0.x: 1 on the one that lies.
godot::Ref<godot::ArrayMesh> make_impostor_mesh(const PlantImpostor &p_impostor);

} // namespace grass
