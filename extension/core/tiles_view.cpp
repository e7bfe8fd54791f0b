// SPDX-License-Identifier: MIT
// What TileManager leaves out since nobody sees it.
#include "core/tiles.h"

#include <cmath>

namespace grass {

void TileManager::see(std::span<const Frustum> p_frustums, float p_margin) {
	_sees_all = false;
	_frustums.assign(p_frustums.begin(), p_frustums.end());
	_margin = p_margin;
}

bool TileManager::is_box_seen(const Eigen::Vector3d &p_centre, double p_half_x, double p_half_z) const {
	const float half_height = 0.5f * float(_params.height - _params.low);
	const Eigen::Vector3f middle = p_centre.cast<float>() + Eigen::Vector3f(0.0f, 0.5f * float(_params.height + _params.low), 0.0f);
	const Eigen::Vector3f half(float(p_half_x + _params.reach), half_height, float(p_half_z + _params.reach));
	return _sees_all || std::any_of(_frustums.begin(), _frustums.end(), [&](const Frustum &p_frustum) {
		return grass_tile_visible(p_frustum, middle, half, _margin, Eigen::Vector3f::Zero());
	});
}

bool TileManager::is_seen(const Place &p_place) const {
	const double half = 0.5 * _grid.get_tile_size();
	return is_box_seen(_grid.get_centre(p_place.x, p_place.z), half, half);
}

bool TileManager::is_field_seen() const {
	return is_box_seen(Eigen::Vector3d::Zero(), 0.5 * _grid.get_size_x(), 0.5 * _grid.get_size_z());
}

void TileManager::stir(const TileRange &p_tiles) {
	if (p_tiles.count() == 0) {
		return;
	}
	for (const int slot : _used) {
		const Place &place = _places[size_t(slot)];
		if (p_tiles.has(place.x, place.z)) {
			_stirred.insert(slot);
		}
	}
}

void TileManager::pass_unseen(double p_delta) {
	_time += std::isfinite(p_delta) ? std::max(p_delta, 0.0) : 0.0;
	_has_passed_unseen = true;
}

} // namespace grass
