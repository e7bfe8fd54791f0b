// SPDX-License-Identifier: MIT
#include "backend/parallel.h"

#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

void Parallel::run(int p_count, const std::function<void(int)> &p_body) {
	if (p_count < 2) { // not worth waking a thread
		for (int i = 0; i < p_count; i++) {
			p_body(i);
		}
		return;
	}
	_body = &p_body;
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	const int64_t group = pool->add_group_task(callable_mp(this, &Parallel::_run_one), p_count, -1, true);
	pool->wait_for_group_task_completion(group);
	_body = nullptr;
}

void Parallel::_run_one(uint32_t p_index) {
	(*_body)(int(p_index));
}

} // namespace grass
