// SPDX-License-Identifier: MIT
#include "core/map/recovery.h"

#include <algorithm>
#include <cmath>

namespace grass {

BrushResult Recovery::step(
		PaintMap &r_map, const MapRegion &p_region, const GrassKind &p_kind, const RecoveryRates &p_rates, double p_delta) {
	if (p_rates.is_none() || !(p_delta > 0.0) || r_map.is_empty()) {
		return {};
	}
	_wear += p_rates.wear * p_delta / info_of(MAP_WEAR).unit;
	_growth += p_rates.growth * p_delta / info_of(MAP_CUT).unit;
	const auto &chunks = r_map.get_chunks();
	auto next = chunks.upper_bound(_last);
	next = next == chunks.end() ? chunks.begin() : next;
	const MapKey key = next->first;
	const MapChunk &chunk = next->second;
	_last = key;
	const Healed all{ int64_t(_wear), int64_t(_growth) };
	if (!chunk.channels[MAP_WEAR] && !chunk.channels[MAP_CUT]) {
		_done.erase(key); // what comes later does not heal at once
		return {};
	}
	const auto [found, is_new] = _done.try_emplace(key, all); // a chunk that was not known begins to heal now
	const Healed missed{ all.wear - found->second.wear, all.growth - found->second.growth };
	found->second = all;
	const MapRegion square = MapRegion::of_chunk(key);
	const MowRegion region{ nullptr, { square.min.cwiseMax(p_region.min), square.max.cwiseMin(p_region.max) } };
	if ((missed.wear == 0 && missed.growth == 0) || (region.rectangle.min.array() >= region.rectangle.max.array()).any()) {
		return {};
	}
	return regrow_grass(r_map, region, p_kind, double(missed.growth) * info_of(MAP_CUT).unit, double(missed.wear) * info_of(MAP_WEAR).unit);
}

} // namespace grass
