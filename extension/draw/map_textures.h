// SPDX-License-Identifier: MIT
// A field's map as textures for the blade and ground shaders (shaders/map/map.inc): a layer for each chunk, and a page that maps chunks to
// layers. Uploads only layers that changed.
#pragma once

#include "core/map/map_layers.h"
#include "draw/growing_arrays.h"
#include "draw/shared_shader.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/variant/vector2.hpp>

#include <algorithm>

namespace grass {

// What shaders and passes read of a map that a field shows: textures, null where there are none, and the chunk of the first page. Empty:
// no map.
struct MapBinding {
	godot::Ref<godot::Texture2DArray> growth, form, ground, tint, species, ledges;
	godot::Ref<godot::Texture2D> pages;
	godot::Vector2 origin;

	// Sets the shaders' uniforms (shaders/map/map.inc).
	void set_uniforms(const SetUniform &p_set) const;
};

class MapTextures {
public:
	// Begins without layers. p_species: whether the field has any species.
	explicit MapTextures(bool p_species) : _arrays(p_species ? KINDS : int(SPECIES), 4), _ledges(1, 1) {}

	// Makes all textures at once, for a thread other than the main one. p_room: number of layers to expect.
	void make(const MapLayers &p_layers, int p_room);
	// Uploads the layers in p_changed, which differ from the last call. Layers without room become visible once there is room. p_room: as
	// above.
	void update(const MapLayers &p_layers, const std::vector<int> &p_changed, int p_room);
	// Returns whether room is being made. work() does the next piece of that, unless it waits for a thread.
	bool is_growing() const { return _arrays.is_growing() || _ledges.is_growing(); }
	bool can_work() const { return _arrays.can_work() || _ledges.can_work(); }
	void work(const MapLayers &p_layers);
	bool are_made(int p_room) const { return _arrays.get_room() >= std::max(p_room, 1) && !is_growing(); }
	// Returns whether bind() would return something else than before.
	bool are_new() const { return _are_new; }
	MapBinding bind(const MapLayers &p_layers);
	int64_t get_uploaded_bytes() const { return _uploaded + _arrays.get_uploaded_bytes() + _ledges.get_uploaded_bytes(); } // since made
	int64_t get_memory_usage() const; // bytes

private:
	enum Kind { GROWTH, FORM, GROUND, TINT, SPECIES, KINDS };

	static godot::Ref<godot::Image> image_of(const MapLayers &p_layers, int p_kind, int p_layer);
	static GrowingArrays::MakeImage of_layers(const MapLayers &p_layers);
	static GrowingArrays::MakeImage of_ledges(const MapLayers &p_layers);
	void make_room(const MapLayers &p_layers, int p_room, bool p_at_once);
	void update_pages(const MapLayers &p_layers);

	GrowingArrays _arrays; // one for each kind; without SPECIES, one less
	GrowingArrays _ledges; // empty if the map has none
	godot::Ref<godot::ImageTexture> _pages;
	std::vector<float> _uploaded_pages;
	bool _are_new = false;
	int64_t _uploaded = 0; // of pages
};

} // namespace grass
