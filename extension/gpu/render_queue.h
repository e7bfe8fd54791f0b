// SPDX-License-Identifier: MIT
// Passes jobs from the main thread to the render thread, and results back, in both of the engine's thread models: in the default one post()
// runs the job at once; in the separate one the render thread runs it later, in order.
//
// Until a frame ends, the engine keeps what its device is given: commands, uploads, freed buffers, reads. It ends the game when reads take
// more than its staging buffer has (128 MB). A minimised window draws no frames while ticks go on, so this queue bounds all of it. Where no
// frame ends, it has the device carry out a batch of some ticks and waits for it (`UNDRAWN_TICKS`); and reads have a limit of bytes.
#pragma once

#include "shared/frames.h"

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <atomic>
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
	// Reads a buffer without a stall; render thread only. p_receiver runs on the render thread, about two frames later. Returns false, and
	// reads nothing, if the reads under way already take too much: try again in a later batch.
	bool read_later(const godot::RID &p_buffer, uint32_t p_bytes, Receiver p_receiver);
	// Returns the number of the batch, which the device carries out as a whole: a drawn frame, or some ticks without one. Ticks whose
	// results arrive by frame should request them once in each batch. Render thread only.
	uint64_t get_batch() const { return _batch; }
	// Returns how often the device carried out a batch without a frame; any thread.
	int64_t get_undrawn_batches() const { return _undrawn_batches; }

protected:
	static void _bind_methods();

private:
	struct Waiting {
		Job job;
		uint64_t drawn_frame, tick; // the last ones when it was posted
	};
	struct Read {
		Receiver receiver;
		uint32_t bytes;
	};
	void _run();
	void _deliver(const godot::PackedByteArray &p_data, int64_t p_ticket);
	void begin(const Waiting &p_waiting);
	Read take(int64_t p_ticket);
	void carry_out();
	void free_all();

	static RenderQueue *_singleton;
	std::mutex _mutex;
	std::deque<Waiting> _jobs;
	std::atomic<int64_t> _undrawn_batches = 0;
	// Render thread only:
	std::map<int64_t, Read> _reads; // under way, by ticket
	int64_t _next_ticket = 0;
	uint64_t _bytes_under_way = 0;
	uint64_t _drawn_frame = 0, _batch = 0;
	UndrawnTicks _undrawn;
	godot::RID _waited_for; // a buffer of nothing, which carry_out() reads
};

} // namespace grass
