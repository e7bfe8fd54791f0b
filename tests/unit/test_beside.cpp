// SPDX-License-Identifier: MIT
// Work beside the frames, with threads and without.
#include "core/base/beside.h"

#include <doctest/doctest.h>

#include <chrono>
#include <memory>

using namespace grass;

TEST_CASE("beside: work runs on a thread of its own") {
	const auto here = std::this_thread::get_id();
	CHECK(run_beside<true>([] { return std::this_thread::get_id(); }).get() != here);
}

TEST_CASE("beside: without threads work has ended when it was begun, on the thread that began it") {
	const auto here = std::this_thread::get_id();
	auto owned = std::make_unique<int>(7); // work may own what cannot be copied
	std::future<int> made = run_beside<false>([here, owned = std::move(owned)] { return std::this_thread::get_id() == here ? *owned : 0; });
	CHECK(made.wait_for(std::chrono::seconds(0)) == std::future_status::ready);
	CHECK(made.get() == 7);
	bool has_run = false;
	run_beside<false>([&] { has_run = true; }).get();
	CHECK(has_run);
}

TEST_CASE("beside: at least one thread runs") {
	CHECK(count_processors() >= 1);
}
