// SPDX-License-Identifier: MIT
// A GrassMap as a field shows it: laid out, and as textures. Another thread may prepare one. It lives as long as the field is built.
#pragma once

#include "core/map/map_layers.h"
#include "draw/map_textures.h"
#include "resources/grass_map.h"

#include <functional>
#include <memory>
#include <optional>

namespace grass {

class ShownMap {
public:
	// Begins without a map, for a field at p_place.
	explicit ShownMap(const MapPlace &p_place) : _layers(p_place), _textures(p_place.has_species) {}
	// Lays out all of p_map at once, on another thread than the frames'. Without p_with_textures the field makes them.
	void prepare(const PaintMap &p_map, bool p_with_textures);
	// Returns what shows p_map on a field from now on: p_prepared, in which only the changes of p_map since then wait to be laid out. If it
	// is null, or was prepared for another field, all of p_map waits.
	static std::unique_ptr<ShownMap> make(
			const godot::Ref<GrassMap> &p_map, const MapPlace &p_place, std::unique_ptr<ShownMap> p_prepared = nullptr);

	~ShownMap();
	ShownMap(const ShownMap &) = delete;
	ShownMap &operator=(const ShownMap &) = delete;

	void touch(const MapRegion &p_region) { _layers.touch(p_region); }
	// Shows the map as p_change would make it, on a copy, instead of the map as it is. The next preview replaces this one.
	void preview(const std::function<BrushResult(PaintMap &)> &p_change);
	bool end_preview(); // returns false if there was none
	bool is_preview() const { return _preview != nullptr; }
	int get_waiting() const { return _layers.get_waiting(); } // chunks
	// Lays the map out chunk by chunk, as long as p_go_on returns true.
	MapLayers::Changes update(const std::function<bool()> &p_go_on);
	// Makes a piece of that, or of the textures, for a map that is not shown yet.
	void work();
	// Returns whether a worker thread makes textures, and nothing else is left to do until they are ready.
	bool is_waiting_for_thread() const { return get_waiting() == 0 && _textures.is_growing() && !_textures.can_work(); }
	bool is_growing() const { return _textures.is_growing(); }
	bool has_new_textures() const { return _textures.are_new(); } // bind() returns something else than the last time
	MapBinding bind() { return _textures.bind(_layers); }
	bool has_work() const { return get_waiting() > 0 || !_textures.are_made(_layers.count_painted(shown())); }

	const MapLayers &get_layers() const { return _layers; }
	const MapTextures &get_textures() const { return _textures; }
	const godot::Ref<GrassMap> &get_map() const { return _map; }
	int64_t get_memory_usage() const { return int64_t(_layers.get_memory_usage()) + _textures.get_memory_usage(); } // bytes

private:
	void show(const godot::Ref<GrassMap> &p_map);
	const PaintMap &shown() const { return _preview ? *_preview : _map->get_map(); }

	godot::Ref<GrassMap> _map; // null until make()
	std::optional<PaintMap> _prepared; // what was laid out until then; shares its texels
	std::unique_ptr<PaintMap> _preview; // null: the map is shown as it is
	MapRegion _previewed; // where the two differ
	MapLayers _layers;
	MapTextures _textures;
};

} // namespace grass
