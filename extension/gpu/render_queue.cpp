// SPDX-License-Identifier: MIT
#include "gpu/render_queue.h"

#include "gpu/compile_queue.h"
#include "gpu/device.h"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/variant/callable.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

RenderQueue *RenderQueue::_singleton = nullptr;

RenderQueue *RenderQueue::get_singleton() {
	if (_singleton == nullptr) {
		_singleton = memnew(RenderQueue);
	}
	return _singleton;
}

void RenderQueue::free_singleton() {
	if (!CompileQueue::get().is_empty()) { // maybe of no field: passes are compiled before a field is made, and may be refused
		get_singleton()->post([] { CompileQueue::get().free_pipelines(); });
		RenderingServer::get_singleton()->force_sync();
	}
	if (_singleton != nullptr) {
		memdelete(_singleton);
		_singleton = nullptr;
	}
}

void RenderQueue::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_deliver", "data", "ticket"), &RenderQueue::_deliver);
}

void RenderQueue::post(Job p_job) {
	{
		std::lock_guard lock(_mutex);
		_jobs.push_back(std::move(p_job));
	}
	RenderingServer::get_singleton()->call_on_render_thread(callable_mp(this, &RenderQueue::_run));
}

// Runs one job in each call: the calls are in the renderer's queue among its own commands, and no job may run before an earlier command.
void RenderQueue::_run() {
	Job job;
	{
		std::lock_guard lock(_mutex);
		job = std::move(_jobs.front());
		_jobs.pop_front();
	}
	job();
}

void RenderQueue::read_later(const RID &p_buffer, uint32_t p_bytes, Receiver p_receiver) {
	const int64_t ticket = _next_ticket++;
	_receivers[ticket] = std::move(p_receiver);
	// Called by name, so that the engine checks whether this object still exists: it delivers pending reads at its very end.
	main_device()->buffer_get_data_async(p_buffer, Callable(this, "_deliver").bind(ticket), 0, p_bytes);
}

void RenderQueue::_deliver(const PackedByteArray &p_data, int64_t p_ticket) {
	auto found = _receivers.find(p_ticket);
	if (found != _receivers.end()) {
		const Receiver receiver = std::move(found->second);
		_receivers.erase(found);
		receiver(p_data);
	}
}

} // namespace grass
