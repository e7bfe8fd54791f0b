// SPDX-License-Identifier: MIT
#include "core/base/frame_turns.h"

namespace grass {

void FrameTurns::enter_frame(uint64_t p_frame) {
	if (p_frame != _frame) {
		_frame = p_frame;
		_is_given = false;
		std::erase_if(_waiting, [&](const auto &p_entry) { return p_frame - p_entry.second.asked >= FORGOTTEN; });
	}
}

bool FrameTurns::is_next(const void *p_user, const Waiting &p_waiting) const {
	if (_is_given || p_waiting.since == _frame) {
		return false;
	}
	for (const auto &[user, waiting] : _waiting) {
		if (user != p_user && waiting.order < p_waiting.order) {
			return false;
		}
	}
	return true;
}

bool FrameTurns::is_owed(const void *p_user) const {
	for (const auto &[user, waiting] : _waiting) {
		if (user != p_user && is_next(user, waiting)) {
			return true;
		}
	}
	return false;
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
