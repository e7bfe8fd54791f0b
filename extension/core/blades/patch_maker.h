// SPDX-License-Identifier: MIT
// Makes a patch on its own thread: it needs a tenth of a second, far more than a frame has.
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

	// Begins another patch; gives up the one begun before.
	void start(const PatchParams &p_params);
	bool is_started() const { return _made.valid(); }
	bool is_done() const;
	// Waits for the patch that was begun and returns it. Afterwards none is under way.
	std::shared_ptr<const Patch> take() { return _made.get(); }
	// Gives up what was begun, in microseconds.
	void stop();

private:
	std::atomic<bool> _is_stopped = false; // written here, read by the thread
	std::future<std::shared_ptr<const Patch>> _made;
};

} // namespace grass
