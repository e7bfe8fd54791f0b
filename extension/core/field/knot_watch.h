// SPDX-License-Identifier: MIT
// Which blades somebody asks for again and again, and what is known of them. For a simulator on a device that answers some frames later:
// whoever asks gets what came last, at once, and his blades are read back from then on.
#pragma once

#include "core/field/knots.h"

#include <span>
#include <unordered_map>

namespace grass {

class KnotWatch {
public:
	// A blade that nobody asked for in so many reads is no longer read. A second at 60 frames/s.
	static constexpr int READS_KEPT = 60;

	// The knots of blades after a step, as unpack_knots() takes them.
	struct Answer {
		uint64_t step = 0;
		std::vector<BladeNumber> blades; // rising
		std::vector<float> knots;
	};

	// What the newest answer has of p_blade. From now on it is among those that are read.
	SimulatedKnots ask(const WantedBlade &p_blade);
	// Whether there is something to read: blades that somebody asks for have moved since, or are not known yet. p_step: the newest.
	bool is_due(uint64_t p_step) const { return !_asked.empty() && (_is_unanswered || p_step != _read_step); }
	// The blades to read after p_step, rising. p_slot_of(tile): its slot, or GRASS_NO_SLOT.
	template <typename SlotOf> std::vector<WantedBlade> begin_read(uint64_t p_step, SlotOf &&p_slot_of) {
		std::vector<WantedBlade> blades = list_asked(p_step);
		std::erase_if(blades, [&p_slot_of](WantedBlade &r_blade) {
			r_blade.slot = p_slot_of(tile_of(r_blade.number));
			return r_blade.slot == GRASS_NO_SLOT;
		});
		return blades;
	}
	void receive(Answer &&p_answer) { _answer = std::move(p_answer); }
	// Steps by which the newest answer is behind p_step; 0 where nobody asks.
	int64_t get_age(uint64_t p_step) const { return _asked.empty() || _answer.step == 0 ? 0 : int64_t(p_step - _answer.step); }
	// Other blades, none of which anybody asked for.
	void clear();
	size_t get_memory_usage() const; // bytes

private:
	std::vector<WantedBlade> list_asked(uint64_t p_step);

	std::unordered_map<BladeNumber, int> _asked; // and by which read last
	int _reads = 0;
	uint64_t _read_step = 0; // of the last one
	bool _is_unanswered = false; // somebody has asked since for an awake blade that the newest answer lacks
	Answer _answer;
};

} // namespace grass
