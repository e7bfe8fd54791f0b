// SPDX-License-Identifier: MIT
// A list of things that wait to be done one after the other, in order of their need.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace grass {

// Whether somebody waits for a thing now, or may need it later.
enum class Need { WANTED, PREPARED };

// Everything WANTED comes before everything PREPARED. Within each, smaller orders come first, and equal orders in the order of arrival.
template <typename Item> class WaitList {
public:
	void add(Item p_item, int p_order, Need p_need) { _waiting.push_back({ std::move(p_item), p_order, p_need }); }
	// Marks the item as wanted. Does nothing once it no longer waits.
	void want(const Item &p_item) {
		const auto found = std::ranges::find(_waiting, p_item, &Waiting::item);
		if (found != _waiting.end()) {
			found->need = Need::WANTED;
		}
	}
	// Removes the next item from the list and returns it. The list must not be empty.
	Item take() {
		const auto next = std::ranges::min_element(_waiting,
				[](const Waiting &p_a, const Waiting &p_b) { return p_a.need != p_b.need ? p_a.need < p_b.need : p_a.order < p_b.order; });
		Item item = std::move(next->item);
		_waiting.erase(next);
		return item;
	}
	// Returns whether it waited.
	bool remove(const Item &p_item) {
		return std::erase_if(_waiting, [&](const Waiting &p_waiting) { return p_waiting.item == p_item; }) > 0;
	}
	void clear() { _waiting.clear(); }
	bool is_empty() const { return _waiting.empty(); }
	size_t size() const { return _waiting.size(); }

private:
	struct Waiting {
		Item item;
		int order;
		Need need;
	};
	std::vector<Waiting> _waiting; // in the order of arrival
};

} // namespace grass
