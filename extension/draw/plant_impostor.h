// SPDX-License-Identifier: MIT
// The impostor of a plant, drawn in place of its mesh at some distance: a card that turns to the eye with pictures of the mesh from all
// sides, and one that lies with a picture from above (shaders/draw/plant.gdshader with GRASS_IMPOSTOR).
#pragma once

#include "core/species/plant_views.h"
#include "draw/plant_model.h"

#include <godot_cpp/classes/texture2d_array.hpp>

#include <atomic>
#include <future>
#include <memory>

#include "species/stages.inc"

namespace grass {

// Its pictures are drawn on a thread, in some hundredths of a second, or in seconds for a mesh of many large faces. Main thread only.
class PlantImpostor {
public:
	static constexpr int TEXELS = 128; // along the side of a picture
	static constexpr int64_t VERTICES = 10;

	struct Pictures {
		godot::Ref<godot::Texture2DArray> colors, normals; // GRASS_IMPOSTOR_SIDES + 1 layers, the last one from above
		float above = 0.0f; // height of what is seen from above, heights
		float aslant = 0.0f; // as in PlantViews
	};

	explicit PlantImpostor(const PlantModel &p_model); // begins to draw
	~PlantImpostor() { _is_stopped = true; } // the future waits for its thread

	bool is_drawn() const;
	const Pictures &get_pictures() const; // waits until they are drawn
	float get_reach() const { return _reach; } // of the plant to each side, heights
	int64_t get_memory_usage() const; // bytes in GPU memory

private:
	float _reach;
	std::atomic<bool> _is_stopped = false; // written here, read by the thread
	mutable std::future<PlantViews> _drawing; // not valid once the textures are made
	mutable Pictures _pictures;
};

// Returns the cards for a MultiMesh; CUSTOM0.x: 1 on the one that lies; y: Pictures.aslant.
godot::Ref<godot::ArrayMesh> make_impostor_mesh(const PlantImpostor &p_impostor);

} // namespace grass
