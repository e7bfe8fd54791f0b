// SPDX-License-Identifier: MIT
// What TileManager leaves out since nobody sees it.
#include "core/tiles/tiles.h"

#include <cmath>

namespace grass {

void TileManager::see(std::span<const Frustum> p_frustums, float p_margin) {
	_sees_all = false;
	_frustums.assign(p_frustums.begin(), p_frustums.end());
	_margin = p_margin;
}

bool TileManager::is_field_seen() const {
	const float half_height = 0.5f * float(_params.height - _params.low);
	const Eigen::Vector3f middle(0.0f, 0.5f * float(_params.height + _params.low), 0.0f);
	const Eigen::Vector3f half(
			float(0.5 * _grid.get_size_x() + _params.overhang), half_height, float(0.5 * _grid.get_size_z() + _params.overhang));
	return _sees_all || std::any_of(_frustums.begin(), _frustums.end(), [&](const Frustum &p_frustum) {
		return grass_tile_visible(p_frustum, middle, half, _margin, Eigen::Vector3f::Zero());
	});
}

// grass_tile_visible() of all tiles' boxes, which differ in x and z only.
void TileManager::find_tile_frustums() {
	const Eigen::Vector3d first = _grid.get_centre(0, 0) + Eigen::Vector3d(0.0, 0.5 * (_params.height + _params.low), 0.0);
	const double side = _grid.get_tile_size(), half_side = 0.5 * side + _params.overhang;
	const Eigen::Vector3d half(half_side, 0.5 * (_params.height - _params.low), half_side);
	_tile_frustums.resize(_frustums.size());
	for (size_t i = 0; i < _frustums.size(); i++) {
		for (size_t k = 0; k < _frustums[i].size(); k++) {
			const Eigen::Vector4d plane = _frustums[i][k].cast<double>();
			const Eigen::Vector3d normal = plane.head<3>();
			const double room = plane.w() + double(_margin) + normal.cwiseAbs().dot(half) - normal.dot(first);
			_tile_frustums[i][k] = Eigen::Vector3d(side * normal.x(), side * normal.z(), room).cast<float>();
		}
	}
}

bool TileManager::is_seen(const Place &p_place) const {
	const float x = p_place.tile.x, z = p_place.tile.z;
	return _sees_all || std::any_of(_tile_frustums.begin(), _tile_frustums.end(), [x, z](const TileFrustum &p_frustum) {
		return std::none_of(p_frustum.begin(), p_frustum.end(),
				[x, z](const Eigen::Vector3f &p_plane) { return x * p_plane.x() + z * p_plane.y() > p_plane.z(); });
	});
}

void TileManager::stir(const TileRange &p_tiles) {
	if (p_tiles.count() == 0) {
		return;
	}
	for (const int slot : _used) {
		const TileBounds::Tile tile = _places[size_t(slot)].tile;
		if (p_tiles.has(tile.x, tile.z)) {
			_stirred.insert(slot);
		}
	}
}

void TileManager::pass_unseen(double p_delta) {
	_time += std::isfinite(p_delta) ? std::max(p_delta, 0.0) : 0.0;
	_has_passed_unseen = true;
}

} // namespace grass
