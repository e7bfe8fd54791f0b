// SPDX-License-Identifier: MIT
#include "core/solver/blade_order.h"

#include <algorithm>
#include <numeric>

namespace grass {

namespace {

// Returns whether those blades that have any work all have the same.
bool is_even(std::span<const uint8_t> p_work) {
	uint8_t some = WORK_NONE;
	for (const uint8_t work : p_work) {
		if (work != WORK_NONE && some != WORK_NONE && work != some) {
			return false;
		}
		some = std::max(some, work);
	}
	return true;
}

bool has_work(std::span<const uint8_t> p_work) {
	return std::ranges::any_of(p_work, [](uint8_t p_own) { return p_own != WORK_NONE; });
}

} // namespace

BladeOrder order_blades(std::span<const uint8_t> p_work, int p_lanes) {
	BladeOrder order{};
	int groups = 0; // that have work if blades stay in their places
	for (size_t first = 0; first < p_work.size(); first += size_t(p_lanes)) {
		const size_t end = std::min(first + size_t(p_lanes), p_work.size());
		if (has_work(p_work.subspan(first, end - first))) {
			groups++;
			std::iota(order.blades + order.count, order.blades + order.count + (end - first), uint8_t(first));
			order.count += int(end - first);
		}
	}
	const int busy = int(std::ranges::count_if(p_work, [](uint8_t p_own) { return p_own != WORK_NONE; }));
	if (!is_even(p_work) || groups > (busy + p_lanes - 1) / p_lanes) {
		const auto end =
				std::remove_if(order.blades, order.blades + order.count, [&](uint8_t p_blade) { return p_work[p_blade] == WORK_NONE; });
		std::stable_sort(order.blades, end, [&](uint8_t p_a, uint8_t p_b) { return p_work[p_a] > p_work[p_b]; });
		order.count = busy;
	}
	if (order.count > 0) {
		std::fill(order.blades + order.count, std::end(order.blades), order.blades[order.count - 1]);
	}
	return order;
}

} // namespace grass
