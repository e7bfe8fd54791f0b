// SPDX-License-Identifier: MIT
#include "draw/growing_arrays.h"

#include "draw/task_queue.h"
#include "shared/frames.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <atomic>
#include <bit>

using namespace godot;

namespace grass {

namespace {

// Arrays up to this size are made in one frame, bytes. More: frames stutter. Less: the first layers appear later.
constexpr int64_t MADE_AT_ONCE = 1 << 22;

TaskQueue arrays_queue("GrassField's textures", TaskQueue::Priority::LOW);

// Returns whether other threads may make textures. Compatibility uploads on one thread, whichever calls it. Without a renderer only the
// main thread may use the engine's list of textures (in Godot 4.6 one leaked at exit in some runs).
bool has_texture_threads() {
	return RenderingServer::get_singleton()->get_rendering_device() != nullptr;
}

} // namespace

struct GrowingArrays::Next {
	int room = 0;
	int gathered = 0; // number of layers
	std::vector<TypedArray<Ref<Image>>> images; // of each array
	Arrays arrays;
	std::atomic<bool> is_with_thread = false, is_made = false;

	// Makes one array. Returns its bytes.
	int64_t make_one() {
		TypedArray<Ref<Image>> list = std::exchange(images[arrays.size()], {});
		const int64_t bytes = list.size() * Ref<Image>(list[0])->get_data_size();
		arrays.emplace_back().instantiate();
		arrays.back()->create_from_images(list);
		is_made = arrays.size() == images.size();
		return bytes;
	}
	int64_t make() {
		int64_t bytes = 0;
		while (!is_made) {
			bytes += make_one();
		}
		return bytes;
	}
};

void GrowingArrays::begin(int p_room) {
	_next = std::make_shared<Next>();
	_next->room = p_room;
	_next->images.resize(_arrays.size());
	_stale.clear();
}

void GrowingArrays::want_room(int p_layers, int p_filled, bool p_at_once, const MakeImage &p_make) {
	if ((_room > 0 && p_layers <= _room) || _next) {
		return;
	}
	begin(std::max(_first_room, int(std::bit_ceil(unsigned(p_layers)))));
	int64_t bytes = 0;
	for (size_t array = 0; array < _arrays.size(); array++) {
		bytes += _next->room * p_make(int(array), -1)->get_data_size();
	}
	if (p_at_once || bytes <= MADE_AT_ONCE) {
		while (_next->gathered < _next->room) {
			gather(p_filled, p_make);
		}
		_uploaded += _next->make();
		work(p_filled, p_make);
	}
}

// Gathers one layer of each array, or all of the empty ones.
void GrowingArrays::gather(int p_filled, const MakeImage &p_make) {
	const bool is_filled = _next->gathered < p_filled;
	const int end = is_filled ? _next->gathered + 1 : _next->room;
	for (size_t array = 0; array < _arrays.size(); array++) {
		const Ref<Image> image = p_make(int(array), is_filled ? _next->gathered : -1);
		for (int layer = _next->gathered; layer < end; layer++) {
			_next->images[array].push_back(image);
		}
	}
	_next->gathered = end;
}

bool GrowingArrays::can_work() const {
	return _next && (_next->is_made || !_next->is_with_thread) && Engine::get_singleton()->get_process_frames() != _made_in;
}

void GrowingArrays::work(int p_filled, const MakeImage &p_make) {
	if (!can_work()) {
		return;
	}
	if (_next->gathered < _next->room) {
		gather(p_filled, p_make);
	} else if (!_next->is_made && has_texture_threads()) {
		_next->is_with_thread = true;
		arrays_queue.push(_next.get(), [next = _next] { next->make(); });
	} else if (!_next->is_made) {
		_uploaded += _next->make_one();
		_made_in = draws_frames() ? Engine::get_singleton()->get_process_frames() : UINT64_MAX;
	} else if (!_stale.empty()) {
		const int layer = *_stale.begin();
		_stale.erase(_stale.begin());
		upload(_next->arrays, layer, p_make);
	} else {
		_arrays = std::move(_next->arrays);
		_room = _next->room;
		_next.reset();
		_are_new = true;
	}
}

void GrowingArrays::upload(const Arrays &p_arrays, int p_layer, const MakeImage &p_make) {
	for (size_t array = 0; array < p_arrays.size(); array++) {
		const Ref<Image> image = p_make(int(array), p_layer);
		p_arrays[array]->update_layer(image, p_layer);
		_uploaded += image->get_data_size();
	}
}

void GrowingArrays::change(int p_layer, const MakeImage &p_make) {
	if (p_layer < _room) {
		upload(_arrays, p_layer, p_make);
	}
	if (_next && p_layer < std::min(_next->gathered, _next->room)) {
		_stale.insert(p_layer);
	}
}

void finish_growing_arrays() {
	arrays_queue.finish();
}

} // namespace grass
