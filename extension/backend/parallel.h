// SPDX-License-Identifier: MIT
// The engine's worker threads as a ParallelFor of the core.
#pragma once

#include <godot_cpp/classes/object.hpp>

#include <functional>

namespace grass {

class Parallel : public godot::Object {
	GDCLASS(Parallel, godot::Object)

public:
	// Calls p_body(i) once for every i below p_count, on the engine's WorkerThreadPool; returns when all are done.
	void run(int p_count, const std::function<void(int)> &p_body);

protected:
	static void _bind_methods() {}

private:
	void _run_one(uint32_t p_index);

	const std::function<void(int)> *_body = nullptr; // of the run under way
};

} // namespace grass
