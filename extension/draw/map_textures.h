// SPDX-License-Identifier: MIT
// A field's map as textures for the blade and ground shaders (shaders/map/map.inc): a layer for each chunk, and a page
// that maps chunks to layers. Only layers that changed are uploaded.
#pragma once

#include "core/map/map_layers.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/texture2d_array.hpp>

#include <functional>

namespace grass {

class MapTextures {
public:
	using SetUniform = std::function<void(const char *p_name, const godot::Variant &p_value)>;

	// p_species: whether the field has any.
	explicit MapTextures(bool p_species) : _kinds(p_species ? KINDS : int(SPECIES)) {}

	// Makes the next of the textures, with room for p_room layers. False: all are made.
	bool make_one(const MapLayers &p_layers, int p_room);
	bool are_made(int p_room) const; // nothing is left for make_one()
	// Uploads the layers in p_changed, which differ from the last call.
	void update(const MapLayers &p_layers, const std::vector<int> &p_changed);
	// Whether set_uniforms() would change a uniform.
	bool are_new() const { return _are_new; }
	void set_uniforms(const MapLayers &p_layers, const SetUniform &p_set);
	// Releases the textures of the last set_uniforms().
	static void clear_uniforms(const SetUniform &p_set);
	int64_t get_uploaded_bytes() const { return _uploaded; } // since made
	int64_t get_memory_usage() const; // bytes

private:
	enum Kind { GROWTH, FORM, GROUND, TINT, SPECIES, KINDS };

	void update_ledges(const MapLayers &p_layers, const std::vector<int> &p_changed);
	void update_pages(const MapLayers &p_layers);

	godot::Ref<godot::Image> image_of(const MapLayer *p_layer, Kind p_kind) const;
	void make_room(int p_layers);
	void make(const MapLayers &p_layers, Kind p_kind);

	std::array<godot::Ref<godot::Texture2DArray>, KINDS> _arrays;
	godot::Ref<godot::Texture2DArray> _ledges; // null: the map has none
	int _ledge_room = 0; // layers in it; grows by doubling
	godot::Ref<godot::ImageTexture> _pages;
	std::vector<float> _uploaded_pages;
	int _kinds; // that there are: without SPECIES, one less
	int _room = 0; // layers in the arrays; grows by doubling
	bool _are_new = false;
	int64_t _uploaded = 0;
};

} // namespace grass
