// SPDX-License-Identifier: MIT
#include "draw/task_queue.h"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <utility>

using namespace godot;

namespace grass {

void TaskQueue::push(const void *p_key, std::function<void()> &&p_job, int p_order, Need p_need) {
	{
		std::lock_guard lock(_mutex);
		_jobs.add({ p_key, std::move(p_job) }, p_order, p_need);
	}
	start();
}

void TaskQueue::want(const void *p_key) {
	std::lock_guard lock(_mutex);
	_jobs.want({ p_key, {} });
}

bool TaskQueue::remove(const void *p_key) {
	std::lock_guard lock(_mutex);
	return _jobs.remove({ p_key, {} });
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
		if (_is_held || _jobs.is_empty() || std::exchange(_is_working, true)) {
			return;
		}
		_has_begun = false;
	}
	std::lock_guard lock(_task_mutex);
	end_task(); // it has done its work
	_task = WorkerThreadPool::get_singleton()->add_native_task(&TaskQueue::work, this, _priority == Priority::HIGH, _name);
}

void TaskQueue::work(void *p_queue) {
	TaskQueue &queue = *static_cast<TaskQueue *>(p_queue);
	std::unique_lock lock(queue._mutex);
	queue._has_begun = true;
	while (!queue._is_held && !queue._jobs.is_empty()) {
		const Job job = queue._jobs.take();
		lock.unlock();
		job.work();
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

void TaskQueue::finish() {
	bool has_begun;
	{
		std::lock_guard lock(_mutex);
		_jobs.clear();
		has_begun = _has_begun;
	}
	if (has_begun) { // a task that is still queued when the game ends never runs
		std::lock_guard lock(_task_mutex);
		end_task();
	}
}

} // namespace grass
