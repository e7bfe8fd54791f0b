// SPDX-License-Identifier: MIT
#include "core/tiles/tile_view.h"

#include <algorithm>
#include <bit>

namespace grass {

void TileView::see(std::span<const Frustum> p_frustums, float p_margin, std::span<const Eigen::Vector3f> p_eyes) {
	_sees_all = false;
	_frustums.assign(p_frustums.begin(), p_frustums.end());
	_eyes.assign(p_eyes.begin(), p_eyes.end());
	_margin = p_margin;
}

bool TileView::sees_field(const TileGrid &p_grid, const TileParams &p_params) const {
	const float half_height = 0.5f * float(p_params.height - p_params.low);
	const Eigen::Vector3f middle(0.0f, 0.5f * float(p_params.height + p_params.low), 0.0f);
	const Eigen::Vector3f half(
			float(0.5 * p_grid.get_size_x() + p_params.overhang), half_height, float(0.5 * p_grid.get_size_z() + p_params.overhang));
	return _sees_all || std::any_of(_frustums.begin(), _frustums.end(), [&](const Frustum &p_frustum) {
		return grass_tile_visible(p_frustum, middle, half, _margin, Eigen::Vector3f::Zero());
	});
}

// Prepares grass_tile_visible() for all tiles' boxes, which differ in x and z only.
void TileView::prepare(const TileGrid &p_grid, const TileParams &p_params) {
	const Eigen::Vector3d first = p_grid.get_centre(0, 0) + Eigen::Vector3d(0.0, 0.5 * (p_params.height + p_params.low), 0.0);
	const double side = p_grid.get_tile_size(), half_side = 0.5 * side + p_params.overhang;
	const Eigen::Vector3d half(half_side, 0.5 * (p_params.height - p_params.low), half_side);
	_tile_frustums.resize(_frustums.size());
	for (size_t i = 0; i < _frustums.size(); i++) {
		for (size_t k = 0; k < _frustums[i].size(); k++) {
			const Eigen::Vector4d plane = _frustums[i][k].cast<double>();
			const Eigen::Vector3d normal = plane.head<3>();
			const double room = plane.w() + double(_margin) + normal.cwiseAbs().dot(half) - normal.dot(first);
			_tile_frustums[i][k] = Eigen::Vector3d(side * normal.x(), side * normal.z(), room).cast<float>();
		}
	}
	_tile_size = float(side);
	_tile_eyes.clear();
	for (const Eigen::Vector3f &eye : _eyes) {
		const Eigen::Vector3d way = eye.cast<double>() - first;
		_tile_eyes.push_back(Eigen::Vector3d(way.x() / side, way.y(), way.z() / side).cast<float>());
	}
}

bool TileView::sees(int p_x, int p_z) const {
	const float x = float(p_x), z = float(p_z);
	return _sees_all || std::any_of(_tile_frustums.begin(), _tile_frustums.end(), [x, z](const TileFrustum &p_frustum) {
		return std::none_of(p_frustum.begin(), p_frustum.end(),
				[x, z](const Eigen::Vector3f &p_plane) { return x * p_plane.x() + z * p_plane.y() > p_plane.z(); });
	});
}

int TileView::get_band(const TileRange &p_tiles, float p_margin) const {
	if (_sees_all) {
		return 0;
	}
	const float left = float(p_tiles.x_begin), right = float(p_tiles.x_end - 1), back = float(p_tiles.z_begin),
				front = float(p_tiles.z_end - 1), narrower = std::max(_margin - p_margin, 0.0f);
	int band = UNSEEN;
	for (size_t i = 0; i < _tile_frustums.size(); i++) {
		const bool is_outside = std::ranges::any_of(_tile_frustums[i], [&](const Eigen::Vector3f &p_plane) {
			const float x = p_plane.x() > 0.0f ? left : right, z = p_plane.y() > 0.0f ? back : front;
			return x * p_plane.x() + z * p_plane.y() > p_plane.z() - narrower;
		});
		if (!is_outside) {
			band = std::min(band, i < _tile_eyes.size() ? band_from(_tile_eyes[i], left, right, back, front) : 0);
		}
	}
	return band;
}

// Returns the band of the tile that is nearest to the eye. The square of the distance has two bands for each doubling: exponent and first
// digit.
int TileView::band_from(const Eigen::Vector3f &p_eye, float p_left, float p_right, float p_back, float p_front) const {
	constexpr int FIRST = 127 << 1, DIGITS = 22;
	const float x = p_eye.x() - std::clamp(p_eye.x(), p_left, p_right), z = p_eye.z() - std::clamp(p_eye.z(), p_back, p_front);
	const float square = (x * x + z * z) * _tile_size * _tile_size + p_eye.y() * p_eye.y();
	return square >= 1.0f ? std::min(int(std::bit_cast<uint32_t>(square) >> DIGITS) - FIRST, FARTHEST) : 0;
}

} // namespace grass
