// SPDX-License-Identifier: MIT
#include "core/map/map_layers.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

// The four texels around a point of a layer, and their weights.
struct Corners {
	std::array<size_t, 4> texels;
	std::array<float, 4> weights;

	Corners(const Eigen::Array2f &p_texels, int p_side, GroundSplit p_split = GroundSplit::BLENDED) {
		const Eigen::Array2f corner = (p_texels - 0.5f).floor();
		const Eigen::Array2f t = p_texels - 0.5f - corner;
		const int i = std::clamp(int(corner.x()), 0, p_side - 2), j = std::clamp(int(corner.y()), 0, p_side - 2);
		const size_t first = size_t(j * p_side + i);
		texels = { first, first + 1, first + size_t(p_side), first + size_t(p_side) + 1 };
		const glsl::vec4 four = glsl::grass_ground_weights(int(p_split), glsl::vec2(t.x(), t.y()));
		weights = { four.x, four.y, four.z, four.w };
	}
	template <typename T> float blend(const std::vector<T> &p_values, size_t p_components, size_t p_component) const {
		float sum = 0.0f;
		for (size_t n = 0; n < 4; n++) {
			sum += weights[n] * float(p_values[texels[n] * p_components + p_component]);
		}
		return sum;
	}
};

// [Eq M7] Does the same as grass_ledge_at() in shaders/map/map.inc. p_in_chunk: metres; p_offset: of the ground grid, metres.
void look_beside_ledge(
		const MapLayer &p_layer, const glsl::vec2 &p_in_chunk, const glsl::vec2 &p_offset, Growth &r_growth, glsl::vec2 &r_normal) {
	constexpr float SPOTS = float(GRASS_LEDGE_TEXELS / GRASS_CHUNK_SIZE); // along a metre
	const glsl::vec2 place = SPOTS * glsl::grass_ledge_place(p_in_chunk, p_offset);
	const Eigen::Array2i fine = Eigen::Array2f(place.x, place.y).floor().cast<int>().max(0).min(GRASS_LEDGE_TEXELS - 1);
	const int code = p_layer.ledge[size_t(fine.y()) * GRASS_LEDGE_TEXELS + size_t(fine.x())];
	r_growth.ledges = code == 0 ? 2.0f : 1.0f;
	r_growth.density = code == 0 ? 0.0f : r_growth.density;
	if (code == GRASS_LEDGE_NONE) {
		return;
	}
	const Eigen::Array2f between = Eigen::Array2f(p_in_chunk.x - p_offset.x, p_in_chunk.y - p_offset.y) + 0.5f; // texels
	const Eigen::Array2i first = between.floor().cast<int>().max(0).min(MapLayer::COARSE - 2);
	const Eigen::Array2f t = between - between.floor();
	const glsl::vec4 shares = glsl::grass_ledge_weights(code, glsl::vec2(t.x(), t.y()));
	const float weights[] = { shares.x, shares.y, shares.z, shares.w };
	r_growth.ground = 0.0f;
	r_normal = glsl::vec2(0.0f);
	for (int n = 0; n < 4; n++) {
		const int i = n & 1, j = n >> 1;
		const size_t texel = size_t((first.y() + j) * MapLayer::COARSE + first.x() + i);
		const auto along = [&](size_t p_component) { return (float(p_layer.form[texel * 4 + p_component]) - 128.0f) / 127.0f; };
		const glsl::vec2 normal(along(2), along(3)), from(t.x() - float(i), t.y() - float(j));
		static_assert(info_of(MAP_GROUND).texel_size() == 1.0);
		r_growth.ground += weights[n] * glsl::grass_ledge_plane(p_layer.ground[texel], normal, from);
		r_normal = glsl::vec2(r_normal.x + weights[n] * normal.x, r_normal.y + weights[n] * normal.y);
	}
}

} // namespace

MapLayers::MapLayers(const MapPlace &p_place) : _cover(std::make_shared<TileCover>()) {
	begin(p_place);
	_cover->reset(p_place.grid);
	touch(get_region());
}

// Begins with the chunks under a field, all without a layer.
void MapLayers::begin(const MapPlace &p_place) {
	_place = p_place;
	_uncut = std::min(int32_t(std::ceil(p_place.tallest / info_of(MAP_CUT).unit)), MAP_UNCUT_CODE);
	const double half_x = 0.5 * p_place.grid.get_size_x(), half_z = 0.5 * p_place.grid.get_size_z();
	const auto chunk = [](double p_at) {
		return std::clamp(int(std::floor(p_at / MAP_CHUNK_SIZE)), -PaintMap::REACH, PaintMap::REACH - 1);
	};
	_first = { chunk(-half_x), chunk(-half_z) };
	_width = chunk(half_x) - _first.x + 1;
	_depth = chunk(half_z) - _first.z + 1;
	_pages.assign(size_t(_width) * size_t(_depth), float(GRASS_NO_LAYER));
}

void MapLayers::Changes::add(const Changes &p_changes) {
	layers.insert(layers.end(), p_changes.layers.begin(), p_changes.layers.end());
	tiles = tiles.count() == 0 ? p_changes.tiles : (p_changes.tiles.count() == 0 ? tiles : tiles.joined(p_changes.tiles));
}

void MapLayers::touch(const MapRegion &p_region) {
	for (const MapKey &key : get_chunks(p_region)) {
		const MapRegion here = p_region.shared(MapRegion::of_chunk(key).grown(CHANGE_MARGIN));
		const auto [entry, is_new] = _waiting.try_emplace({ key.z, key.x }, here);
		if (!is_new) {
			entry->second = entry->second.joined(here);
		}
	}
}

void MapLayers::touch(const PaintMap &p_before, const PaintMap &p_now) {
	if (p_now.get_base_density() != p_before.get_base_density() || !(p_now.get_ground_grid() == p_before.get_ground_grid())) {
		touch(get_region());
	}
	for (const MapKey &key : p_now.compare(p_before)) {
		touch(MapRegion::of_chunk(key));
	}
}

MapLayers::Changes MapLayers::work(const PaintMap &p_map) {
	Changes changes;
	if (_waiting.empty()) {
		return changes;
	}
	const auto [place, region] = *_waiting.begin();
	_waiting.erase(_waiting.begin());
	if (const int layer = lay_out(p_map, { place.second, place.first }, region); layer != GRASS_NO_LAYER) {
		changes.layers.push_back(layer);
	}
	changes.tiles = _cover->update(*this, region);
	return changes;
}

MapLayers::Changes MapLayers::update(const PaintMap &p_map, const MapRegion &p_region) {
	touch(p_region);
	Changes changes;
	while (get_waiting() > 0) {
		changes.add(work(p_map));
	}
	return changes;
}

bool MapLayers::is_waiting_at(const Eigen::Vector2f &p_place) const {
	const MapKey key = key_at(p_place.cast<double>());
	return _waiting.contains({ key.z, key.x });
}

int MapLayers::count_painted(const PaintMap &p_map) const {
	const std::vector<MapKey> chunks = get_chunks(get_region());
	return int(std::count_if(chunks.begin(), chunks.end(),
			[&](const MapKey &p_key) { return find(p_key) != GRASS_NO_LAYER || p_map.find(p_key) != nullptr; }));
}

size_t MapLayers::get_memory_usage() const {
	constexpr size_t LAYER = size_t(MapLayer::FINE) * MapLayer::FINE * 4 + size_t(MapLayer::COARSE) * MapLayer::COARSE * 13;
	constexpr size_t LEDGES = size_t(GRASS_LEDGE_TEXELS) * GRASS_LEDGE_TEXELS;
	return _layers.size() * LAYER + _ledge_layers.size() * LEDGES + (_cover ? _cover->get_memory_usage() : 0) +
			_pages.size() * sizeof(float);
}

bool MapLayers::has_chunk(const MapKey &p_key) const {
	return p_key.x >= _first.x && p_key.z >= _first.z && p_key.x < _first.x + _width && p_key.z < _first.z + _depth;
}

int MapLayers::find(const MapKey &p_key) const {
	return has_chunk(p_key) ? int(_pages[index_of(p_key)]) : GRASS_NO_LAYER;
}

std::vector<MapKey> MapLayers::get_chunks(const MapRegion &p_region) const {
	const MapRegion region = p_region.grown(CHANGE_MARGIN);
	const auto clip = [](double p_place, int p_first, int p_count) {
		return int(std::clamp(std::floor(p_place / MAP_CHUNK_SIZE), double(p_first) - 1.0, double(p_first + p_count)));
	};
	std::vector<MapKey> chunks;
	for (int z = clip(region.min.y(), _first.z, _depth); z <= clip(region.max.y(), _first.z, _depth); z++) {
		for (int x = clip(region.min.x(), _first.x, _width); x <= clip(region.max.x(), _first.x, _width); x++) {
			if (has_chunk({ x, z })) {
				chunks.push_back({ x, z });
			}
		}
	}
	return chunks;
}

int MapLayers::add_layer(const MapKey &p_key) {
	constexpr size_t FINE = size_t(MapLayer::FINE) * MapLayer::FINE, COARSE = size_t(MapLayer::COARSE) * MapLayer::COARSE;
	_layers.push_back({ std::vector<uint8_t>(FINE * 4), std::vector<uint8_t>(COARSE * 4), std::vector<float>(COARSE),
			std::vector<uint8_t>(COARSE * 4), std::vector<uint8_t>(COARSE), {} });
	const int layer = int(_layers.size()) - 1;
	_pages[index_of(p_key)] = float(layer);
	return layer;
}

// Takes over what holds for the whole map.
void MapLayers::follow(const PaintMap &p_map) {
	_base_density = float(p_map.get_base_density());
	_ground_grid = p_map.get_ground_grid();
}

// Updates a chunk's layer in p_region. Returns the layer if it changed, else GRASS_NO_LAYER.
int MapLayers::lay_out(const PaintMap &p_map, const MapKey &p_key, const MapRegion &p_region) {
	follow(p_map);
	int layer = find(p_key);
	const bool is_new = layer == GRASS_NO_LAYER;
	if (is_new && p_map.find(p_key) == nullptr) {
		return GRASS_NO_LAYER; // nothing is painted there
	}
	if (is_new && _layers.size() >= GRASS_MAX_LAYERS) {
		_is_full = true;
		return GRASS_NO_LAYER;
	}
	if (is_new) {
		layer = add_layer(p_key);
	}
	const MapRegion region = is_new ? MapRegion::of_chunk(p_key) : p_region;
	MapLayer &texels = _layers[size_t(layer)];
	const bool had_ledges = !texels.ledge.empty();
	const bool differs = compose_layer(p_map, p_key, _uncut, region.grown(0.5 * CHANGE_MARGIN), texels);
	if (!had_ledges && !texels.ledge.empty()) {
		_ledge_layers.push_back(layer);
	}
	return differs || is_new ? layer : GRASS_NO_LAYER;
}

void MapLayers::read(const PaintMap &p_map, const MapPlace &p_place, const Eigen::Vector2f &p_at) {
	begin(p_place);
	follow(p_map);
	const Eigen::Vector2d at = p_at.cast<double>();
	const MapKey key = key_at(at);
	if (!has_chunk(key) || p_map.find(key) == nullptr) {
		_layers.clear();
		return;
	}
	if (_layers.empty()) {
		add_layer(key);
	}
	_layers[0].ledge.clear(); // perhaps of another chunk
	_pages[index_of(key)] = 0.0f;
	compose_layer(p_map, key, _uncut, MapRegion{ at, at }.grown(CHANGE_MARGIN), _layers[0]);
}

int MapLayers::get_species(int p_texel_x, int p_texel_z) const {
	static_assert(GRASS_COARSE_TEXELS == 64);
	const int layer = find({ p_texel_x >> 6, p_texel_z >> 6 });
	return layer == GRASS_NO_LAYER
			? 0
			: _layers[size_t(layer)].species[size_t(((p_texel_z & 63) + 1) * MapLayer::COARSE + (p_texel_x & 63) + 1)];
}

Growth MapLayers::sample(const Eigen::Vector2f &p_place) const {
	Growth here = read_texels(p_place);
	here.height *= glsl::grass_sparse_height(here.density, _place.sparse_height);
	return here;
}

Growth MapLayers::read_texels(const Eigen::Vector2f &p_place) const {
	Growth here = glsl::grass_unpainted(_base_density);
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
	static_assert(MAP_CHUNK_SIZE == GRASS_COARSE_TEXELS); // a coarse texel is a metre
	const Eigen::Array2f at_ground = share * float(GRASS_COARSE_TEXELS) + 1.0f - _ground_grid.offset().cast<float>().array();
	const Corners fine(share * float(GRASS_FINE_TEXELS) + 1.0f, MapLayer::FINE), coarse(at_ground, MapLayer::COARSE),
			ground(at_ground, MapLayer::COARSE, _ground_grid.split);
	here.density = fine.blend(texels.growth, 4, 0) / 255.0f;
	here.height = fine.blend(texels.growth, 4, 1) / 255.0f;
	here.cut = fine.blend(texels.growth, 4, 2) / 255.0f * float(MAP_UNCUT);
	here.wear = fine.blend(texels.growth, 4, 3) / 255.0f;
	const auto form = [&](size_t p_component) { return (coarse.blend(texels.form, 4, p_component) - 128.0f) / 127.0f; };
	here.lean = { form(0), form(1) };
	glsl::vec2 normal(form(2), form(3));
	here.ground = ground.blend(texels.ground, 1, 0);
	if (!texels.ledge.empty()) {
		const Eigen::Array2f in_chunk = share * float(MAP_CHUNK_SIZE), offset = _ground_grid.offset().cast<float>();
		look_beside_ledge(texels, { in_chunk.x(), in_chunk.y() }, { offset.x(), offset.y() }, here, normal);
	}
	here.tilt = glsl::grass_ground_tilt(normal, _place.follow);
	here.slope = normal;
	return here;
}

} // namespace grass
