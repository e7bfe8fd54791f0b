// SPDX-License-Identifier: MIT
// The compute pipelines of the process, made when they are first needed and kept: drivers take seconds for one. A worker thread makes them,
// one after the other.
#pragma once

#include <godot_cpp/variant/rid.hpp>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <span>
#include <utility>

namespace grass {

// Render thread only, unless said otherwise.
class Pipelines {
public:
	// What a pipeline is made of.
	struct Code {
		std::span<const uint32_t> spirv;
		const char *name;
		int constant = 0; // value of its specialization constant 0, if it has one
	};
	struct Pipeline {
		enum class State { WAITING, COMPILING, DONE };

		Code code{ {}, nullptr }; // without a name: not begun yet
		godot::RID shader, pipeline; // whose compiles them until they are done; invalid if the driver refuses them
		State state = State::WAITING; // guarded by _mutex
	};

	// Those of the process.
	static Pipelines &get();

	// Begins to make it if nobody has yet.
	Pipeline &find(const Code &p_code);
	// True once it is made, or refused by the driver. p_wait: waits for it, or makes it here.
	bool is_compiled(Pipeline &r_pipeline, bool p_wait);
	// Those that are being made, or wait for that. From any thread.
	int compiling() const { return _compiling; }
	// Frees all, for when the library is unloaded.
	void free();

private:
	void compile(Pipeline &r_pipeline);
	void compile_waiting();

	std::map<std::pair<const uint32_t *, int>, Pipeline> _known; // by their code and constant
	std::atomic<int> _compiling = 0;
	// One task of the WorkerThreadPool compiles one after the other: several would hold up the engine's own tasks, and one that is
	// still queued when the game ends is never run.
	int64_t _task = -1; // -1: none
	std::mutex _mutex;
	std::condition_variable _is_done; // a pipeline
	std::deque<Pipeline *> _waiting; // guarded by _mutex
	bool _is_working = false; // the task; guarded by _mutex
};

} // namespace grass
