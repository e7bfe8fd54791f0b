// SPDX-License-Identifier: MIT
#include "core/map/height_sheet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace grass {

namespace {

constexpr double SHEET_TEXEL = info_of(MAP_GROUND).texel_size();
constexpr double MAP_REACH = PaintMap::REACH * MAP_CHUNK_SIZE;
constexpr double EDGE = 1e-3; // metres beyond its edges, so that no gap opens between neighbours and corners belong to it

} // namespace

HeightSheet::HeightSheet(const MapRegion &p_region, const GroundGrid &p_grid) {
	const Eigen::Array2d low = ((p_region.min.array().max(-MAP_REACH) - SHEET_TEXEL) / SHEET_TEXEL - 0.5).floor();
	const Eigen::Array2d high = ((p_region.max.array().min(MAP_REACH) + SHEET_TEXEL) / SHEET_TEXEL - 0.5).ceil();
	_first = (low + 0.5) * SHEET_TEXEL + p_grid.offset().array();
	if (low.allFinite() && high.allFinite() && (low <= high).all()) {
		_width = int(high.x() - low.x()) + 1;
		_depth = int(high.y() - low.y()) + 1;
		_heights.assign(size_t(_width) * size_t(_depth), std::numeric_limits<double>::quiet_NaN());
		_above.resize(_heights.size());
	}
}

Eigen::Array2d HeightSheet::texel_at(const Eigen::Vector2d &p_place) const {
	return (p_place.array() - _first) / SHEET_TEXEL;
}

double HeightSheet::Triangle::at(const Eigen::Array2d &p_texel) const {
	const auto turn = [](const Eigen::Array2d &p_from, const Eigen::Array2d &p_to, const Eigen::Array2d &p_at) {
		return (p_to.x() - p_from.x()) * (p_at.y() - p_from.y()) - (p_to.y() - p_from.y()) * (p_at.x() - p_from.x());
	};
	const double area = turn(a, b, c);
	const double share_a = turn(b, c, p_texel) / area, share_b = turn(c, a, p_texel) / area, share_c = 1.0 - share_a - share_b;
	const double slack = EDGE / SHEET_TEXEL / std::sqrt(std::abs(area));
	const bool is_inside = std::min({ share_a, share_b, share_c }) >= -slack;
	return is_inside ? share_a * heights.x() + share_b * heights.y() + share_c * heights.z() : std::numeric_limits<double>::quiet_NaN();
}

void HeightSheet::add(const Eigen::Vector3d &p_a, const Eigen::Vector3d &p_b, const Eigen::Vector3d &p_c) {
	const auto flat = [this](const Eigen::Vector3d &p_corner) { return texel_at({ p_corner.x(), p_corner.z() }); };
	const Triangle triangle{ flat(p_a), flat(p_b), flat(p_c), { p_a.y(), p_b.y(), p_c.y() } };
	const Eigen::Array2d to_b = triangle.b - triangle.a, to_c = triangle.c - triangle.a;
	const double area = to_b.x() * to_c.y() - to_b.y() * to_c.x();
	const Eigen::Array2d last = Eigen::Array2d(_width, _depth) - 1.0;
	const Eigen::Array2d low = triangle.a.min(triangle.b).min(triangle.c), high = triangle.a.max(triangle.b).max(triangle.c);
	const Eigen::Array2d first_square = low.round().max(0.0), last_square = high.round().min(last);
	if (!(std::abs(area) > 1e-12) || !(first_square <= last_square).all() || !triangle.heights.allFinite()) {
		return;
	}
	const uint32_t number = uint32_t(_triangles.size());
	_triangles.push_back(triangle);
	for (int j = int(first_square.y()); j <= int(last_square.y()); j++) {
		for (int i = int(first_square.x()); i <= int(last_square.x()); i++) {
			const size_t texel = size_t(j) * size_t(_width) + size_t(i);
			_above[texel].push_back(number);
			_heights[texel] = std::fmax(_heights[texel], triangle.at({ i, j }));
		}
	}
}

double HeightSheet::between(const Eigen::Vector2d &p_place) const {
	const Eigen::Array2d texel = texel_at(p_place), nearest = texel.round();
	double height = std::numeric_limits<double>::quiet_NaN();
	if (!(nearest >= 0.0).all() || !(nearest < Eigen::Array2d(_width, _depth)).all()) {
		return height;
	}
	for (const uint32_t number : _above[size_t(nearest.y()) * size_t(_width) + size_t(nearest.x())]) {
		height = std::fmax(height, _triangles[number].at(texel));
	}
	return height;
}

double HeightSheet::at(const Eigen::Vector2d &p_place) const {
	const Eigen::Array2d texel = texel_at(p_place).round();
	if (!(texel >= 0.0).all() || !(texel < Eigen::Array2d(_width, _depth)).all()) {
		return std::numeric_limits<double>::quiet_NaN();
	}
	return _heights[size_t(texel.y()) * size_t(_width) + size_t(texel.x())];
}

} // namespace grass
