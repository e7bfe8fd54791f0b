// SPDX-License-Identifier: MIT
// The number of tiles that all fields together may have awake. Each field has slots of its own, which it makes as its tiles wake; this
// class only counts them, and says how many each field may use (docs/history/0098-one-pool-for-all-fields.md).
#pragma once

#include "core/tiles/tile_view.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace grass {

// How many tiles a field needs slots for, by the band from which cameras see them (TileView), nearest first. The last band counts tiles
// that no camera sees, and tiles that nothing touches any more.
struct PoolDemand {
	std::array<int, TileView::UNSEEN + 1> tiles{};
	int most = 0; // slots that the field may have at all
};

// Returns how many of p_slots slots each field gets. Tiles near a camera come first. In the band in which slots run out, fields share them
// evenly. What is left is spread evenly, so that the next tile to wake finds a slot.
std::vector<int> share_pool(std::span<const PoolDemand> p_demands, int p_slots);

class PoolBudget {
public:
	static constexpr int MOST_TILES = 1 << 20; // as good as no limit

	// A field that takes part.
	class Member {
	public:
		virtual PoolDemand find_demand() = 0;

	protected:
		~Member() = default;

	private:
		friend PoolBudget;
		int _used = 0, _granted = 0; // tiles; the second while slots are short
		int _turns = 0; // calls of grant() since slots were shared
	};

	// Makes a budget. p_slots: for all fields together.
	explicit PoolBudget(int p_slots = MOST_TILES) : _slots(p_slots) {}
	void set_slots(int p_slots);
	int get_slots() const { return _slots; }
	int get_used() const { return _used; } // by all fields
	int64_t get_shares() const { return _shares; } // times that slots were shared, since there were too few

	void join(Member &r_member);
	void leave(Member &r_member);
	// Returns how many tiles the field may have awake from now on. Must be called once in each of its ticks. p_used: how many are.
	int grant(Member &r_member, int p_used);
	// Must be called after a step. p_is_short: the field found no slots for all of its tiles.
	void report(Member &r_member, int p_used, bool p_is_short);

private:
	// Ticks of a field after which slots are shared again while there are too few. More: slots stay for longer with fields that no longer
	// need them. Fewer: tiles on the edge between two fields' shares wake and sleep in turns.
	static constexpr int TURNS = 15;

	void share();

	std::vector<Member *> _members;
	int _slots;
	int _used = 0;
	bool _is_short = false; // there are too few: each field has what it was granted
	bool _has_asked = false; // some field was short since they were shared last
	int64_t _shares = 0;
};

} // namespace grass
