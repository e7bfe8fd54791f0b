// SPDX-License-Identifier: MIT
#include "core/paint/ground_reading.h"

#include <cmath>

namespace grass {

GroundReading::GroundReading(const MapRegion &p_region, const GroundRule &p_rule) : _rule(p_rule) {
	const double reach = PaintMap::REACH * double(info_of(MAP_GROUND).side);
	const Eigen::Array2d offset = _rule.grid.offset();
	const Eigen::Array2d low = ((p_region.min.array() - offset) / GROUND_TEXEL - 0.5).ceil(),
						 high = ((p_region.max.array() - offset) / GROUND_TEXEL - 0.5).floor();
	if (!low.allFinite() || !high.allFinite() || (low > high).any()) {
		return;
	}
	_is_out_of_reach = (low < -reach).any() || (high >= reach).any();
	_first = low.max(-reach).min(reach).cast<int>();
	_last = high.max(-reach - 1.0).min(reach - 1.0).cast<int>();
	if ((_first <= _last).all()) {
		_heights.emplace(_first, _last, LedgeFinder::margin(_rule.is_sheet));
		_finder.emplace(_first, _last, _rule.ledge_slope, _rule.is_sheet, _rule.missing == MissingGround::HOLE);
	}
}

bool GroundReading::read(const HeightAt &p_height, const HeightAt &p_between, int64_t p_most) {
	GroundPlaces places(p_height, p_between, _rule.grid.offset(), p_most);
	const bool is_done = is_empty() || work(places);
	_sampled += places.get_read();
	return is_done;
}

bool GroundReading::work(GroundPlaces &r_places) {
	while (!_heights->is_complete()) {
		if (!r_places.has(1)) {
			return false;
		}
		_heights->put(r_places.texel(_heights->next()));
	}
	if (!_finder->work(*_heights, r_places)) {
		return false;
	}
	if (_ledges.empty()) {
		list_ledges();
	}
	while (_slopes.size() < _beside.size()) {
		if (!r_places.has(SLOPE_PLACES)) {
			return false;
		}
		const auto [i, j] = _beside[_slopes.size()];
		_slopes[{ i, j }] = slope_beside_ledge(*_heights, _rule.ledge_slope, _rule.is_sheet, i, j, r_places);
	}
	return true;
}

void GroundReading::list_ledges() {
	std::set<std::pair<int, int>> beside;
	for (const LedgeCell &cell : _finder->get_cells()) {
		_ledges.emplace(cell.i, cell.j);
		for (int n = 0; n < 4; n++) {
			const Eigen::Array2i texel(cell.i + (n & 1), cell.j + (n >> 1));
			if ((texel >= _first).all() && (texel <= _last).all() && std::isfinite(_heights->at(texel.x(), texel.y()))) {
				beside.emplace(texel.x(), texel.y());
			}
		}
	}
	_beside.assign(beside.begin(), beside.end());
}

Eigen::Vector3d GroundReading::normal(int p_i, int p_j) const {
	const auto slope = _slopes.find({ p_i, p_j });
	return slope == _slopes.end() ? _heights->normal(p_i, p_j) : Eigen::Vector3d(-slope->second.x(), 1.0, -slope->second.y()).normalized();
}

} // namespace grass
