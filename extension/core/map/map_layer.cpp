// SPDX-License-Identifier: MIT
#include "core/map/map_layer.h"

#include "core/map/growth.h"

#include <algorithm>

namespace grass {

namespace {

// The texels of a layer in a region: their first and last + 1, counting the border, along x and z.
struct TexelRange {
	int i_begin, i_end, j_begin, j_end;
};

TexelRange texels_in(const MapRegion &p_region, const MapKey &p_key, int p_side) {
	const double size = MAP_CHUNK_SIZE / p_side;
	const Eigen::Array2d corner(p_key.x * MAP_CHUNK_SIZE, p_key.z * MAP_CHUNK_SIZE);
	const auto clip = [p_side](double p_texel) { return int(std::clamp(p_texel, -1.0, p_side + 1.0)) + 1; };
	const Eigen::Array2d low = ((p_region.min.array() - corner) / size).floor(),
						 high = ((p_region.max.array() - corner) / size).floor() + 1.0;
	return { clip(low.x()), clip(high.x()), clip(low.y()), clip(high.y()) };
}

uint8_t to_byte(double p_share) {
	return uint8_t(std::clamp(p_share, 0.0, 1.0) * 255.0 + 0.5); // NOLINT(bugprone-incorrect-roundings): never negative
}

// Composes one layer.
class Composer {
public:
	Composer(const PaintMap &p_map, const MapKey &p_key, int32_t p_uncut) :
			_key(p_key),
			_uncut(p_uncut),
			_grid(p_map.get_ground_grid()),
			_density(p_map, MAP_DENSITY),
			_height(p_map, MAP_HEIGHT),
			_cut(p_map, MAP_CUT),
			_wear(p_map, MAP_WEAR),
			_lean(p_map, MAP_LEAN),
			_normal(p_map, MAP_NORMAL),
			_ground(p_map, MAP_GROUND),
			_hole(p_map, MAP_HOLE),
			_tint(p_map, MAP_TINT),
			_species(p_map, MAP_SPECIES),
			_ledge(p_map, MAP_LEDGE) {
		const MapChunk *chunk = p_map.find(p_key);
		_has_ledges = chunk != nullptr && chunk->channels[MAP_LEDGE];
	}

	bool compose(const MapRegion &p_region, MapLayer &r_layer) {
		_changed = false;
		const TexelRange fine = texels_in(p_region, _key, GRASS_FINE_TEXELS);
		for (int j = fine.j_begin; j < fine.j_end; j++) {
			for (int i = fine.i_begin; i < fine.i_end; i++) {
				compose_fine(i, j, &r_layer.growth[size_t(j * MapLayer::FINE + i) * 4]);
			}
		}
		const TexelRange coarse = texels_in(p_region, _key, GRASS_COARSE_TEXELS);
		for (int j = coarse.j_begin; j < coarse.j_end; j++) {
			for (int i = coarse.i_begin; i < coarse.i_end; i++) {
				compose_coarse(i, j, size_t(j * MapLayer::COARSE + i), r_layer);
			}
		}
		if (_has_ledges || !r_layer.ledge.empty()) {
			compose_ledges(p_region, r_layer.ledge);
		}
		return _changed;
	}

private:
	template <typename T> void put(T &r_texel, T p_value) {
		_changed = _changed || r_texel != p_value;
		r_texel = p_value;
	}

	void compose_ledges(const MapRegion &p_region, std::vector<uint8_t> &r_ledge) {
		constexpr int SIDE = GRASS_LEDGE_TEXELS;
		r_ledge.resize(size_t(SIDE) * SIDE, uint8_t(GRASS_LEDGE_NONE));
		const TexelRange range = texels_in(p_region, _key, SIDE); // counts a border, which the ledges do not have
		for (int j = std::max(range.j_begin - 1, 0); j < std::min(range.j_end - 1, SIDE); j++) {
			for (int i = std::max(range.i_begin - 1, 0); i < std::min(range.i_end - 1, SIDE); i++) {
				put(r_ledge[size_t(j) * SIDE + size_t(i)], uint8_t(_ledge.code(0, _key.x * SIDE + i, _key.z * SIDE + j)));
			}
		}
	}

	// [Eq M1] Composes a texel of what grows.
	void compose_fine(int p_i, int p_j, uint8_t *r_texel) {
		const int i = _key.x * GRASS_FINE_TEXELS + p_i - 1, j = _key.z * GRASS_FINE_TEXELS + p_j - 1;
		const double wear = _wear.value(0, i, j);
		const Eigen::Array2i hole = _grid.texel_below(i, j);
		const bool is_hole = _hole.code(0, hole.x(), hole.y()) != 0;
		put(r_texel[0], is_hole ? uint8_t(0) : to_byte(_density.value(0, i, j) * (1.0 - wear * wear)));
		put(r_texel[1], to_byte(height_at(i, j) * (1.0 - GRASS_WEAR_PRESSES * wear)));
		put(r_texel[2], uint8_t(std::min(_cut.code(0, i, j), _uncut)));
		put(r_texel[3], to_byte(wear));
	}

	// Returns the height at the centre of a fine texel, which is a quarter of a coarse texel from the centre of the coarse texel around it,
	// towards three others.
	double height_at(int p_i, int p_j) {
		static_assert(GRASS_FINE_TEXELS == 2 * GRASS_COARSE_TEXELS);
		const int i = p_i >> 1, j = p_j >> 1, i_next = i + (p_i & 1) * 2 - 1, j_next = j + (p_j & 1) * 2 - 1;
		const int code = 3 * (3 * _height.code(0, i, j) + _height.code(0, i_next, j)) + 3 * _height.code(0, i, j_next) +
				_height.code(0, i_next, j_next);
		return info_of(MAP_HEIGHT).unit / 16.0 * code;
	}

	// Composes form and ground, whose texels lie where the ground's heights do.
	void compose_coarse(int p_i, int p_j, size_t p_texel, MapLayer &r_layer) {
		const int i = _key.x * GRASS_COARSE_TEXELS + p_i - 1, j = _key.z * GRASS_COARSE_TEXELS + p_j - 1;
		const Eigen::Vector2d at = Eigen::Vector2d(i + 0.5, j + 0.5) * info_of(MAP_GROUND).texel_size() + _grid.offset();
		for (int c = 0; c < 4; c++) {
			const auto lean = [&] {
				return _grid.x == 0 && _grid.z == 0 ? _lean.code(c, i, j) : info_of(MAP_LEAN).code(_lean.sample(c, at));
			};
			put(r_layer.form[p_texel * 4 + size_t(c)], uint8_t(c < 2 ? lean() : _normal.code(c - 2, i, j)));
			// Weighted by its strength, so that an invisible colour contributes nothing to its neighbours' blend.
			const double strength = c < 3 ? _tint.value(3, i, j) : 1.0;
			put(r_layer.tint[p_texel * 4 + size_t(c)], to_byte(_tint.value(c, i, j) * strength));
		}
		put(r_layer.ground[p_texel], float(_ground.value(0, i, j)));
		put(r_layer.species[p_texel], uint8_t(_species.code(0, i, j)));
	}

	MapKey _key;
	int32_t _uncut;
	GroundGrid _grid;
	MapReader _density, _height, _cut, _wear, _lean, _normal, _ground, _hole, _tint, _species, _ledge;
	bool _has_ledges = false, _changed = false;
};

} // namespace

bool compose_layer(const PaintMap &p_map, const MapKey &p_key, int32_t p_uncut, const MapRegion &p_region, MapLayer &r_layer) {
	return Composer(p_map, p_key, p_uncut).compose(p_region, r_layer);
}

} // namespace grass
