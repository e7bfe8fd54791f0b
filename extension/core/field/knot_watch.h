// SPDX-License-Identifier: MIT
// Keeps track of the blades that are queried repeatedly, and of their last known knots, for a simulator on a device that answers some
// frames later: a query returns the last known knots at once, and its blades are read back from then on.
#pragma once

#include "core/field/knots.h"

#include <unordered_map>
#include <vector>

namespace grass {

class KnotWatch {
public:
	// Reads after which a blade that was not queried is no longer read: a second at 60 frames/s.
	static constexpr int READS_KEPT = 60;

	// The knots of blades after a step, in the form that unpack_knots() reads.
	struct Answer {
		uint64_t step = 0;
		std::vector<BladeNumber> blades; // ascending
		std::vector<float> knots;
	};

	// Returns the knots of p_blade in the newest answer. From now on the blade is read back.
	SimulatedKnots ask(const WantedBlade &p_blade);
	// Returns true if there is something to read: queried blades have moved since, or are not known yet. p_step: the newest.
	bool is_due(uint64_t p_step) const { return !_asked.empty() && (_is_unanswered || p_step != _read_step); }
	// Returns the blades to read after p_step, in ascending order. p_slot_of(tile): its slot, or GRASS_NO_SLOT.
	template <typename SlotOf> std::vector<WantedBlade> begin_read(uint64_t p_step, SlotOf &&p_slot_of) {
		std::vector<WantedBlade> blades = list_asked(p_step);
		std::erase_if(blades, [&p_slot_of](WantedBlade &r_blade) {
			r_blade.slot = p_slot_of(tile_of(r_blade.number));
			return r_blade.slot == GRASS_NO_SLOT;
		});
		return blades;
	}
	void receive(Answer &&p_answer) { _answer = std::move(p_answer); }
	// Returns the number of steps by which the newest answer is behind p_step; 0 if nothing is queried.
	int64_t get_age(uint64_t p_step) const { return _asked.empty() || _answer.step == 0 ? 0 : int64_t(p_step - _answer.step); }
	// Starts again with other blades, none of which has been queried.
	void clear();
	size_t get_memory_usage() const; // bytes

private:
	std::vector<WantedBlade> list_asked(uint64_t p_step);

	std::unordered_map<BladeNumber, int> _asked; // and the read in which it was last queried
	int _reads = 0;
	uint64_t _read_step = 0; // of the last read
	bool _is_unanswered = false; // whether an awake blade was queried since then that the newest answer lacks
	Answer _answer;
};

} // namespace grass
