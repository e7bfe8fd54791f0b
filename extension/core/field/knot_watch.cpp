// SPDX-License-Identifier: MIT
#include "core/field/knot_watch.h"

#include <algorithm>

namespace grass {

SimulatedKnots KnotWatch::ask(const WantedBlade &p_blade) {
	_asked[p_blade.number] = _reads;
	if (p_blade.slot == GRASS_NO_SLOT) {
		return {};
	}
	const auto found = std::ranges::lower_bound(_answer.blades, p_blade.number);
	if (found == _answer.blades.end() || *found != p_blade.number) {
		_is_unanswered = true;
		return {};
	}
	return unpack_knots(&_answer.knots[size_t(found - _answer.blades.begin()) * KNOT_NUMBERS]);
}

std::vector<WantedBlade> KnotWatch::list_asked(uint64_t p_step) {
	_read_step = p_step;
	_is_unanswered = false;
	std::erase_if(_asked, [this](const auto &p_asked) { return _reads - p_asked.second >= READS_KEPT; });
	_reads++;
	std::vector<WantedBlade> blades;
	blades.reserve(_asked.size());
	for (const auto &[number, read] : _asked) {
		blades.push_back({ number, GRASS_NO_SLOT });
	}
	std::ranges::sort(blades, {}, &WantedBlade::number);
	return blades;
}

void KnotWatch::clear() {
	_asked.clear();
	_answer = {};
	_is_unanswered = false;
}

size_t KnotWatch::get_memory_usage() const {
	return _asked.size() * (sizeof(std::pair<BladeNumber, int>) + 2 * sizeof(void *)) + _answer.blades.capacity() * sizeof(BladeNumber) +
			_answer.knots.capacity() * sizeof(float);
}

} // namespace grass
