// SPDX-License-Identifier: MIT
#include "core/paint/recovery.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace grass {

namespace {

double whole_codes(double p_from, double p_to) {
	return std::floor(p_to) - std::floor(p_from);
}

// [Eq P5] Returns the mean of the values, weighted by the species' shares.
double mixed(const std::array<double, GRASS_MAX_SPECIES> &p_values, const std::array<float, GRASS_MAX_SPECIES> &p_shares) {
	double sum = 0.0;
	for (size_t s = 0; s < p_values.size(); s++) {
		sum += double(p_shares[s]) * p_values[s];
	}
	return sum;
}

} // namespace

bool RecoveryRates::is_none() const {
	return !(growth > 0.0) && std::none_of(wear.begin(), wear.end(), [](double p_rate) { return p_rate > 0.0; });
}

// Returns whether a chunk has whole codes to heal. Where species mix, their sum may reach a whole code though no single species does; the
// next whole code makes up for it.
bool Recovery::is_due(const Healed &p_done, const Healed &p_all) {
	bool is_due = whole_codes(p_done.growth, p_all.growth) > 0.0;
	for (size_t s = 0; s < p_all.wear.size(); s++) {
		is_due |= whole_codes(p_done.wear[s], p_all.wear[s]) > 0.0;
	}
	return is_due;
}

BrushResult Recovery::step(PaintMap &r_map, const MapRegion &p_region, const GrassKind &p_kind, const RecoveryRates &p_rates,
		double p_delta, const SharesAt &p_shares) {
	if (p_rates.is_none() || !(p_delta > 0.0) || r_map.is_empty()) {
		return {};
	}
	for (size_t s = 0; s < p_rates.wear.size(); s++) {
		_all.wear[s] += p_rates.wear[s] * p_delta / info_of(MAP_WEAR).unit;
	}
	_all.growth += p_rates.growth * p_delta / info_of(MAP_CUT).unit;
	const auto &chunks = r_map.get_chunks();
	auto next = chunks.upper_bound(_last);
	next = next == chunks.end() ? chunks.begin() : next;
	const MapKey key = next->first;
	const MapChunk &chunk = next->second;
	_last = key;
	if (!chunk.channels[MAP_WEAR] && !chunk.channels[MAP_CUT]) {
		_done.erase(key); // later wear must not heal at once
		return {};
	}
	Healed &done = _done.try_emplace(key, _all).first->second; // a chunk that was not known starts to heal now
	if (!is_due(done, _all)) {
		return {};
	}
	const Healed before = std::exchange(done, _all);
	const MapRegion square = MapRegion::of_chunk(key);
	const MowRegion region{ nullptr, { square.min.cwiseMax(p_region.min), square.max.cwiseMin(p_region.max) } };
	if ((region.rectangle.min.array() >= region.rectangle.max.array()).any()) {
		return {};
	}
	constexpr int SIDE = int(MAP_CHUNK_SIZE); // the species of a square metre are costly to find, so its texels share them
	std::vector<double> healed(p_shares ? SIDE * SIDE : 1, -1.0); // below 0: not computed yet
	const auto healed_at = [&](const Eigen::Vector2d &p_place) {
		const Eigen::Array2d metre = p_place.array().floor();
		const Eigen::Array2i cell = (metre - square.min.array()).cast<int>();
		double &here = healed[p_shares ? size_t(cell.x() + SIDE * cell.y()) : 0];
		if (here < 0.0) {
			const auto shares = p_shares ? p_shares(metre + 0.5) : std::array<float, GRASS_MAX_SPECIES>{ 1.0f };
			here = whole_codes(mixed(before.wear, shares), mixed(_all.wear, shares)) * info_of(MAP_WEAR).unit;
		}
		return here;
	};
	return regrow_grass(r_map, region, p_kind, whole_codes(before.growth, _all.growth) * info_of(MAP_CUT).unit, healed_at);
}

} // namespace grass
