// SPDX-License-Identifier: MIT
#include "core/map/height_sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grass {

namespace {

constexpr double SHEET_TEXEL = info_of(MAP_GROUND).texel_size();
constexpr double REACH = PaintMap::REACH * MAP_CHUNK_SIZE;
constexpr double EDGE = 1e-9; // share of a triangle: no gap opens between neighbours

} // namespace

HeightSheet::HeightSheet(const MapRegion &p_region) {
	const Eigen::Array2d low = ((p_region.min.array().max(-REACH) - SHEET_TEXEL) / SHEET_TEXEL - 0.5).floor();
	const Eigen::Array2d high = ((p_region.max.array().min(REACH) + SHEET_TEXEL) / SHEET_TEXEL - 0.5).ceil();
	_first = (low + 0.5) * SHEET_TEXEL;
	if (low.allFinite() && high.allFinite() && (low <= high).all()) {
		_width = int(high.x() - low.x()) + 1;
		_depth = int(high.y() - low.y()) + 1;
		_heights.assign(size_t(_width) * size_t(_depth), std::numeric_limits<double>::quiet_NaN());
	}
}

Eigen::Array2d HeightSheet::texel_at(const Eigen::Vector2d &p_place) const {
	return (p_place.array() - _first) / SHEET_TEXEL;
}

void HeightSheet::add(const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c) {
	const auto flat = [this](const Eigen::Vector3d &p_corner) { return texel_at({ p_corner.x(), p_corner.z() }); };
	const Eigen::Array2d a = flat(p_a), b = flat(p_b), c = flat(p_c);
	const auto turn = [](const Eigen::Array2d &p_from, const Eigen::Array2d &p_to, double p_x, double p_y) {
		return (p_to.x() - p_from.x()) * (p_y - p_from.y()) - (p_to.y() - p_from.y()) * (p_x - p_from.x());
	};
	const double area = turn(a, b, c.x(), c.y());
	const Eigen::Array2d low = a.min(b).min(c).ceil().max(0.0), high = a.max(b).max(c).floor().min(Eigen::Array2d(_width, _depth) - 1.0);
	if (!(std::abs(area) > 1e-12) || !(low <= high).all() || !std::isfinite(p_a.y() + p_b.y() + p_c.y())) {
		return;
	}
	for (int j = int(low.y()); j <= int(high.y()); j++) {
		for (int i = int(low.x()); i <= int(high.x()); i++) {
			const double share_a = turn(b, c, i, j) / area, share_b = turn(c, a, i, j) / area, share_c = 1.0 - share_a - share_b;
			if (std::min({ share_a, share_b, share_c }) >= -EDGE) {
				double &height = _heights[size_t(j) * size_t(_width) + size_t(i)];
				height = std::fmax(height, share_a * p_a.y() + share_b * p_b.y() + share_c * p_c.y());
			}
		}
	}
}

double HeightSheet::at(const Eigen::Vector2d &p_place) const {
	const Eigen::Array2d texel = texel_at(p_place).round();
	if (!(texel >= 0.0).all() || !(texel < Eigen::Array2d(_width, _depth)).all()) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	return _heights[size_t(texel.y()) * size_t(_width) + size_t(texel.x())];
}

} // namespace grass
