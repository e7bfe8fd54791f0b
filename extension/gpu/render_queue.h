// SPDX-License-Identifier: MIT
// Passes jobs from the main thread to the render thread, and results back, in both of the engine's thread models: in the default one post()
// runs the job at once; in the separate one the render thread runs it later, in order.
#pragma once

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <deque>
#include <functional>
#include <map>
#include <mutex>

namespace grass {

class RenderQueue : public godot::Object {
	GDCLASS(RenderQueue, godot::Object)

public:
	using Job = std::function<void()>;
	using Receiver = std::function<void(const godot::PackedByteArray &)>;

	// Returns the only queue of the process, which is made on first use and freed when the extension is unloaded.
	static RenderQueue *get_singleton();
	static void free_singleton();

	// Queues a job, on any thread. Capture what the job needs by value or by shared_ptr.
	void post(Job p_job);
	// Reads a buffer without a stall; render thread only. p_receiver runs on the render thread, about two frames later.
	void read_later(const godot::RID &p_buffer, uint32_t p_bytes, Receiver p_receiver);

protected:
	static void _bind_methods();

private:
	void _run();
	void _deliver(const godot::PackedByteArray &p_data, int64_t p_ticket);

	static RenderQueue *_singleton;
	std::mutex _mutex;
	std::deque<Job> _jobs;
	std::map<int64_t, Receiver> _receivers; // render thread only
	int64_t _next_ticket = 0;
};

} // namespace grass
