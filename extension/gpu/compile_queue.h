// SPDX-License-Identifier: MIT
// Compiles compute passes in the background, since drivers take seconds for one, and keeps the pipelines.
#pragma once

#include "core/base/layout.h"
#include "draw/task_queue.h"
#include "gpu/pass_shaders.h"
#include "gpu/spirv_code.h"

#include <godot_cpp/variant/rid.hpp>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace grass {

// The order in which a field needs its passes: those that draw it, those that bend it and that scripts query, then faster variants.
enum class PassOrder { CULL, PLANTS, SIMULATE, GATHER, JOIN, MIX, FREE, STRAINS, EDGES, CROWDS, MANY };

using PassKey = std::tuple<const uint32_t *, int, int>; // of a pipeline: its code, method and tiles

// The parts that a pipeline is made of.
struct PassCode {
	static constexpr int NO_METHOD = -1;

	SpirvCode spirv;
	const char *name;
	PassOrder order;
	int method = NO_METHOD; // value of GRASS_CONSTANT_METHOD, for passes with this constant
	int tiles = GRASS_TILES_ONE; // value of GRASS_CONSTANT_TILES, for passes with this constant
	bool has_stand_in = false; // another pass replaces it if it is refused
	bool own_work = false; // value of GRASS_CONSTANT_OWN_WORK, for passes with a method; the same in the whole process
	std::optional<PassKey> helps = {}; // a pass: where that one is refused, no field uses this one

	PassKey key() const { return { spirv.data(), method, tiles }; }
	bool changes_results() const { return order != PassOrder::MANY; }
	// Returns whether each field on the device needs it, so that no other pass is used once it is refused.
	bool is_everybodys() const { return order == PassOrder::CULL || order == PassOrder::GATHER; }
};

// A singleton, get(). Its functions may be called on any thread, except free_pipelines().
class CompileQueue {
public:
	struct Pipeline {
		explicit Pipeline(const PassCode &p_code) : code(p_code) {}

		PassCode code;
		godot::RID shader, pipeline; // once it is done; invalid if the driver has refused them, or another pass without which it is useless
		std::atomic<bool> is_done = false; // the driver has compiled or refused it

	private:
		friend CompileQueue;
		void make(const godot::RID &p_shader);
	};

	static CompileQueue &get();

	// Returns the pipeline of p_code. The first call queues it for a worker thread, which compiles one pipeline after the other, beginning
	// with those that fields wait for.
	Pipeline &find(const PassCode &p_code, Need p_need = Need::PREPARED);
	// Compiles the pipeline here, unless the worker thread has begun it, and returns when it is done. Use it for passes that compile in
	// milliseconds and cannot wait for the worker, which may be compiling another pass for seconds.
	void finish(Pipeline &r_pipeline);
	// Frees all pipelines; call it on the render thread when the library is unloaded.
	void free_pipelines();
	// Returns true if no pipeline was ever requested.
	bool is_empty();
	// Returns the number of pipelines that are not done yet.
	int count_compiling() const { return _compiling; }
	// Returns true if no pipeline that is not done yet would change a result: only passes for many tiles wait, which compute the same.
	bool is_complete() const { return _deciding == 0; }
	// Return true if the driver has refused the pipeline; any pipeline at all.
	bool is_refused(const PassCode &p_code);
	bool has_refused() const { return _refused_count > 0; }
	// Returns the passes refused since the last call.
	std::vector<PassCode> take_refused();

private:
	void compile(Pipeline &r_pipeline, bool p_is_worker);
	void make(Pipeline &r_pipeline, bool p_is_worker);
	bool is_useless(const PassCode &p_code);

	PassShaders _shaders;
	std::atomic<int> _compiling = 0;
	std::atomic<int> _deciding = 0; // of these, pipelines that change results
	TaskQueue _queue{ "GrassField's compute passes", TaskQueue::Priority::HIGH };
	std::mutex _mutex;
	std::condition_variable _has_compiled;
	std::map<PassKey, Pipeline> _pipelines; // guarded by _mutex
	std::vector<PassCode> _refused; // guarded by _mutex
	std::atomic<size_t> _refused_count = 0;
	size_t _refused_taken = 0; // guarded by _mutex
};

} // namespace grass
