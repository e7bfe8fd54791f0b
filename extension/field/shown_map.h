// SPDX-License-Identifier: MIT
// A GrassMap as a field shows it: laid out, and as textures. It lives as long as the field is built.
#pragma once

#include "core/map/laid_map.h"
#include "draw/map_textures.h"
#include "resources/grass_map.h"

#include <functional>
#include <memory>

namespace grass {

struct FieldSetup;

// The properties of a field that determine how a map is prepared for it.
struct ShownPlace {
	MapPlace map;
	bool has_species = false;
};

ShownPlace shown_place_of(const FieldSetup &p_setup);

// A map that another thread laid out and turned into textures, for a field that will show it.
struct PreparedMap {
	// Without p_with_textures the field makes them.
	PreparedMap(const PaintMap &p_map, const ShownPlace &p_place, bool p_with_textures);

	LaidMap laid;
	MapTextures textures;
	bool has_species;
};

class ShownMap {
public:
	// If p_prepared is null, or was prepared for another field, the map is laid out from the beginning.
	ShownMap(const godot::Ref<GrassMap> &p_map, const FieldSetup &p_setup, std::unique_ptr<PreparedMap> p_prepared = nullptr);

	~ShownMap() { _map->hide(this); }
	ShownMap(const ShownMap &) = delete;
	ShownMap &operator=(const ShownMap &) = delete;

	void touch(const MapRegion &p_region) { _field.touch(p_region); }
	// Shows the map as p_change would make it, on a copy, instead of the map as it is. The next preview replaces this one.
	void preview(const std::function<BrushResult(PaintMap &)> &p_change);
	bool end_preview(); // returns false if there was none
	bool is_preview() const { return _preview != nullptr; }
	int get_waiting() const { return _field.get_waiting(); } // chunks
	// Lays the map out chunk by chunk, as long as p_go_on returns true.
	FieldMap::Changes update(const std::function<bool()> &p_go_on);
	// Makes a piece of that, or of the textures, for a map that is not shown yet.
	void work();
	// Whether a worker thread makes textures, and nothing else is to be done before they are there.
	bool is_waiting_for_thread() const { return get_waiting() == 0 && _textures.is_growing() && !_textures.can_work(); }
	bool is_growing() const { return _textures.is_growing(); }
	bool has_new_textures() const { return _textures.are_new(); } // set_uniforms() is to be called
	bool has_work() const { return get_waiting() > 0 || !_textures.are_made(_field.count_painted(shown())); }

	const FieldMap &get_field() const { return _field; }
	const MapTextures &get_textures() const { return _textures; }
	const godot::Ref<GrassMap> &get_map() const { return _map; }
	int64_t get_memory_usage() const { return int64_t(_field.get_memory_usage()) + _textures.get_memory_usage(); } // bytes
	// Sets the shaders' uniforms: those that changed, or all of them (p_all), for new materials.
	void set_uniforms(const MapTextures::SetUniform &p_set, bool p_all);

private:
	ShownMap(const godot::Ref<GrassMap> &p_map, std::pair<FieldMap, MapTextures> &&p_begun);
	const PaintMap &shown() const { return _preview ? *_preview : _map->get_map(); }

	godot::Ref<GrassMap> _map;
	std::unique_ptr<PaintMap> _preview; // null: the map is shown as it is
	MapRegion _previewed; // where the two differ
	FieldMap _field;
	MapTextures _textures;
};

} // namespace grass
