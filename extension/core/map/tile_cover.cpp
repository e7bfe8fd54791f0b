// SPDX-License-Identifier: MIT
#include "core/map/tile_cover.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace grass {

void TileCover::reset(const TileGrid &p_grid) {
	_grid = p_grid;
	_tiles.assign(size_t(p_grid.get_tile_count()), {});
	_bare = p_grid.get_tile_count();
	_low = _high = 0.0f;
}

void TileCover::widen(const Tile &p_tile) {
	if (!p_tile.is_bare()) {
		_low = std::min(_low, p_tile.low);
		_high = std::max(_high, p_tile.high);
	}
}

TileRange TileCover::update(const MapLayers &p_layers, const MapRegion &p_region) {
	const MapRegion region = p_region.grown(2.0 * info_of(MAP_HEIGHT).texel_size());
	const TileRange range = _grid.get_range(region.min.x(), region.max.x(), region.min.y(), region.max.y(), 0.0);
	bool has_shrunk = false; // the lowest or highest ground may have gone
	for (int z = range.z_begin; z < range.z_end; z++) {
		for (int x = range.x_begin; x < range.x_end; x++) {
			Tile &tile = _tiles[size_t(_grid.get_index(x, z))];
			_bare -= tile.is_bare() ? 1 : 0;
			const Tile before = std::exchange(tile, find(p_layers, x, z));
			has_shrunk = has_shrunk || (!before.is_bare() && before != tile && (before.low == _low || before.high == _high));
			_bare += tile.is_bare() ? 1 : 0;
			widen(tile);
		}
	}
	if (has_shrunk) {
		_low = _high = 0.0f;
		for (const Tile &tile : _tiles) {
			widen(tile);
		}
	}
	return range;
}

// Looks at every texel that has a say in what is sampled within the tile's square.
TileCover::Tile TileCover::find(const MapLayers &p_layers, int p_x, int p_z) const {
	const Eigen::Vector3d centre = _grid.get_centre(p_x, p_z);
	const double half = 0.5 * _grid.get_tile_size();
	const Eigen::Array2d low(centre.x() - half, centre.z() - half), high(centre.x() + half, centre.z() + half);
	const Eigen::Array2i first = (low / MAP_CHUNK_SIZE).floor().cast<int>(), last = (high / MAP_CHUNK_SIZE).floor().cast<int>();
	bool stands = false;
	Tile ground{ 1e9f, -1e9f };
	for (int z = first.y(); z <= last.y(); z++) {
		for (int x = first.x(); x <= last.x(); x++) {
			const int found = p_layers.find({ x, z });
			if (found == GRASS_NO_LAYER) {
				stands = stands || p_layers.get_base_density() > 0.0f;
				ground = { std::min(ground.low, 0.0f), std::max(ground.high, 0.0f) };
				continue;
			}
			const MapLayer &layer = p_layers.get_layer(found);
			const Eigen::Array2d corner(x * MAP_CHUNK_SIZE, z * MAP_CHUNK_SIZE);
			const auto each = [&](int p_side, const auto &p_visit) {
				const double scale = p_side / MAP_CHUNK_SIZE;
				const auto begin = ((low - corner) * scale + 0.5).floor().max(0.0).min(double(p_side)).cast<int>().eval();
				const auto end = ((high - corner) * scale + 0.5).floor().max(0.0).min(double(p_side)).cast<int>().eval();
				for (int j = begin.y(); j <= end.y() + 1; j++) {
					for (int i = begin.x(); i <= end.x() + 1; i++) {
						p_visit(size_t(j * (p_side + 2) + i));
					}
				}
			};
			each(GRASS_FINE_TEXELS, [&](size_t p_texel) { stands = stands || layer.growth[p_texel * 4] > 0; });
			each(GRASS_COARSE_TEXELS, [&](size_t p_texel) {
				ground = { std::min(ground.low, layer.ground[p_texel]), std::max(ground.high, layer.ground[p_texel]) };
			});
		}
	}
	return stands ? ground : Tile();
}

} // namespace grass
