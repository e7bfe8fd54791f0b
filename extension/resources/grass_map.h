// SPDX-License-Identifier: MIT
// GrassMap: the painted map as a Resource. Exposes core/map to Godot, and notifies listeners of the chunks that changed.
// resources/grass_map_file.h saves it as a separate file; scenes and .res files store it as a property.
#pragma once

#include "core/paint/brush.h"
#include "core/paint/channel_picture.h"
#include "core/paint/lay_ground.h"
#include "resources/grass_brush.h"
#include "resources/grass_fill_rule.h"
#include "shared/label.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <map>
#include <mutex>

namespace grass {

// The whole map at one moment. Costs a pointer for each channel and chunk until one of the two changes.
class GrassMapSnapshot : public godot::RefCounted {
	GDCLASS(GrassMapSnapshot, godot::RefCounted)

public:
	PaintMap map;

protected:
	static void _bind_methods() {}
};

// What is wrong with a picture or with the region that it is for.
struct PictureProblem {
	godot::Error error = godot::OK;
	godot::String text; // a sentence that says what to do
};

// Any thread may read and save its contents: readers copy the map, or read it under the lock that changes take. C++ code on the main thread
// reads a map that a field uses without the lock, through get_map(), since only the main thread changes such a map.
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
	void set_data(const godot::PackedByteArray &p_data); // content of a .grassmap file
	godot::PackedByteArray get_data() const;

	// Places are x, z in metres from the field's centre. These return the amount of the change in the units of BrushResult::amount.
	double stroke(const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to);
	double stroke_within(
			const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to, const MapRegion &p_area);
	// Returns what is wrong with these arguments, as a sentence; empty: nothing.
	static godot::String problem_of_stroke(const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to);
	double sample(Channel p_channel, const godot::Vector2 &p_place, int64_t p_component = 0) const;
	// Sets the ground's shape from heights in metres (red channel) over a rectangle. Returns false if nothing could be read.
	bool set_ground(const godot::Ref<godot::Image> &p_heights, const godot::Rect2 &p_region);
	// Return a channel's texels as an image, and write an image's into it. A region without an area: what was painted in the channel. For
	// files they return an Error.
	godot::Ref<godot::Image> get_channel_image(Channel p_channel, const godot::Rect2 &p_region = {}, bool p_is_float = false) const;
	bool set_channel_image(Channel p_channel, const godot::Ref<godot::Image> &p_image, const godot::Rect2 &p_region = {});
	int64_t save_channel_image(Channel p_channel, const godot::String &p_path, const godot::Rect2 &p_region = {}) const;
	int64_t load_channel_image(Channel p_channel, const godot::String &p_path, const godot::Rect2 &p_region = {});
	// The same, without a message: returns what is wrong.
	PictureProblem write_picture(Channel p_channel, const godot::String &p_path, const godot::Rect2 &p_region) const;
	PictureProblem read_picture(Channel p_channel, const godot::String &p_path, const godot::Rect2 &p_region);
	PictureProblem lay_picture(Channel p_channel, const godot::Ref<godot::Image> &p_image, const godot::Rect2 &p_region);
	// Fills by a rule without nodes; null: returns to the base density. Returns the square metres of full grass gained.
	double fill(const godot::Ref<GrassFillRule> &p_rule, const godot::Rect2 &p_region);
	int64_t save_to_file(const godot::String &p_path) const; // whatever its extension; returns an Error
	godot::Ref<GrassMapSnapshot> take_snapshot() const;
	// p_from: null: restores all of it. Otherwise what differs between the two, so that others' changes stay.
	void restore_snapshot(const godot::Ref<GrassMapSnapshot> &p_snapshot, const godot::Ref<GrassMapSnapshot> &p_from = {});
	// Returns the changes since a snapshot, in order: what a server sends its clients.
	godot::PackedByteArray get_changes_since(const godot::Ref<GrassMapSnapshot> &p_snapshot) const;
	bool apply_changes(const godot::PackedByteArray &p_changes);
	// Brings the changes from a common state to another map into this one. Returns a report; empty: it was refused.
	godot::Dictionary merge(const godot::Ref<GrassMap> &p_base, const godot::Ref<GrassMap> &p_theirs, bool p_prefers_theirs = false);
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
	// Returns how often its contents were replaced: by a snapshot, data, or clear().
	uint64_t get_replacements() const { return _replacements; }
	// Replaces the map by the content of p_bytes. Returns "", or why that is impossible; then the map stays as it was.
	godot::String read(const godot::PackedByteArray &p_bytes);
	// Applies a brush to the map, and notifies listeners.
	BrushResult apply(const MapShape &p_shape, const Brush &p_brush);
	// Runs p_change on the map, and notifies listeners. p_change returns a BrushResult, or a type derived from it.
	template <typename F> auto change(F &&p_change) {
		decltype(p_change(_map)) result;
		const GroundGrid before = _map.get_ground_grid();
		if (write([&] { result = p_change(_map); })) {
			tell(result, !(_map.get_ground_grid() == before));
		}
		return result;
	}

protected:
	static void _bind_methods();

private:
	godot::String find_refusal() const; // why it cannot be changed now; empty: it can be
	// Runs p_write, which changes the map. Returns false, with an error, if the map cannot be changed. Neither may call a script.
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
	bool is_region(const char *p_use, const godot::Rect2 &p_region) const;
	godot::String problem_of_region(const char *p_use, const godot::Rect2 &p_region) const;
	PictureProblem find_rect(Channel p_channel, const godot::Rect2 &p_region, TexelRect &r_rect) const;
	PictureProblem make_picture(Channel p_channel, const godot::Rect2 &p_region, bool p_is_float, godot::Ref<godot::Image> &r_image) const;
	void _report_unread(const godot::String &p_reason);
	void tell(const BrushResult &p_result, bool p_has_new_grid); // of its ground, which shows everywhere
	void tell(const std::vector<MapKey> &p_changed, const godot::Rect2 &p_region);
	void tell(const std::vector<MapKey> &p_changed, bool p_has_base_changed); // for whole chunks, or for everywhere
	void tell_of_replacing(const PaintMap &p_before);
	godot::String label() const { return label_of(*this); } // for messages

	mutable std::mutex _lock; // guards _map and _unread
	PaintMap _map;
	std::map<const void *, MapRegion> _shown; // keyed by what shows it
	uint64_t _replacements = 0;
	godot::PackedByteArray _unread; // data that could not be read; kept, so that saving does not destroy it
};

} // namespace grass

VARIANT_ENUM_CAST(grass::GrassMap::Channel);
