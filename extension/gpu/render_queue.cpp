// SPDX-License-Identifier: MIT
#include "gpu/render_queue.h"

#include "gpu/compile_queue.h"
#include "gpu/device.h"
#include "shared/main_thread.h"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// Bytes of all reads whose answer has not come. More: the engine's staging buffer (128 MB; a project may set less) gets full, which ends
// the game. Fewer: energies of many fields come later, and tiles go to sleep later.
constexpr uint64_t MOST_BYTES_UNDER_WAY = 16 << 20;
// Jobs that wait for the render thread: those of some hundred fields in a frame. Fewer: the main thread waits although nothing is wrong.
constexpr size_t MOST_JOBS = 4096;

} // namespace

RenderQueue *RenderQueue::_singleton = nullptr;

RenderQueue *RenderQueue::get_singleton() {
	if (_singleton == nullptr) {
		_singleton = memnew(RenderQueue);
	}
	return _singleton;
}

void RenderQueue::free_singleton() {
	if (_singleton != nullptr || !CompileQueue::get().is_empty()) { // maybe of no field: passes are compiled before a field is made
		get_singleton()->post([] { get_singleton()->free_all(); });
		RenderingServer::get_singleton()->force_sync();
	}
	if (_singleton != nullptr) {
		memdelete(_singleton);
		_singleton = nullptr;
	}
}

void RenderQueue::free_all() {
	CompileQueue::get().free_pipelines();
	if (_waited_for.is_valid()) {
		main_device()->free_rid(std::exchange(_waited_for, RID()));
	}
}

void RenderQueue::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_deliver", "data", "ticket"), &RenderQueue::_deliver);
}

void RenderQueue::post(Job p_job) {
	bool is_full = false;
	{
		std::lock_guard lock(_mutex);
		_jobs.push_back({ std::move(p_job), last_drawn_frame, Engine::get_singleton()->get_physics_frames() });
		is_full = _jobs.size() > MOST_JOBS;
	}
	RenderingServer::get_singleton()->call_on_render_thread(callable_mp(this, &RenderQueue::_run));
	if (is_full && is_main_thread()) { // the render thread is another one, and slower: without a frame nothing else holds this one back
		RenderingServer::get_singleton()->force_sync();
	}
}

// Runs one job in each call: the calls are in the renderer's queue among its own commands, and no job may run before an earlier command.
void RenderQueue::_run() {
	Waiting next;
	{
		std::lock_guard lock(_mutex);
		next = std::move(_jobs.front());
		_jobs.pop_front();
	}
	begin(next);
	next.job();
}

// Begins another batch if a frame was drawn since the job before, or if none was for long.
void RenderQueue::begin(const Waiting &p_waiting) {
	if (_drawn_frame != p_waiting.drawn_frame) {
		_drawn_frame = p_waiting.drawn_frame;
		_batch++;
	}
	if (_undrawn.count(p_waiting.drawn_frame, p_waiting.tick) && main_device() != nullptr) {
		carry_out();
		_batch++;
		_undrawn_batches++;
	}
}

// Has the device do all that it was given, and waits for that: the engine does so before it reads a buffer at once. Reads that were asked
// for before are answered then, too. The buffer stays, since the engine draws two frames after something was freed.
void RenderQueue::carry_out() {
	RenderingDevice *device = main_device();
	if (!_waited_for.is_valid()) {
		_waited_for = device->storage_buffer_create(4);
	}
	device->buffer_get_data(_waited_for);
}

bool RenderQueue::read_later(const RID &p_buffer, uint32_t p_bytes, Receiver p_receiver) {
	if (_bytes_under_way + p_bytes > MOST_BYTES_UNDER_WAY) {
		return false;
	}
	const int64_t ticket = _next_ticket++;
	_reads[ticket] = { std::move(p_receiver), p_bytes };
	_bytes_under_way += p_bytes;
	// Called by name, so that the engine checks whether this object still exists: it delivers pending reads at its very end.
	if (main_device()->buffer_get_data_async(p_buffer, Callable(this, "_deliver").bind(ticket), 0, p_bytes) != OK) {
		take(ticket);
		return false;
	}
	return true;
}

RenderQueue::Read RenderQueue::take(int64_t p_ticket) {
	const auto found = _reads.find(p_ticket);
	if (found == _reads.end()) {
		return {};
	}
	Read read = std::move(found->second);
	_reads.erase(found);
	_bytes_under_way -= read.bytes;
	return read;
}

void RenderQueue::_deliver(const PackedByteArray &p_data, int64_t p_ticket) {
	if (const Read read = take(p_ticket); read.receiver) {
		read.receiver(p_data);
	}
}

} // namespace grass
