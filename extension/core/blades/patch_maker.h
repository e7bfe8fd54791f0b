// SPDX-License-Identifier: MIT
// Makes a patch on a thread of its own: it takes a tenth of a second, which no frame has.
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

	// Begins with another patch; what was begun before is given up.
	void start(const PatchParams &p_params);
	bool is_started() const { return _made.valid(); }
	bool is_done() const;
	// What was begun. Waits for it; then nothing is begun any more.
	std::shared_ptr<const Patch> take() { return _made.get(); }
	// Gives up what was begun, in microseconds.
	void stop();

private:
	std::atomic<bool> _is_stopped = false; // written here, read by the thread
	std::future<std::shared_ptr<const Patch>> _made;
};

} // namespace grass
