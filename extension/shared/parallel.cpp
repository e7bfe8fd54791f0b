// SPDX-License-Identifier: MIT
#include "shared/parallel.h"

#include "core/base/beside.h"
#include "core/base/shared_loop.h"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

using namespace godot;

namespace grass {

namespace {

// A loop whose helpers the engine may still hold. The engine requires a wait for each such group.
struct Posted {
	int64_t group = 0;
	std::shared_ptr<SharedLoop> loop;
};

// Most loops in the engine's queue. More would mean that the engine's threads are busy with other work, and help would come too late.
constexpr size_t MOST_POSTED = 4;
std::mutex posted_mutex;
std::vector<Posted> posted;

// Forgets loops whose helpers have ended. Returns whether there is room for another one.
bool forget_ended() {
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	std::erase_if(posted, [pool](const Posted &p_posted) {
		const bool has_ended = pool->is_group_task_completed(p_posted.group);
		if (has_ended) {
			pool->wait_for_group_task_completion(p_posted.group);
		}
		return has_ended;
	});
	return posted.size() < MOST_POSTED;
}

void help(void *p_loop, uint32_t) {
	static_cast<SharedLoop *>(p_loop)->help();
}

} // namespace

void run_parallel(int p_count, const std::function<void(int)> &p_body) {
	static const int processors = count_processors();
	const auto loop = std::make_shared<SharedLoop>(p_count, p_body);
	const int helpers = std::min(p_count, processors) - 1;
	if (helpers > 0) {
		const std::lock_guard lock(posted_mutex);
		if (forget_ended()) {
			const int64_t group =
					WorkerThreadPool::get_singleton()->add_native_group_task(help, loop.get(), helpers, helpers, true, "GrassField");
			posted.push_back({ group, loop });
		}
	}
	loop->work();
	loop->finish();
}

void finish_parallel() {
	const std::lock_guard lock(posted_mutex);
	for (const Posted &left : posted) {
		WorkerThreadPool::get_singleton()->wait_for_group_task_completion(left.group);
	}
	posted.clear();
}

} // namespace grass
