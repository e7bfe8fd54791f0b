// SPDX-License-Identifier: MIT
// Heals grass over time: cut grass grows and wear goes, at a rate. A step handles one chunk, so its cost does not grow with the map.
#pragma once

#include "core/base/layout.h"
#include "core/paint/mow.h"

#include <array>
#include <functional>

namespace grass {

// Wear that goes in a minute; 1 is trampled bare. 0: wear stays, and so do painted paths. Games usually use 0 to 0.2.
inline constexpr Tunable WEAR_RECOVERY{ "wear_recovery", "1/min", 0.0, 60.0, 0.001, 0.0 };
// How fast a wheel that slips completely wears the grass, in wear per second. 0: wheels leave no tracks. Usually 0.5 to 5.
inline constexpr Tunable WHEEL_WEAR{ "wheel_wear", "1/s", 0.0, 20.0, 0.1, 0.0 };
// How much cut grass grows in a minute. 0: it stays short. Games usually use 0 to 50.
inline constexpr Tunable REGROWTH{ "regrowth", "mm/min", 0.0, 10000.0, 0.1, 0.0 };

struct RecoveryRates {
	std::array<double, GRASS_MAX_SPECIES> wear{}; // per second, for each species; a field without species uses the first
	double growth = 0.0; // metres per second
	bool is_none() const;
};

// Returns the share of each species in the grass at a place. The shares add up to 1.
using SharesAt = std::function<std::array<float, GRASS_MAX_SPECIES>(const Eigen::Vector2d &p_place)>;

class Recovery {
public:
	// Advances time by p_delta seconds and updates the next chunk within p_region (metres). Visits the chunks in turn; each makes up for
	// the time since its last visit. p_shares: null: one species.
	BrushResult step(PaintMap &r_map, const MapRegion &p_region, const GrassKind &p_kind, const RecoveryRates &p_rates, double p_delta,
			const SharesAt &p_shares = nullptr);
	void reset() { *this = Recovery(); }

private:
	// How many codes of both channels time has healed, whole or fractional: since the beginning, or until a chunk was healed.
	struct Healed {
		std::array<double, GRASS_MAX_SPECIES> wear{}; // where a species grows alone
		double growth = 0.0;
	};
	static bool is_due(const Healed &p_done, const Healed &p_all);

	Healed _all;
	MapKey _last{ PaintMap::REACH, PaintMap::REACH }; // the chunk visited last
	std::map<MapKey, Healed> _done;
};

} // namespace grass
