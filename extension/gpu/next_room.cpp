// SPDX-License-Identifier: MIT
#include "gpu/next_room.h"

#include "core/base/beside.h"
#include "gpu/render_queue.h"

#include <chrono>
#include <utility>

namespace grass {

bool NextRoom::prepare(int p_slots, const PoolRoom::Kind &p_kind) {
	if (_to_come.valid() && _to_come.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
		_room = _to_come.get();
	}
	if (_room && _room->get_slots() != p_slots) {
		drop();
	}
	if (p_slots > 0 && !_room && !_to_come.valid()) {
		_to_come = run_beside([p_slots, p_kind] { return std::make_shared<PoolRoom>(p_slots, p_kind); });
	}
	return _room != nullptr;
}

std::shared_ptr<PoolRoom> NextRoom::take(int p_slots) {
	return _room && _room->get_slots() == p_slots ? std::exchange(_room, nullptr) : nullptr;
}

void NextRoom::drop() {
	if (_to_come.valid()) {
		RenderQueue::get_singleton()->post(
				[room = std::make_shared<std::future<std::shared_ptr<PoolRoom>>>(std::move(_to_come))] { room->get().reset(); });
	}
	if (_room) {
		RenderQueue::get_singleton()->post([room = std::exchange(_room, nullptr)]() mutable { room.reset(); });
	}
}

} // namespace grass
