// SPDX-License-Identifier: MIT
// GrassMap: the painted map as a Resource. Exposes core/map to Godot, and notifies listeners of the chunks that
// changed. Saved by resources/grass_map_file.h in a file of its own, or as a property within scenes and .res files.
#pragma once

#include "core/paint/brush.h"
#include "core/paint/lay_ground.h"
#include "resources/grass_brush.h"
#include "resources/grass_fill_rule.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <map>
#include <mutex>

namespace grass {

// The whole map as it was at one moment. Costs a pointer a channel and chunk until one of the two changes.
class GrassMapSnapshot : public godot::RefCounted {
	GDCLASS(GrassMapSnapshot, godot::RefCounted)

public:
	PaintMap map;

protected:
	static void _bind_methods() {}
};

// What it holds may be read, and saved, on any thread: those that only read copy it, or read it under the lock that changes take. C++ on
// the main thread reads a map that a field uses without the lock, by get_map(): there only the main thread changes it.
class GrassMap : public godot::Resource {
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
	void set_data(const godot::PackedByteArray &p_data); // what a .grassmap file holds
	godot::PackedByteArray get_data() const;

	// Places are x, z in metres from the field's centre. What changed, in the units of BrushResult::amount.
	double stroke(const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to);
	double stroke_within(
			const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to, const MapRegion &p_area);
	// What is wrong with these arguments, as a sentence; empty: nothing.
	static godot::String problem_of_stroke(const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to);
	double sample(Channel p_channel, const godot::Vector2 &p_place, int64_t p_component = 0) const;
	// The ground's shape, from heights in metres (red channel) over a rectangle of places; false if nothing could be read.
	bool set_ground(const godot::Ref<godot::Image> &p_heights, const godot::Rect2 &p_region);
	// Fills by a rule without nodes; null: back to the base density. Returns the square metres of full grass gained.
	double fill(const godot::Ref<GrassFillRule> &p_rule, const godot::Rect2 &p_region);
	godot::Ref<GrassMapSnapshot> take_snapshot() const;
	void restore_snapshot(const godot::Ref<GrassMapSnapshot> &p_snapshot);
	// What a server sends its clients: the changes since a snapshot, in order.
	godot::PackedByteArray get_changes_since(const godot::Ref<GrassMapSnapshot> &p_snapshot) const;
	bool apply_changes(const godot::PackedByteArray &p_changes);
	void clear();
	bool is_empty() const;
	godot::TypedArray<godot::Vector2i> get_chunks() const;
	int64_t get_memory_usage() const; // bytes

	const PaintMap &get_map() const { return _map; }
	PaintMap copy() const; // on any thread: a pointer a channel and chunk
	// A field uses it from now on, so that other threads are refused: waits for one that is changing it.
	void wait_for_threads() const { std::lock_guard lock(_lock); }
	bool is_readable() const { return _unread.is_empty(); } // else nothing can be changed
	// A field shows so much of it: others' changes may add chunks only there. Main thread only.
	void show(const void *p_by, const MapRegion &p_region) { _shown[p_by] = p_region; }
	void hide(const void *p_by) { _shown.erase(p_by); }
	// How often its contents were replaced: a snapshot, data, clear().
	uint64_t get_replacements() const { return _replacements; }
	// Replaces the map by what the bytes hold. Returns "", or why it could not and left the map as it was.
	godot::String read(const godot::PackedByteArray &p_bytes);
	// Runs it on the map, and notifies listeners.
	BrushResult apply(const MapShape &p_shape, const Brush &p_brush);
	// Runs p_change on the map, and notifies listeners. p_change returns a BrushResult, or a type derived from it.
	template <typename F> auto change(F &&p_change) {
		decltype(p_change(_map)) result;
		if (write([&] { result = p_change(_map); })) {
			tell(result);
		}
		return result;
	}

protected:
	static void _bind_methods();

private:
	godot::String find_refusal() const; // why it cannot be changed now; empty: it can
	// Runs p_write, which changes it. False, with an error, where it cannot be changed. Neither calls anything of a script.
	template <typename F> bool write(F &&p_write) {
		godot::String refusal;
		{
			std::lock_guard lock(_lock);
			refusal = find_refusal();
			if (refusal.is_empty()) {
				p_write();
			}
		}
		ERR_FAIL_COND_V_MSG(!refusal.is_empty(), false, refusal);
		return true;
	}
	void replace_by(PaintMap &&p_now);
	bool is_region(const char *p_method, const godot::Rect2 &p_region) const;
	void _report_unread(const godot::String &p_reason);
	void tell(const BrushResult &p_result);
	void tell(const std::vector<MapKey> &p_changed, const godot::Rect2 &p_region);
	void tell(const std::vector<MapKey> &p_changed); // of whole chunks
	void tell_of_replacing(const PaintMap &p_before);
	void tell_everywhere(const std::vector<MapKey> &p_changed); // of the base density, too
	godot::String label() const; // for messages

	mutable std::mutex _lock; // of _map and _unread
	PaintMap _map;
	std::map<const void *, MapRegion> _shown; // by what shows it
	uint64_t _replacements = 0;
	godot::PackedByteArray _unread; // data that could not be read: kept, so that saving does not destroy it
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassMap::Channel);
