// SPDX-License-Identifier: MIT
// A loop that threads share: no call is lost, and no wait lasts for ever. Where a notification can be missed it takes some hundred to some
// thousand waits, so many loops are run.
#include "core/base/shared_loop.h"
#include "sampled.h"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

using namespace grass;

namespace {

constexpr int CALLS = 16, HELPERS = 2;
constexpr auto STUCK = std::chrono::seconds(60); // without progress, on a busy machine

// Threads that help with one loop after another, as those of the engine's pool do.
class Helpers {
public:
	Helpers() {
		for (int i = 0; i < HELPERS; i++) {
			_threads.emplace_back([this] { work(); });
		}
	}
	~Helpers() {
		post(nullptr);
		for (std::thread &thread : _threads) {
			thread.join();
		}
	}
	// nullptr: ends the threads.
	void post(const std::shared_ptr<SharedLoop> &p_loop) {
		{
			const std::lock_guard lock(_mutex);
			_loop = p_loop;
			_number++;
		}
		_has_posted.notify_all();
	}

private:
	void work() {
		for (int seen = 0;;) {
			std::unique_lock lock(_mutex);
			_has_posted.wait(lock, [&] { return _number != seen; });
			seen = _number;
			const std::shared_ptr<SharedLoop> loop = _loop;
			lock.unlock();
			if (!loop) {
				return;
			}
			loop->help();
		}
	}

	std::mutex _mutex;
	std::condition_variable _has_posted;
	std::shared_ptr<SharedLoop> _loop;
	int _number = 0;
	std::vector<std::thread> _threads;
};

// Ends the program if p_loops stops to count: a thread that waits for ever cannot be ended in another way.
class Watchdog {
public:
	explicit Watchdog(const std::atomic<int> &p_loops) : _thread([this, &p_loops] { watch(p_loops); }) {}
	~Watchdog() {
		{
			const std::lock_guard lock(_mutex);
			_is_ending = true;
		}
		_ends.notify_all();
		_thread.join();
	}

private:
	void watch(const std::atomic<int> &p_loops) {
		std::unique_lock lock(_mutex);
		for (int before = -1; !_ends.wait_for(lock, STUCK, [this] { return _is_ending; });) {
			const int now = p_loops;
			if (now == before) {
				std::fprintf(stderr, "A loop waits for ever, after %d others.\n", now);
				std::abort();
			}
			before = now;
		}
	}

	std::mutex _mutex;
	std::condition_variable _ends;
	bool _is_ending = false;
	std::thread _thread;
};

} // namespace

TEST_CASE("shared loop: hundreds of thousands of loops make each call once, and end") {
	const int count = test::sampled(300'000);
	std::atomic<int> loops = 0, calls = 0;
	const std::function<void(int)> body = [&](int p_i) {
		double x = p_i;
		for (int k = 0; k < 200; k++) { // as long as it takes a helper to wake, so that some loops end while they are helped
			x = x * 1.0000001 + 0.5;
		}
		calls += x > 0.0 ? 1 : 0;
	};
	Helpers helpers;
	Watchdog watchdog(loops);
	for (int i = 0; i < count; i++) {
		const auto loop = std::make_shared<SharedLoop>(CALLS, body);
		helpers.post(loop);
		loop->work();
		loop->finish();
		loops++;
	}
	CHECK(calls == count * CALLS);
}
