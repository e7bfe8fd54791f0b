// SPDX-License-Identifier: MIT
#include "core/map/map_layers.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// Texels of a layer that lie in a region: their first and last + 1, with the border counted, along x and z.
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
	return uint8_t(std::clamp(std::round(p_share * 255.0), 0.0, 255.0));
}

// Puts one layer together.
class Composer {
public:
	Composer(const PaintMap &p_map, const MapKey &p_key, int32_t p_uncut) :
			_key(p_key),
			_uncut(p_uncut),
			_density(p_map, MAP_DENSITY),
			_height(p_map, MAP_HEIGHT),
			_cut(p_map, MAP_CUT),
			_wear(p_map, MAP_WEAR),
			_lean(p_map, MAP_LEAN),
			_normal(p_map, MAP_NORMAL),
			_ground(p_map, MAP_GROUND),
			_tint(p_map, MAP_TINT),
			_species(p_map, MAP_SPECIES) {}

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
		return _changed;
	}

private:
	template <typename T> void put(T &r_texel, T p_value) {
		_changed = _changed || r_texel != p_value;
		r_texel = p_value;
	}

	// [Eq M1]
	void compose_fine(int p_i, int p_j, uint8_t *r_texel) {
		const int i = _key.x * GRASS_FINE_TEXELS + p_i - 1, j = _key.z * GRASS_FINE_TEXELS + p_j - 1;
		const double wear = _wear.value(0, i, j), size = info_of(MAP_DENSITY).texel_size();
		put(r_texel[0], to_byte(_density.value(0, i, j) * (1.0 - wear * wear)));
		put(r_texel[1], to_byte(_height.sample(0, { (i + 0.5) * size, (j + 0.5) * size }) * (1.0 - GRASS_WEAR_PRESSES * wear)));
		put(r_texel[2], uint8_t(std::min(_cut.code(0, i, j), _uncut)));
		put(r_texel[3], to_byte(wear));
	}

	void compose_coarse(int p_i, int p_j, size_t p_texel, MapLayer &r_layer) {
		const int i = _key.x * GRASS_COARSE_TEXELS + p_i - 1, j = _key.z * GRASS_COARSE_TEXELS + p_j - 1;
		for (int c = 0; c < 4; c++) {
			put(r_layer.form[p_texel * 4 + size_t(c)], uint8_t(c < 2 ? _lean.code(c, i, j) : _normal.code(c - 2, i, j)));
			// By its strength, so that a colour that does not show has no part in what its neighbours blend to.
			const double strength = c < 3 ? _tint.value(3, i, j) : 1.0;
			put(r_layer.tint[p_texel * 4 + size_t(c)], to_byte(_tint.value(c, i, j) * strength));
		}
		put(r_layer.ground[p_texel], float(_ground.value(0, i, j)));
		put(r_layer.species[p_texel], uint8_t(_species.code(0, i, j)));
	}

	MapKey _key;
	int32_t _uncut;
	MapReader _density, _height, _cut, _wear, _lean, _normal, _ground, _tint, _species;
	bool _changed = false;
};

// The four texels around a point of a layer, and how much each counts.
struct Corners {
	std::array<size_t, 4> texels;
	std::array<float, 4> weights;

	Corners(const Eigen::Array2f &p_texels, int p_side) {
		const Eigen::Array2f corner = (p_texels - 0.5f).floor();
		const Eigen::Array2f t = p_texels - 0.5f - corner;
		const int i = std::clamp(int(corner.x()), 0, p_side - 2), j = std::clamp(int(corner.y()), 0, p_side - 2);
		const size_t first = size_t(j * p_side + i);
		texels = { first, first + 1, first + size_t(p_side), first + size_t(p_side) + 1 };
		weights = { (1.0f - t.x()) * (1.0f - t.y()), t.x() * (1.0f - t.y()), (1.0f - t.x()) * t.y(), t.x() * t.y() };
	}
	template <typename T> float blend(const std::vector<T> &p_values, size_t p_components, size_t p_component) const {
		float sum = 0.0f;
		for (size_t n = 0; n < 4; n++) {
			sum += weights[n] * float(p_values[texels[n] * p_components + p_component]);
		}
		return sum;
	}
};

} // namespace

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

void MapLayers::reset(const TileGrid &p_grid, double p_tallest) {
	_uncut = std::min(int32_t(std::ceil(p_tallest / info_of(MAP_CUT).unit)), MAP_UNCUT_CODE);
	const double half_x = 0.5 * p_grid.get_size_x(), half_z = 0.5 * p_grid.get_size_z();
	const auto chunk = [](double p_place) {
		return std::clamp(int(std::floor(p_place / MAP_CHUNK_SIZE)), -PaintMap::REACH, PaintMap::REACH - 1);
	};
	_first = { chunk(-half_x), chunk(-half_z) };
	_width = chunk(half_x) - _first.x + 1;
	_depth = chunk(half_z) - _first.z + 1;
	_pages.assign(size_t(_width) * size_t(_depth), float(GRASS_NO_LAYER));
	_layers.clear();
	_is_full = false;
}

int MapLayers::find(const MapKey &p_key) const {
	const int x = p_key.x - _first.x, z = p_key.z - _first.z;
	return x < 0 || z < 0 || x >= _width || z >= _depth ? GRASS_NO_LAYER : int(_pages[size_t(z * _width + x)]);
}

std::vector<int> MapLayers::update(const PaintMap &p_map, const MapRegion &p_region) {
	_base_density = float(p_map.get_base_density());
	const MapRegion region = p_region.grown(info_of(MAP_HEIGHT).texel_size()); // borders, and what is blended into finer texels
	const auto clip = [](double p_place, int p_first, int p_count) {
		return int(std::clamp(std::floor(p_place / MAP_CHUNK_SIZE), double(p_first) - 1.0, double(p_first + p_count)));
	};
	std::vector<int> changed;
	for (int z = std::max(clip(region.min.y(), _first.z, _depth), _first.z);
			z <= clip(region.max.y(), _first.z, _depth) && z < _first.z + _depth; z++) {
		for (int x = std::max(clip(region.min.x(), _first.x, _width), _first.x);
				x <= clip(region.max.x(), _first.x, _width) && x < _first.x + _width; x++) {
			const MapKey key{ x, z };
			int layer = find(key);
			const bool is_new = layer == GRASS_NO_LAYER;
			if (is_new && p_map.find(key) == nullptr) {
				continue; // nobody painted there
			}
			if (is_new && _layers.size() >= GRASS_MAX_LAYERS) {
				_is_full = true;
				continue;
			}
			if (is_new) {
				layer = int(_layers.size());
				_pages[size_t((z - _first.z) * _width + x - _first.x)] = float(layer);
				constexpr size_t FINE = size_t(MapLayer::FINE) * MapLayer::FINE, COARSE = size_t(MapLayer::COARSE) * MapLayer::COARSE;
				_layers.push_back({ std::vector<uint8_t>(FINE * 4), std::vector<uint8_t>(COARSE * 4), std::vector<float>(COARSE),
						std::vector<uint8_t>(COARSE * 4), std::vector<uint8_t>(COARSE) });
			}
			const bool differs =
					Composer(p_map, key, _uncut).compose(is_new ? MapRegion::of_chunk(key).grown(1.0) : region, _layers[size_t(layer)]);
			if (differs || is_new) {
				changed.push_back(layer);
			}
		}
	}
	std::sort(changed.begin(), changed.end());
	return changed;
}

int MapLayers::get_species(int p_texel_x, int p_texel_z) const {
	static_assert(GRASS_COARSE_TEXELS == 64);
	const int layer = find({ p_texel_x >> 6, p_texel_z >> 6 });
	return layer == GRASS_NO_LAYER
			? 0
			: _layers[size_t(layer)].species[size_t(((p_texel_z & 63) + 1) * MapLayer::COARSE + (p_texel_x & 63) + 1)];
}

Growth MapLayers::sample(const Eigen::Vector2f &p_place, float p_follow) const {
	Growth here;
	here.density = _base_density;
	const Eigen::Array2f chunk = (p_place.array() / float(MAP_CHUNK_SIZE)).floor();
	if (!chunk.allFinite() || (chunk.abs() > float(PaintMap::REACH)).any()) {
		return here;
	}
	const int layer = find({ int(chunk.x()), int(chunk.y()) });
	if (layer == GRASS_NO_LAYER) {
		return here;
	}
	const MapLayer &texels = _layers[size_t(layer)];
	const Eigen::Array2f share = p_place.array() / float(MAP_CHUNK_SIZE) - chunk;
	const Corners fine(share * float(GRASS_FINE_TEXELS) + 1.0f, MapLayer::FINE),
			coarse(share * float(GRASS_COARSE_TEXELS) + 1.0f, MapLayer::COARSE);
	here.density = fine.blend(texels.growth, 4, 0) / 255.0f;
	here.height = fine.blend(texels.growth, 4, 1) / 255.0f;
	here.cut = fine.blend(texels.growth, 4, 2) / 255.0f * float(MAP_UNCUT);
	here.wear = fine.blend(texels.growth, 4, 3) / 255.0f;
	const auto form = [&](size_t p_component) { return (coarse.blend(texels.form, 4, p_component) - 128.0f) / 127.0f; };
	here.lean = { form(0), form(1) };
	here.tilt = ground_tilt({ form(2), form(3) }, p_follow);
	here.ground = coarse.blend(texels.ground, 1, 0);
	return here;
}

} // namespace grass
