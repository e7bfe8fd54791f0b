// SPDX-License-Identifier: MIT
// Runs jobs one after the other in a single task of the engine's worker threads: several tasks would delay the engine's own. Jobs
// that somebody waits for come first (core/base/wait_list.h).
#pragma once

#include "core/base/wait_list.h"

#include <cstdint>
#include <functional>
#include <mutex>

namespace grass {

// Its functions may be called on any thread, except finish().
class TaskQueue {
public:
	// LOW: jobs may wait for tasks of the engine, since tasks of low priority never have all threads.
	enum class Priority { LOW, HIGH };

	TaskQueue(const char *p_name, Priority p_priority) : _name(p_name), _priority(p_priority) {}

	// Queues a job. p_key: its name for want() and remove().
	void push(const void *p_key, std::function<void()> &&p_job, int p_order = 0, Need p_need = Need::WANTED);
	// Moves a job before those that nobody waits for. Does nothing once it has begun.
	void want(const void *p_key);
	// Removes a job that has not begun. Returns false if it has.
	bool remove(const void *p_key);
	// Let no job begin between these two calls; a running one continues.
	void hold();
	void release();
	// Drops all jobs that have not begun, and returns when none runs any more. Call it when the library is unloaded.
	void finish();

private:
	struct Job {
		const void *key;
		std::function<void()> work;
		bool operator==(const Job &p_other) const { return key == p_other.key; }
	};
	static void work(void *p_queue);
	void start();
	void end_task();

	const char *_name;
	Priority _priority;
	std::mutex _mutex;
	WaitList<Job> _jobs; // guarded by _mutex
	bool _is_held = false; // guarded by _mutex
	bool _is_working = false; // the task, or it is queued; guarded by _mutex
	bool _has_begun = false; // the task; guarded by _mutex
	std::mutex _task_mutex;
	int64_t _task = -1; // of the WorkerThreadPool; -1: none; guarded by _task_mutex
};

} // namespace grass
