// SPDX-License-Identifier: MIT
// Runs jobs one after the other in a single task of the engine's worker threads. Jobs may wait for tasks of the engine's own: so the task
// is one of low priority, which never has all threads.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>

namespace grass {

// Its functions belong to the main thread.
class TaskQueue {
public:
	void push(std::function<void()> &&p_job);
	// Between these no job begins; one that runs goes on.
	void hold();
	void release();
	// Forgets what has not begun. Before the game ends: the engine waits for this task then, and a job that begins so late waits for others
	// that no longer run (Godot 4.6).
	void forget();
	// The same, and returns when nothing runs any more.
	void finish();

private:
	static void work(void *p_queue);
	void start();
	void end_task();

	std::mutex _mutex;
	std::deque<std::function<void()>> _jobs; // guarded by _mutex
	bool _is_held = false; // guarded by _mutex
	bool _is_working = false; // the task, or it is queued; guarded by _mutex
	bool _has_begun = false; // the task; guarded by _mutex
	int64_t _task = -1; // of the WorkerThreadPool; -1: none
};

} // namespace grass
