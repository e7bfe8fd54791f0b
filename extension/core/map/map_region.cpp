// SPDX-License-Identifier: MIT
#include "core/map/map_region.h"

namespace grass {

MapRegion MapRegion::of_chunk(const MapKey &p_key) {
	const Eigen::Vector2d corner(p_key.x * MAP_CHUNK_SIZE, p_key.z * MAP_CHUNK_SIZE);
	return { corner, corner.array() + MAP_CHUNK_SIZE };
}

MapRegion MapRegion::of_grid(const TileGrid &p_grid) {
	const Eigen::Vector2d half(0.5 * p_grid.get_size_x(), 0.5 * p_grid.get_size_z());
	return { -half, half };
}

MapRegion MapRegion::grown(double p_metres) const {
	return { min.array() - p_metres, max.array() + p_metres };
}

MapRegion MapRegion::shared(const MapRegion &p_other) const {
	return { min.cwiseMax(p_other.min), max.cwiseMin(p_other.max) };
}

MapRegion MapRegion::joined(const MapRegion &p_other) const {
	return { min.cwiseMin(p_other.min), max.cwiseMax(p_other.max) };
}

} // namespace grass
