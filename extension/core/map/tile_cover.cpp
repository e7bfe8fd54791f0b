// SPDX-License-Identifier: MIT
#include "core/map/tile_cover.h"

#include "core/map/map_layers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace grass {

namespace {

// [Eq M7] Beside a ledge the plane through a texel's ground is used up to its neighbours. Returns how far it rises or falls by then,
// metres.
float beyond_texel(const MapLayer &p_layer, size_t p_texel) {
	const auto normal = [&](size_t p_component) { return (float(p_layer.form[p_texel * 4 + p_component]) - 128.0f) / 127.0f; };
	const float x = normal(2), z = normal(3);
	return (std::abs(x) + std::abs(z)) * float(info_of(MAP_GROUND).texel_size()) / std::sqrt(std::max(1.0f - x * x - z * z, 0.01f));
}

} // namespace

void TileCover::reset(const TileGrid &p_grid) {
	_grid = p_grid;
	_tiles.assign(size_t(p_grid.get_tile_count()), {});
	_bare = p_grid.get_tile_count();
	_extremes = FULL;
}

void TileCover::widen(const Tile &p_tile) {
	if (!p_tile.is_bare()) {
		_extremes = { std::min(_extremes.low, p_tile.low), std::max(_extremes.high, p_tile.high), std::min(_extremes.grown, p_tile.grown),
			std::min(_extremes.cut, p_tile.cut), std::max(_extremes.slope, p_tile.slope) };
	}
}

TileRange TileCover::update(const MapLayers &p_layers, const MapRegion &p_region) {
	const MapRegion region = p_region.grown(MapLayers::CHANGE_MARGIN);
	const TileRange range = _grid.get_range(region.min.x(), region.max.x(), region.min.y(), region.max.y(), 0.0);
	const Eigen::Vector2d offset = p_layers.get_ground_grid().offset();
	const std::vector<Stretch> columns = stretches(range.x_begin, range.x_end, _grid.get_tiles_x(), offset.x()),
							   rows = stretches(range.z_begin, range.z_end, _grid.get_tiles_z(), offset.y());
	bool has_shrunk = false; // the lowest or highest ground may have disappeared
	for (int z = range.z_begin; z < range.z_end; z++) {
		for (int x = range.x_begin; x < range.x_end; x++) {
			Tile &tile = _tiles[size_t(_grid.get_index(x, z))];
			_bare -= tile.is_bare() ? 1 : 0;
			const Tile before = std::exchange(tile, find(p_layers, columns[size_t(x - range.x_begin)], rows[size_t(z - range.z_begin)]));
			has_shrunk = has_shrunk || (!before.is_bare() && before != tile && (before.low == get_low() || before.high == get_high()));
			_bare += tile.is_bare() ? 1 : 0;
			widen(tile);
		}
	}
	if (has_shrunk) {
		_extremes = FULL;
		for (const Tile &tile : _tiles) {
			widen(tile);
		}
	}
	return range;
}

// Returns the stretches of tiles p_begin to p_end - 1 of p_count along one axis. p_offset: of the ground grid, metres.
std::vector<TileCover::Stretch> TileCover::stretches(int p_begin, int p_end, int p_count, double p_offset) const {
	std::vector<Stretch> found;
	found.reserve(size_t(std::max(p_end - p_begin, 0)));
	for (int tile = p_begin; tile < p_end; tile++) {
		const double low = (tile - 0.5 * p_count) * _grid.get_tile_size(), high = low + _grid.get_tile_size();
		Stretch &stretch = found.emplace_back();
		stretch.first_chunk = int(std::floor(low / MAP_CHUNK_SIZE));
		stretch.chunks = int(std::floor(high / MAP_CHUNK_SIZE)) - stretch.first_chunk + 1;
		for (int c = 0; c < stretch.chunks; c++) {
			const double corner = (stretch.first_chunk + c) * MAP_CHUNK_SIZE;
			const auto texels = [&](int p_side, double p_beside) {
				const double scale = p_side / MAP_CHUNK_SIZE;
				const auto texel = [&](double p_place) {
					return int(std::clamp(std::floor((p_place - p_beside - corner) * scale + 0.5), 0.0, double(p_side)));
				};
				return Stretch::Texels{ texel(low), texel(high) + 1 };
			};
			stretch.fine[size_t(c)] = texels(GRASS_FINE_TEXELS, 0.0);
			stretch.coarse[size_t(c)] = texels(GRASS_COARSE_TEXELS, p_offset);
		}
	}
	return found;
}

TileCover::Tile TileCover::find(const MapLayers &p_layers, const Stretch &p_column, const Stretch &p_row) const {
	bool stands = false;
	Tile tile{ 1e9f, -1e9f, 0.0f, float(GRASS_UNCUT), 0.0f };
	int64_t grown = 0, texels = 0; // sum of products of two codes
	for (int z = 0; z < p_row.chunks; z++) {
		for (int x = 0; x < p_column.chunks; x++) {
			const int found = p_layers.find({ p_column.first_chunk + x, p_row.first_chunk + z });
			const size_t c = size_t(x), r = size_t(z);
			if (found == GRASS_NO_LAYER) {
				const float density = p_layers.get_base_density();
				const int64_t count = int64_t(p_column.fine[c].count()) * p_row.fine[r].count();
				stands = stands || density > 0.0f;
				grown += int64_t(density * 255.0f * 255.0f) * count;
				texels += count;
				tile.low = std::min(tile.low, 0.0f);
				tile.high = std::max(tile.high, 0.0f);
				continue;
			}
			const MapLayer &layer = p_layers.get_layer(found);
			const auto each = [](const Stretch::Texels &p_i, const Stretch::Texels &p_j, int p_side, const auto &p_visit) {
				for (int j = p_j.first; j <= p_j.last; j++) {
					for (int i = p_i.first; i <= p_i.last; i++) {
						p_visit(size_t(j * p_side + i));
					}
				}
			};
			int cut = MAP_UNCUT_CODE;
			each(p_column.fine[c], p_row.fine[r], MapLayer::FINE, [&](size_t p_texel) {
				const uint8_t *growth = &layer.growth[p_texel * 4];
				stands = stands || growth[0] > 0;
				grown += int64_t(growth[0]) * growth[1];
				texels++;
				cut = std::min(cut, int(growth[2]));
			});
			tile.cut = std::min(tile.cut, float(info_of(MAP_CUT).value(cut)));
			each(p_column.coarse[c], p_row.coarse[r], MapLayer::COARSE, [&](size_t p_texel) {
				const float beyond = layer.ledge.empty() ? 0.0f : beyond_texel(layer, p_texel);
				tile.low = std::min(tile.low, layer.ground[p_texel] - beyond);
				tile.high = std::max(tile.high, layer.ground[p_texel] + beyond);
			});
		}
	}
	tile.grown = float(double(grown) / (double(texels) * 255.0 * 255.0));
	tile.slope = (tile.high - tile.low) / float(std::min(p_column.get_metres(), p_row.get_metres()));
	return stands ? tile : Tile();
}

// Returns the metres between the heights at its ends. At least two texels contribute to any place.
double TileCover::Stretch::get_metres() const {
	int texels = 0;
	for (int c = 0; c < chunks; c++) {
		texels += coarse[size_t(c)].count();
	}
	return (texels - 2 * chunks + 1) * info_of(MAP_GROUND).texel_size(); // at a border both chunks have both texels
}

} // namespace grass
