// SPDX-License-Identifier: MIT
// Time heals: what was cut grows, and wear goes, at a rate. A step looks at one chunk, so its cost does not grow with the map.
#pragma once

#include "core/map/mow.h"

namespace grass {

// Wear that goes in a minute; 1 is trampled bare. 0: it lasts, and so do paths that were painted. Usual in games 0 to 0.2.
inline constexpr Tunable WEAR_RECOVERY{ "wear_recovery", "1/min", 0.0, 60.0, 0.001, 0.0 };
// By how much cut grass grows in a minute. 0: it stays short. Usual in games 0 to 50.
inline constexpr Tunable REGROWTH{ "regrowth", "mm/min", 0.0, 10000.0, 0.1, 0.0 };

struct RecoveryRates {
	double wear = 0.0; // a second
	double growth = 0.0; // metres a second
	bool is_none() const { return !(wear > 0.0) && !(growth > 0.0); }
};

class Recovery {
public:
	// Lets p_delta seconds pass, and brings the next chunk within p_region (metres) up to date. Every chunk is looked at in
	// turn; what it missed in between is made up for.
	BrushResult step(PaintMap &r_map, const MapRegion &p_region, const GrassKind &p_kind, const RecoveryRates &p_rates, double p_delta);
	void reset() { *this = Recovery(); }

private:
	// Whole codes of both channels that time has healed, since the beginning or up to when a chunk was looked at.
	struct Healed {
		int64_t wear = 0, growth = 0;
	};
	double _wear = 0.0, _growth = 0.0; // codes, with the part that is not whole yet
	MapKey _last{ PaintMap::REACH, PaintMap::REACH }; // chunk that was looked at
	std::map<MapKey, Healed> _done;
};

} // namespace grass
