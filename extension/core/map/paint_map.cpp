// SPDX-License-Identifier: MIT
#include "core/map/paint_map.h"

#include "core/map/growth.h"

#include <algorithm>
#include <bit>
#include <set>

namespace grass {

namespace {

// The upper bits of a texel's number are its chunk's key.
static_assert(std::all_of(MAP_CHANNEL_INFO.begin(), MAP_CHANNEL_INFO.end(),
		[](const MapChannelInfo &p_info) { return std::has_single_bit(unsigned(p_info.side)); }));

void write_code(uint8_t *r_texels, const MapChannelInfo &p_info, size_t p_index, int32_t p_code) {
	if (p_info.bytes == 1) {
		r_texels[p_index] = uint8_t(p_code);
	} else {
		std::memcpy(r_texels + p_index * 4, &p_code, 4);
	}
}

size_t index_of(const MapChannelInfo &p_info, const MapKey &p_key, int p_component, int p_i, int p_j) {
	const size_t column = size_t(p_i - p_key.x * p_info.side), row = size_t(p_j - p_key.z * p_info.side);
	return (row * size_t(p_info.side) + column) * size_t(p_info.components) + size_t(p_component);
}

// Returns where a channel keeps what is at p_place.
Eigen::Vector2d place_in(MapChannel p_channel, const GroundGrid &p_grid, const Eigen::Vector2d &p_place) {
	const Eigen::Vector2d offset = p_grid.offset();
	if (p_channel == MAP_LEDGE) {
		const glsl::vec2 moved = glsl::grass_ledge_place(glsl::vec2(0.0f), glsl::vec2(float(offset.x()), float(offset.y())));
		return p_place + Eigen::Vector2d(moved.x, moved.y);
	}
	return p_channel == MAP_GROUND || p_channel == MAP_NORMAL || p_channel == MAP_HOLE ? Eigen::Vector2d(p_place - offset) : p_place;
}

// Returns whether two channels hold the same codes. A null channel has the initial codes.
bool same(const std::shared_ptr<const MapTexels> &p_a, const std::shared_ptr<const MapTexels> &p_b) {
	return p_a == p_b || (p_a && p_b && *p_a == *p_b);
}

} // namespace

MapKey key_of(MapChannel p_channel, int p_i, int p_j) {
	const int shift = std::countr_zero(unsigned(info_of(p_channel).side));
	return { p_i >> shift, p_j >> shift };
}

MapKey key_at(const Eigen::Vector2d &p_place) {
	const Eigen::Array2d chunk = (p_place.array() / MAP_CHUNK_SIZE).floor();
	if (!chunk.allFinite() || (chunk.abs() > double(PaintMap::REACH)).any()) {
		return { PaintMap::REACH, PaintMap::REACH };
	}
	return { int(chunk.x()), int(chunk.y()) };
}

bool MapChunk::is_empty() const {
	return std::none_of(channels.begin(), channels.end(), [](const auto &p_texels) { return p_texels != nullptr; });
}

bool MapChunk::operator==(const MapChunk &p_other) const {
	return std::equal(channels.begin(), channels.end(), p_other.channels.begin(), same);
}

void PaintMap::set_base_density(double p_density) {
	_base_density = info_of(MAP_DENSITY).code(p_density);
}

double PaintMap::get_base_density() const {
	return info_of(MAP_DENSITY).value(_base_density);
}

int32_t PaintMap::initial_code(MapChannel p_channel, int p_component) const {
	return p_channel == MAP_DENSITY ? _base_density : info_of(p_channel).initial[size_t(p_component)];
}

MapTexels PaintMap::initial_texels(MapChannel p_channel) const {
	const MapChannelInfo &info = info_of(p_channel);
	MapTexels texels(info.chunk_bytes());
	for (size_t i = 0; i < size_t(info.side * info.side * info.components); i++) {
		write_code(texels.data(), info, i, initial_code(p_channel, int(i) % info.components));
	}
	return texels;
}

void PaintMap::drop_empty() {
	std::erase_if(_chunks, [](const auto &p_entry) { return p_entry.second.is_empty(); });
}

std::vector<MapKey> PaintMap::get_keys() const {
	std::vector<MapKey> keys;
	for (const auto &[key, chunk] : _chunks) {
		keys.push_back(key);
	}
	return keys;
}

const MapChunk *PaintMap::find(const MapKey &p_key) const {
	const auto found = _chunks.find(p_key);
	return found == _chunks.end() ? nullptr : &found->second;
}

bool PaintMap::uses(MapChannel p_channel) const {
	return std::any_of(
			_chunks.begin(), _chunks.end(), [p_channel](const auto &p_entry) { return p_entry.second.channels[size_t(p_channel)]; });
}

int32_t PaintMap::get_code(MapChannel p_channel, int p_component, int p_i, int p_j) const {
	return MapReader(*this, p_channel).code(p_component, p_i, p_j);
}

bool PaintMap::set_code(MapChannel p_channel, int p_component, int p_i, int p_j, int32_t p_code) {
	const MapChannelInfo &info = info_of(p_channel);
	const MapKey key = key_of(p_channel, p_i, p_j);
	if (!PaintMap::is_in_reach(key)) {
		return false;
	}
	const int32_t code = std::clamp(p_code, info.lowest, info.highest);
	if (code == get_code(p_channel, p_component, p_i, p_j)) {
		return true; // an unused chunk stays unused
	}
	MapTexels *texels = write(key, p_channel);
	if (texels == nullptr) {
		return false;
	}
	write_code(texels->data(), info, index_of(info, key, p_component, p_i, p_j), code);
	return true;
}

namespace {

// A count of 1 alone does not ensure that another thread, which held the texels until now, has finished reading them. Taking and releasing
// a share of them, as that thread did, orders its reads before our writes.
bool is_sole_owner(const std::shared_ptr<const MapTexels> &p_texels) {
	if (p_texels.use_count() > 1) {
		return false;
	}
	std::shared_ptr<const MapTexels>(p_texels).reset();
	return true;
}

} // namespace

// Returns the chunk's own texels: made if it has none, copied if a snapshot shares them. Returns null if the map is full.
MapTexels *PaintMap::write(const MapKey &p_key, MapChannel p_channel) {
	if (_chunks.size() >= MAX_CHUNKS && find(p_key) == nullptr) {
		return nullptr;
	}
	std::shared_ptr<const MapTexels> &texels = _chunks[p_key].channels[size_t(p_channel)];
	if (!texels) {
		texels = std::make_shared<const MapTexels>(initial_texels(p_channel));
	} else if (!is_sole_owner(texels)) {
		texels = std::make_shared<MapTexels>(*texels);
	}
	return const_cast<MapTexels *>(texels.get()); // nothing else holds it
}

bool PaintMap::set_texels(const MapKey &p_key, MapChannel p_channel, std::shared_ptr<const MapTexels> p_texels) {
	const bool is_new = find(p_key) == nullptr;
	if (!PaintMap::is_in_reach(p_key) || (p_texels && p_texels->size() != info_of(p_channel).chunk_bytes()) ||
			(is_new && _chunks.size() >= MAX_CHUNKS)) {
		return false;
	}
	if (p_texels || !is_new) {
		_chunks[p_key].channels[size_t(p_channel)] = std::move(p_texels);
	}
	return true;
}

double PaintMap::sample(MapChannel p_channel, int p_component, const Eigen::Vector2d &p_place) const {
	return MapReader(*this, p_channel).sample(p_component, p_place);
}

std::vector<MapKey> PaintMap::compare(const PaintMap &p_other) const {
	std::set<MapKey> keys;
	for (const PaintMap *map : { this, &p_other }) {
		for (const auto &[key, chunk] : map->_chunks) {
			keys.insert(key);
		}
	}
	std::vector<MapKey> different;
	for (const MapKey &key : keys) {
		const MapChunk *one = find(key), *other = p_other.find(key);
		if (!((one ? *one : MapChunk()) == (other ? *other : MapChunk()))) {
			different.push_back(key);
		}
	}
	return different;
}

void PaintMap::compact() {
	for (auto entry = _chunks.begin(); entry != _chunks.end();) {
		for (int channel = 0; channel < MAP_CHANNELS; channel++) {
			const MapChannelInfo &info = info_of(MapChannel(channel));
			std::shared_ptr<const MapTexels> &texels = entry->second.channels[size_t(channel)];
			const auto is_initial = [&](size_t p_index) {
				return read_code(texels->data(), info, p_index) == initial_code(MapChannel(channel), int(p_index) % info.components);
			};
			bool unusual = false;
			for (size_t i = 0; texels && !unusual && i < size_t(info.side * info.side * info.components); i++) {
				unusual = !is_initial(i);
			}
			if (!unusual) {
				texels.reset();
			}
		}
		entry = entry->second.is_empty() ? _chunks.erase(entry) : std::next(entry);
	}
}

size_t PaintMap::get_memory_usage() const {
	size_t bytes = 0;
	for (const auto &[key, chunk] : _chunks) {
		bytes += sizeof(key) + sizeof(chunk);
		for (const auto &texels : chunk.channels) {
			bytes += texels ? texels->size() : 0;
		}
	}
	return bytes;
}

MapReader::MapReader(const PaintMap &p_map, MapChannel p_channel) :
		_map(p_map), _info(info_of(p_channel)), _channel(p_channel), _shift(std::countr_zero(unsigned(_info.side))) {
	for (int component = 0; component < 4; component++) {
		_initial[size_t(component)] = _map.initial_code(_channel, component);
	}
}

void MapReader::seek(const MapKey &p_key) {
	const MapChunk *chunk = _map.find(p_key);
	const MapTexels *texels = chunk ? chunk->channels[size_t(_channel)].get() : nullptr;
	_texels = texels ? texels->data() : nullptr;
	_key = p_key;
}

int MapReader::ledge_code(const Eigen::Vector2d &p_place) {
	const Eigen::Vector2d place = place_in(MAP_LEDGE, _map.get_ground_grid(), p_place);
	const MapKey key = key_at(place);
	if (key != _ledge_key) {
		const MapChunk *chunk = _map.find(key);
		_ledge_key = key;
		_ledges = chunk != nullptr && chunk->channels[MAP_LEDGE] ? chunk->channels[MAP_LEDGE]->data() : nullptr;
	}
	if (_ledges == nullptr) {
		return GRASS_LEDGE_NONE;
	}
	constexpr const MapChannelInfo &LEDGE = info_of(MAP_LEDGE);
	const Eigen::Array2i texel = (place.array() / LEDGE.texel_size()).floor().cast<int>();
	return _ledges[size_t(texel.y() & (LEDGE.side - 1)) * size_t(LEDGE.side) + size_t(texel.x() & (LEDGE.side - 1))];
}

// [Eq M7] Samples the ground beside a ledge. p_i, p_j: the first of the four texels around the place; p_t: share of the way towards the
// others.
double MapReader::sample_beside(int p_component, int p_code, int p_i, int p_j, const Eigen::Array2d &p_t) {
	const glsl::vec4 shares = glsl::grass_ledge_weights(p_code, glsl::vec2(float(p_t.x()), float(p_t.y())));
	const double weights[] = { double(shares.x), double(shares.y), double(shares.z), double(shares.w) };
	MapReader normals(_map, MAP_NORMAL);
	double sum = 0.0;
	for (int n = 0; n < 4; n++) {
		const int di = n & 1, dj = n >> 1;
		double here = value(p_component, p_i + di, p_j + dj);
		if (_channel == MAP_GROUND) {
			const glsl::vec2 normal(float(normals.value(0, p_i + di, p_j + dj)), float(normals.value(1, p_i + di, p_j + dj)));
			const Eigen::Array2d from = (p_t - Eigen::Array2d(di, dj)) * _info.texel_size();
			here = double(glsl::grass_ledge_plane(float(here), normal, glsl::vec2(float(from.x()), float(from.y()))));
		}
		sum += weights[n] * here;
	}
	return sum;
}

double MapReader::sample(int p_component, const Eigen::Vector2d &p_place) {
	if (!PaintMap::is_in_reach(key_at(p_place))) {
		return _info.value(_map.initial_code(_channel, p_component));
	}
	const Eigen::Array2d place = place_in(_channel, _map.get_ground_grid(), p_place).array() / _info.texel_size();
	if (!_info.blends) {
		const Eigen::Array2d texel = place.floor();
		return value(p_component, int(texel.x()), int(texel.y()));
	}
	const Eigen::Array2d between = place - 0.5; // texel centres have integer coordinates
	const Eigen::Array2d corner = between.floor(), t = between - corner;
	const int i = int(corner.x()), j = int(corner.y());
	if (_channel == MAP_GROUND || _channel == MAP_NORMAL) {
		if (const int code = ledge_code(p_place); code != GRASS_LEDGE_NONE) {
			return sample_beside(p_component, code, i, j, t);
		}
	}
	return sample_between(p_component, i, j, t);
}

// Samples between four texels. p_i, p_j, p_t: as above.
double MapReader::sample_between(int p_component, int p_i, int p_j, const Eigen::Array2d &p_t) {
	const double first = value(p_component, p_i, p_j), along_x = value(p_component, p_i + 1, p_j),
				 along_z = value(p_component, p_i, p_j + 1), across = value(p_component, p_i + 1, p_j + 1);
	const GroundSplit split = _channel == MAP_GROUND ? _map.get_ground_grid().split : GroundSplit::BLENDED;
	if (split != GroundSplit::BLENDED) {
		const glsl::vec4 weights = glsl::grass_ground_weights(int(split), glsl::vec2(float(p_t.x()), float(p_t.y())));
		return first + double(weights.y) * (along_x - first) + double(weights.z) * (along_z - first) + double(weights.w) * (across - first);
	}
	const double near_row = first * (1.0 - p_t.x()) + along_x * p_t.x(), far_row = along_z * (1.0 - p_t.x()) + across * p_t.x();
	return near_row * (1.0 - p_t.y()) + far_row * p_t.y();
}

} // namespace grass
