// SPDX-License-Identifier: MIT
#include "core/tiles/pool_budget.h"

#include <algorithm>

namespace grass {

namespace {

// Gives each field what it wants, or where that is more than there is, the same number to all that want more. Takes it from r_left.
void share_evenly(std::vector<int> p_wanted, std::vector<int> &r_shares, int &r_left) {
	int64_t open = std::ranges::count_if(p_wanted, [](int p_tiles) { return p_tiles > 0; });
	while (open > 0 && r_left > 0) {
		const int each = int(std::max<int64_t>(r_left / open, 1));
		for (size_t i = 0; i < p_wanted.size() && r_left > 0; i++) {
			const int given = std::min({ p_wanted[i], each, r_left });
			r_shares[i] += given;
			r_left -= given;
			p_wanted[i] -= given;
			open -= given > 0 && p_wanted[i] == 0 ? 1 : 0;
		}
	}
}

} // namespace

std::vector<int> share_pool(std::span<const PoolDemand> p_demands, int p_slots) {
	std::vector<int> shares(p_demands.size(), 0), wanted(p_demands.size());
	int left = std::max(p_slots, 0);
	for (int band = 0; band <= TileView::UNSEEN && left > 0; band++) {
		for (size_t i = 0; i < p_demands.size(); i++) {
			wanted[i] = std::min(p_demands[i].tiles[size_t(band)], p_demands[i].most - shares[i]);
		}
		share_evenly(wanted, shares, left);
	}
	for (size_t i = 0; i < p_demands.size(); i++) {
		wanted[i] = p_demands[i].most - shares[i];
	}
	share_evenly(wanted, shares, left);
	return shares;
}

void PoolBudget::set_slots(int p_slots) {
	_is_short = _is_short && _slots == p_slots; // else they are shared at once, if need be
	_slots = p_slots;
}

void PoolBudget::join(Member &r_member) {
	r_member._turns = TURNS; // it has no share yet, and waits for none
	_members.push_back(&r_member);
}

void PoolBudget::leave(Member &r_member) {
	_used -= r_member._used;
	std::erase(_members, &r_member);
}

int PoolBudget::grant(Member &r_member, int p_used) {
	report(r_member, p_used, false);
	const bool is_due = ++r_member._turns >= TURNS;
	if ((_has_asked || _used > _slots) && (is_due || !_is_short)) {
		share();
	} else if (is_due) { // nobody has lacked a slot for a while
		_is_short = false;
	}
	const int free = p_used + std::max(_slots - _used, 0); // others may not have given back yet what is this field's share
	return _is_short ? std::min(r_member._granted, free) : free;
}

void PoolBudget::report(Member &r_member, int p_used, bool p_is_short) {
	_used += p_used - r_member._used;
	r_member._used = p_used;
	_has_asked = _has_asked || p_is_short;
}

void PoolBudget::share() {
	std::vector<PoolDemand> demands;
	for (Member *member : _members) {
		demands.push_back(member->find_demand());
	}
	const std::vector<int> shares = share_pool(demands, _slots);
	for (size_t i = 0; i < _members.size(); i++) {
		_members[i]->_granted = shares[i];
		_members[i]->_turns = 0;
	}
	_is_short = true;
	_has_asked = false;
	_shares++;
}

} // namespace grass
