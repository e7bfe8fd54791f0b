// SPDX-License-Identifier: MIT
// A loop whose calls several threads take one after another, until none is left.
//
// It waits with a mutex and a condition variable, as everything in this library does: where the system has no futex (Windows), a waiting
// std::atomic of GCC 12 misses a notification that comes after it has looked and before it sleeps, and then sleeps for ever.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace grass {

class SharedLoop {
public:
	// p_body must live until finish() returns; it is called once for every index below p_count.
	SharedLoop(int p_count, const std::function<void(int)> &p_body) : _body(p_body), _count(p_count), _left(p_count) {}

	// Makes calls until none is left, on the thread that owns the loop.
	void work() {
		for (int left; (left = _left.fetch_sub(1)) > 0;) {
			_body(_count - left);
		}
	}
	// Does the same on another thread, at any time: once all calls have begun it does not touch the body.
	void help() {
		{
			const std::lock_guard lock(_mutex);
			_helping++; // first, so that finish() waits for this thread
		}
		work();
		const std::lock_guard lock(_mutex);
		if (--_helping == 0) {
			_nobody_helps.notify_all();
		}
	}
	// Returns when all calls have ended. Must be called after work(), when no helper can begin a call any more.
	void finish() {
		std::unique_lock lock(_mutex);
		_nobody_helps.wait(lock, [this] { return _helping == 0; });
	}

private:
	const std::function<void(int)> &_body;
	const int _count;
	std::atomic<int> _left; // calls of the body that have not begun; below 0 once all have
	std::mutex _mutex;
	std::condition_variable _nobody_helps;
	int _helping = 0; // threads in help(); guarded by _mutex
};

} // namespace grass
