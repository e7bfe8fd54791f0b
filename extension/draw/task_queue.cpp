// SPDX-License-Identifier: MIT
#include "draw/task_queue.h"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <utility>

using namespace godot;

namespace grass {

void TaskQueue::push(std::function<void()> &&p_job) {
	{
		std::lock_guard lock(_mutex);
		_jobs.push_back(std::move(p_job));
	}
	start();
}

void TaskQueue::hold() {
	std::lock_guard lock(_mutex);
	_is_held = true;
}

void TaskQueue::release() {
	{
		std::lock_guard lock(_mutex);
		_is_held = false;
	}
	start();
}

void TaskQueue::start() {
	{
		std::lock_guard lock(_mutex);
		if (_is_held || _jobs.empty() || std::exchange(_is_working, true)) {
			return;
		}
		_has_begun = false;
	}
	end_task(); // it has done its work
	_task = WorkerThreadPool::get_singleton()->add_native_task(&TaskQueue::work, this, false, "GrassField's shaders");
}

void TaskQueue::work(void *p_queue) {
	TaskQueue &queue = *static_cast<TaskQueue *>(p_queue);
	std::unique_lock lock(queue._mutex);
	queue._has_begun = true;
	while (!queue._is_held && !queue._jobs.empty()) {
		const std::function<void()> job = std::move(queue._jobs.front());
		queue._jobs.pop_front();
		lock.unlock();
		job();
		lock.lock();
	}
	queue._is_working = false;
}

void TaskQueue::end_task() {
	if (_task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(_task);
		_task = -1;
	}
}

void TaskQueue::forget() {
	std::lock_guard lock(_mutex);
	_jobs.clear();
}

void TaskQueue::finish() {
	bool has_begun;
	{
		std::lock_guard lock(_mutex);
		_jobs.clear();
		has_begun = _has_begun;
	}
	if (has_begun) { // a task that is still queued when the game ends never runs
		end_task();
	}
}

} // namespace grass
