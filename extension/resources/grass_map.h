// SPDX-License-Identifier: MIT
// GrassMap: the painted map as a Resource. Exposes core/map to Godot, and notifies listeners of the chunks that changed.
// resources/grass_map_file.h saves it as a separate file; scenes and .res files store it as a property. Beside it are the functions that
// paint it (map_painting.h), exchange it with others (map_exchange.h) and make images of it (channel_images.h).
#pragma once

#include "core/paint/brush.h"
#include "resources/grass_map_snapshot.h"
#include "shared/bind_free.h"
#include "shared/label.h"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace grass {

// Any thread may read and save its contents: readers copy the map, or read it under the lock that changes take. C++ code on the main thread
// reads a map that a field uses without the lock, through get_map(), since only the main thread changes such a map.
class GrassMap : public godot::Resource, public CallsFree<GrassMap> {
	GDCLASS(GrassMap, godot::Resource)

public:
	enum Channel : int64_t {
		CHANNEL_DENSITY = MAP_DENSITY,
		CHANNEL_HEIGHT = MAP_HEIGHT,
		CHANNEL_SPECIES = MAP_SPECIES,
		CHANNEL_TINT = MAP_TINT,
		CHANNEL_LEAN = MAP_LEAN,
		CHANNEL_GROUND = MAP_GROUND,
		CHANNEL_NORMAL = MAP_NORMAL,
		CHANNEL_WEAR = MAP_WEAR,
		CHANNEL_CUT = MAP_CUT,
		CHANNEL_PAINT = MAP_PAINT,
		CHANNEL_WEAR_REST = MAP_WEAR_REST,
		CHANNEL_HOLE = MAP_HOLE,
		CHANNEL_LEDGE = MAP_LEDGE,
	};

	void set_base_density(double p_density);
	double get_base_density() const { return copy().get_base_density(); }
	void set_data(const godot::PackedByteArray &p_data); // content of a .grassmap file
	godot::PackedByteArray get_data() const;

	double sample(Channel p_channel, const godot::Vector2 &p_place, int64_t p_component = 0) const; // x, z from the field's centre, metres
	godot::Ref<GrassMapSnapshot> take_snapshot() const;
	// Restores a snapshot: all of it if p_from is null, otherwise what differs between the two, so that others' changes stay.
	void restore_snapshot(const godot::Ref<GrassMapSnapshot> &p_snapshot, const godot::Ref<GrassMapSnapshot> &p_from = {});
	void clear();
	bool is_empty() const;
	godot::TypedArray<godot::Vector2i> get_chunks() const;
	int64_t get_memory_usage() const; // bytes

	const PaintMap &get_map() const { return _map; }
	PaintMap copy() const; // any thread may call it; costs a pointer for each channel and chunk
	// Must be called when a field starts to use the map, after which changes from other threads are rejected: waits for a thread that is
	// changing it.
	void wait_for_threads() const { std::lock_guard lock(_lock); }
	bool is_readable() const { return _unread.is_empty(); } // otherwise it cannot be changed
	// Registers the area of it that a field shows: changes by others may add chunks only there. Main thread only.
	void show(const void *p_by, const MapRegion &p_region) { _shown[p_by] = p_region; }
	void hide(const void *p_by) { _shown.erase(p_by); }
	std::vector<MapRegion> find_shown() const; // by fields
	// Returns how often its contents were replaced: by a snapshot, data, or clear().
	uint64_t get_replacements() const { return _replacements; }
	// Replaces the map by the content of p_bytes. Returns "", or why that is impossible; then the map stays as it was.
	godot::String read(const godot::PackedByteArray &p_bytes);
	// Applies a brush to the map, and notifies listeners.
	BrushResult apply(const MapShape &p_shape, const Brush &p_brush);
	// Runs p_change on the map, and notifies listeners. p_change returns a BrushResult, or a type derived from it, and must not call a
	// script. Reports an error if the map cannot be changed.
	template <typename F> auto change(F &&p_change) {
		decltype(p_change(_map)) result;
		const godot::String refusal = try_change(p_change, result);
		ERR_FAIL_COND_V_MSG(!refusal.is_empty(), result, refusal);
		return result;
	}
	// Does the same without an error: returns why the map cannot be changed, or "".
	template <typename F, typename R> godot::String try_change(F &&p_change, R &r_result) {
		const GroundGrid before = _map.get_ground_grid();
		godot::String refusal = write([&] { r_result = p_change(_map); });
		if (refusal.is_empty()) {
			tell(r_result, !(_map.get_ground_grid() == before));
		}
		return refusal;
	}
	// Does the same for a change of whole chunks. p_change returns a type with `reason`, "" if it changed something, `changed` and
	// `has_base_changed`. Returns nothing, and reports an error, if the map cannot be changed.
	template <typename F> auto change_chunks(F &&p_change) {
		std::optional<decltype(p_change(_map))> result;
		godot::String refusal = write([&] { result = p_change(_map); });
		ERR_FAIL_COND_V_MSG(!refusal.is_empty(), result, refusal);
		if (result->reason.empty()) {
			tell(result->changed, result->has_base_changed);
		}
		return result;
	}
	godot::String label() const { return label_of(*this); } // for messages

protected:
	static void _bind_methods();

private:
	godot::String find_refusal() const; // why it cannot be changed now; empty: it can be
	// Runs p_write, which changes the map. Returns why the map cannot be changed, or "". Neither may call a script.
	template <typename F> godot::String write(F &&p_write) {
		std::lock_guard lock(_lock);
		godot::String refusal = find_refusal();
		if (refusal.is_empty()) {
			p_write();
		}
		return refusal;
	}
	void replace_by(PaintMap &&p_now);
	void _report_unread(const godot::String &p_reason);
	void tell(const BrushResult &p_result, bool p_has_new_grid); // of its ground, which shows everywhere
	void tell(const std::vector<MapKey> &p_changed, const godot::Rect2 &p_region);
	void tell(const std::vector<MapKey> &p_changed, bool p_has_base_changed); // for whole chunks, or for everywhere
	void tell_of_replacing(const PaintMap &p_before);

	mutable std::mutex _lock; // guards _map and _unread
	PaintMap _map;
	std::map<const void *, MapRegion> _shown; // keyed by what shows it
	uint64_t _replacements = 0;
	godot::PackedByteArray _unread; // data that could not be read; kept, so that saving does not destroy it
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassMap::Channel);
