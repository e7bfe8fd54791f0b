// SPDX-License-Identifier: MIT
// Makes a patch on a thread of its own, since that takes a tenth of a second, far longer than a frame.
#pragma once

#include "core/blades/patch.h"

#include <atomic>
#include <future>
#include <memory>

namespace grass {

class PatchMaker {
public:
	PatchMaker() = default;
	PatchMaker(const PatchMaker &) = delete;
	PatchMaker &operator=(const PatchMaker &) = delete;
	~PatchMaker() { stop(); }

	// Begins another patch and abandons the one begun before.
	void start(const PatchParams &p_params);
	bool is_started() const { return _made.valid(); }
	bool is_done() const;
	// Waits for the patch that was begun and returns it. Afterwards none is being made.
	std::shared_ptr<const Patch> take() { return _made.get(); }
	// Abandons the patch that was begun. Returns within microseconds.
	void stop();

private:
	std::atomic<bool> _is_stopped = false; // written here, read by the thread
	std::future<std::shared_ptr<const Patch>> _made;
};

} // namespace grass
