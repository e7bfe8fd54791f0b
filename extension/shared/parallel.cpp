// SPDX-License-Identifier: MIT
#include "shared/parallel.h"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

using namespace godot;

namespace grass {

namespace {

// One call of run_parallel(). A helper that begins after the call has ended finds no work left, and does not touch the body.
class Run {
public:
	Run(int p_count, const std::function<void(int)> &p_body) : _body(p_body), _count(p_count), _left(p_count) {}

	void work() {
		for (int left; (left = _left.fetch_sub(1)) > 0;) {
			_body(_count - left);
		}
	}
	void help() {
		_helping++; // first, so that finish() waits for this thread
		work();
		if (--_helping == 0) {
			_helping.notify_all();
		}
	}
	// Runs after work(), when no helper can begin a call any more.
	void finish() {
		for (int helping; (helping = _helping.load()) > 0;) {
			_helping.wait(helping);
		}
	}

private:
	const std::function<void(int)> &_body;
	const int _count;
	std::atomic<int> _left; // calls of the body that have not begun; below 0 once all have
	std::atomic<int> _helping = 0; // threads in help()
};

// A run whose helpers the engine may still hold. The engine requires a wait for each such group.
struct Posted {
	int64_t group = 0;
	std::shared_ptr<Run> run;
};

// Most runs in the engine's queue. More would mean that the engine's threads are busy with other work, and help would come too late.
constexpr size_t MOST_POSTED = 4;
std::mutex posted_mutex;
std::vector<Posted> posted;

// Forgets runs whose helpers have ended. Returns whether there is room for another run.
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

void help(void *p_run, uint32_t) {
	static_cast<Run *>(p_run)->help();
}

} // namespace

void run_parallel(int p_count, const std::function<void(int)> &p_body) {
	static const int processors = int(std::thread::hardware_concurrency());
	const auto run = std::make_shared<Run>(p_count, p_body);
	const int helpers = std::min(p_count, processors) - 1;
	if (helpers > 0) {
		const std::lock_guard lock(posted_mutex);
		if (forget_ended()) {
			const int64_t group =
					WorkerThreadPool::get_singleton()->add_native_group_task(help, run.get(), helpers, helpers, true, "GrassField");
			posted.push_back({ group, run });
		}
	}
	run->work();
	run->finish();
}

void finish_parallel() {
	const std::lock_guard lock(posted_mutex);
	for (const Posted &left : posted) {
		WorkerThreadPool::get_singleton()->wait_for_group_task_completion(left.group);
	}
	posted.clear();
}

} // namespace grass
