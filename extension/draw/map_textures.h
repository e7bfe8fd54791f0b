// SPDX-License-Identifier: MIT
// A field's map as textures for the blade and ground shaders (shaders/shared/map.inc): a layer a chunk, and a page that
// says which. Only layers that changed travel.
#pragma once

#include "core/map/map_layers.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/texture2d_array.hpp>

#include <functional>

namespace grass {

class MapTextures {
public:
	using SetUniform = std::function<void(const char *p_name, const godot::Variant &p_value)>;

	// Brings the textures to what the layers hold. p_changed: layers that differ from the last call; p_species: whether the field has
	// any, the same until free(). p_set is told of textures that are new.
	void update(const MapLayers &p_layers, const std::vector<int> &p_changed, bool p_species, const SetUniform &p_set);
	int64_t get_uploaded_bytes() const { return _uploaded; } // since made
	int64_t get_memory_usage() const; // bytes
	void free();

private:
	enum Kind { GROWTH, FORM, GROUND, TINT, SPECIES, KINDS };

	godot::Ref<godot::Image> image_of(const MapLayer *p_layer, Kind p_kind) const;

	std::array<godot::Ref<godot::Texture2DArray>, KINDS> _arrays;
	godot::Ref<godot::ImageTexture> _pages;
	std::vector<float> _uploaded_pages;
	int _kinds = 0; // that there are: without SPECIES, one less
	int _room = 0; // layers in the arrays; grows by doubling
	int64_t _uploaded = 0;
};

} // namespace grass
