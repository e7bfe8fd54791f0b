// SPDX-License-Identifier: MIT
#include "core/fill/terrain_colors.h"

#include <algorithm>
#include <cmath>

namespace grass {

TerrainColor TerrainColor::of(double p_red, double p_green, double p_blue, double p_alpha) {
	if (!std::isfinite(p_red + p_green + p_blue + p_alpha)) {
		return {};
	}
	const auto byte = [](double p_share) { return uint8_t(std::lround(std::clamp(p_share, 0.0, 1.0) * 255.0)); };
	return { byte(p_red), byte(p_green), byte(p_blue), byte(p_alpha) };
}

void TerrainColors::set_area(const MapRegion &p_area) {
	_area = p_area;
	_size = (p_area.max - p_area.min).array().floor().max(1.0).min(double(LARGEST)).cast<int>();
	_texels.resize(size_t(_size.x()) * size_t(_size.y()));
	clear();
}

void TerrainColors::clear() {
	std::fill(_texels.begin(), _texels.end(), TerrainColor());
	_has_changed = true;
}

void TerrainColors::set(const Eigen::Vector2d &p_place, const TerrainColor &p_color) {
	const Eigen::Array2d at = (p_place - _area.min).array() / (_area.max - _area.min).array() * _size.cast<double>();
	if (!(at >= 0.0).all() || !(at < _size.cast<double>()).all()) {
		return;
	}
	TerrainColor &texel = _texels[size_t(at.y()) * size_t(_size.x()) + size_t(at.x())];
	_has_changed = _has_changed || !(texel == p_color);
	texel = p_color;
}

} // namespace grass
