// SPDX-License-Identifier: MIT
#include "draw/quit.h"

#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/classes/time.hpp>
#include <godot_cpp/classes/worker_thread_pool.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// Microseconds that an ending game waits for tasks of low priority. Shorter: it may hang. Longer: the user waits for it to end.
constexpr uint64_t LONGEST_WAIT = 30'000'000;

// Makes all tasks of low priority begin before the game ends. When it ends, the engine wakes its worker threads once. A thread that finds
// no work then, while such tasks still wait for their turn, goes on sleeping, and the engine waits for it for ever (Godot's issue 117064).
// Pipelines are such tasks, and a field causes many. The engine would wait for them anyway.
void begin_all_tasks() {
	WorkerThreadPool *pool = WorkerThreadPool::get_singleton();
	const Time *time = Time::get_singleton();
	const uint64_t begin = time->get_ticks_usec();
	const int64_t last = pool->add_native_task([](void *) {}, nullptr, false, "GrassField's last task");
	while (!pool->is_task_completed(last) && time->get_ticks_usec() - begin < LONGEST_WAIT) {
		OS::get_singleton()->delay_usec(500);
	}
}

} // namespace

void watch_for_quit(Node *p_root) {
	const Callable begin = callable_mp_static(&begin_all_tasks);
	if (RenderingServer::get_singleton()->get_rendering_device() != nullptr && !p_root->is_connected("tree_exiting", begin)) {
		p_root->connect("tree_exiting", begin);
	}
}

} // namespace grass
