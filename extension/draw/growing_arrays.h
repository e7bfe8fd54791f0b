// SPDX-License-Identifier: MIT
// Texture arrays with the same layers, which grow together. The renderer needs all layers of an array at the moment it makes the array. So
// small arrays are made at once; for larger ones some layers are gathered in each frame, and a worker thread makes the arrays while the old
// ones are shown. Compatibility uploads on the main thread: there each frame makes one array.
#pragma once

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/texture2d_array.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace grass {

class GrowingArrays {
public:
	// Returns the image of a layer; p_layer -1: an empty one.
	using MakeImage = std::function<godot::Ref<godot::Image>(int p_array, int p_layer)>;

	// Begins without layers. p_first_room: the first number of layers, a power of two.
	GrowingArrays(int p_arrays, int p_first_room) : _arrays(size_t(p_arrays)), _first_room(p_first_room) {}
	int get_count() const { return int(_arrays.size()); }

	// Makes room for p_layers, the first p_filled of which exist: at once if that is little work or if p_at_once is true (on another
	// thread); otherwise it only begins, and work() continues.
	void want_room(int p_layers, int p_filled, bool p_at_once, const MakeImage &p_make);
	// Replaces a layer.
	void change(int p_layer, const MakeImage &p_make);
	// Does the next piece of work. p_filled: number of layers that exist now.
	void work(int p_filled, const MakeImage &p_make);
	bool is_growing() const { return _next != nullptr; }
	bool can_work() const; // else a thread is at work, or this frame has made an array

	int get_room() const { return _room; } // number of visible layers
	const godot::Ref<godot::Texture2DArray> &get(int p_array) const { return _arrays[size_t(p_array)]; }
	// Returns the bytes handed to the renderer, without those from a worker thread.
	int64_t get_uploaded_bytes() const { return _uploaded; }
	// Returns whether the arrays were replaced since the last call.
	bool take_new() { return std::exchange(_are_new, false); }

private:
	using Arrays = std::vector<godot::Ref<godot::Texture2DArray>>;
	struct Next; // the arrays being made

	void begin(int p_room);
	void gather(int p_filled, const MakeImage &p_make);
	void upload(const Arrays &p_arrays, int p_layer, const MakeImage &p_make);

	Arrays _arrays;
	int _first_room, _room = 0;
	std::shared_ptr<Next> _next; // null: none
	std::set<int> _stale; // layers that changed since they were gathered
	bool _are_new = false;
	uint64_t _made_in = UINT64_MAX; // frame in which an array was made
	int64_t _uploaded = 0;
};

// Must be called before the engine's worker threads end.
void finish_growing_arrays();

} // namespace grass
