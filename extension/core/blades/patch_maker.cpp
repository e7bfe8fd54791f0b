// SPDX-License-Identifier: MIT
#include "core/blades/patch_maker.h"

#include "core/base/beside.h"

#include <chrono>

namespace grass {

void PatchMaker::start(const PatchParams &p_params) {
	stop();
	_is_stopped = false;
	_made = run_beside([this, p_params] { return std::make_shared<const Patch>(generate_patch(p_params, &_is_stopped)); });
}

bool PatchMaker::is_done() const {
	return _made.valid() && _made.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

void PatchMaker::stop() {
	_is_stopped = true;
	_made = {}; // waits for the thread
}

} // namespace grass
