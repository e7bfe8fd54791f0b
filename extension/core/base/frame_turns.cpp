// SPDX-License-Identifier: MIT
#include "core/base/frame_turns.h"

#include <algorithm>

namespace grass {

void FrameTurns::enter_frame(uint64_t p_frame) {
	if (p_frame != _frame) {
		_frame = p_frame;
		_is_given = false;
		std::erase_if(_waiting, [&](const auto &p_entry) { return p_frame - p_entry.second.asked >= FORGOTTEN; });
	}
}

bool FrameTurns::is_next(const void *p_user, const Waiting &p_waiting) const {
	return !_is_given && p_waiting.since != _frame && std::ranges::none_of(_waiting, [&](const auto &p_entry) {
		return p_entry.first != p_user && p_entry.second.order < p_waiting.order;
	});
}

bool FrameTurns::is_owed(const void *p_user) const {
	return std::ranges::any_of(
			_waiting, [&](const auto &p_entry) { return p_entry.first != p_user && is_next(p_entry.first, p_entry.second); });
}

bool FrameTurns::ask(const void *p_user, bool p_has_room) {
	if (p_has_room) {
		_waiting.erase(p_user);
		return true;
	}
	const auto [found, is_new] = _waiting.try_emplace(p_user, Waiting{ _frame, _frame, _asks });
	_asks += is_new ? 1 : 0;
	found->second.asked = _frame;
	if (!is_next(p_user, found->second)) {
		return false;
	}
	_is_given = true;
	_waiting.erase(found);
	return true;
}

} // namespace grass
