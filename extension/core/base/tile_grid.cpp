// SPDX-License-Identifier: MIT
#include "core/base/tile_grid.h"

#include <cmath>

namespace grass {

namespace {

// Returns p_value clamped to the limits; NaN becomes the lower one. Sets r_limited if p_value was not within them.
double limit(double p_value, double p_min, double p_max, bool &r_limited) {
	const bool inside = p_value >= p_min && p_value <= p_max;
	r_limited = r_limited || !inside;
	return inside ? p_value : (p_value > p_max ? p_max : p_min);
}

int count_tiles(double p_size, double p_tile_size, bool &r_limited) {
	const double whole = std::max(1.0, std::round(limit(p_size, 0.0, 1e9, r_limited) / p_tile_size));
	return int(limit(whole, 1.0, TileGrid::MAX_TILES_PER_SIDE, r_limited));
}

// Returns the tile that contains p_tiles, a coordinate in tiles along one axis. Clamped so that int cannot overflow.
int floor_to_int(double p_tiles) {
	const double limited = std::clamp(p_tiles, -16777216.0, 16777216.0);
	const int whole = int(limited); // towards zero; std::floor() is a call on older processors
	return whole - (double(whole) > limited ? 1 : 0);
}

} // namespace

TileGrid TileGrid::make(double p_size_x, double p_size_z, double p_density) {
	TileGrid grid;
	const double density = limit(p_density, MIN_DENSITY, MAX_DENSITY, grid._limited);
	// Rounded to float, so that the shaders use exactly the same size.
	grid._tile_size = double(float(std::sqrt(GRASS_BLADES_PER_TILE / density)));
	grid._tiles_x = count_tiles(p_size_x, grid._tile_size, grid._limited);
	grid._tiles_z = count_tiles(p_size_z, grid._tile_size, grid._limited);
	return grid;
}

TilePlace TileGrid::get_place(const Eigen::Vector3d &p_position) const {
	TilePlace place;
	place.x = floor_to_int(p_position.x() / _tile_size + 0.5 * _tiles_x);
	place.z = floor_to_int(p_position.z() / _tile_size + 0.5 * _tiles_z);
	place.offset = get_offset(p_position, place.x, place.z);
	return place;
}

TileRange TileGrid::get_range(double p_min_x, double p_max_x, double p_min_z, double p_max_z, double p_margin) const {
	if (!(p_min_x <= p_max_x && p_min_z <= p_max_z && p_margin >= 0.0)) {
		return {};
	}
	// Tile i spans [i, i + 1] in tiles from the field's corner. Intervals are closed: touching counts as overlap.
	const double corner_x = 0.5 * _tiles_x, corner_z = 0.5 * _tiles_z;
	TileRange range;
	range.x_begin = std::max(0, -floor_to_int((p_margin - p_min_x) / _tile_size - corner_x) - 1);
	range.z_begin = std::max(0, -floor_to_int((p_margin - p_min_z) / _tile_size - corner_z) - 1);
	range.x_end = std::min(_tiles_x, floor_to_int((p_max_x + p_margin) / _tile_size + corner_x) + 1);
	range.z_end = std::min(_tiles_z, floor_to_int((p_max_z + p_margin) / _tile_size + corner_z) + 1);
	return range.count() > 0 ? range : TileRange{};
}

} // namespace grass
