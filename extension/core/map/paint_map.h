// SPDX-License-Identifier: MIT
// The painted map: what grows where, and what happened to it. Places are x, z in metres from the map's origin, the field's centre. It is
// sparse: only chunks that differ from the initial codes use memory. Copies share their texels until one of them changes, so a snapshot for
// undo costs one pointer for each channel.
#pragma once

#include "core/map/ground_grid.h"
#include "core/map/map_channels.h"

#include <Eigen/Core>

#include <compare>
#include <cstring>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace grass {

// A chunk, which covers x * MAP_CHUNK_SIZE to (x + 1) * MAP_CHUNK_SIZE metres, and z likewise.
struct MapKey {
	int x = 0, z = 0;
	auto operator<=>(const MapKey &) const = default;
};

using MapTexels = std::vector<uint8_t>; // row by row along x, components interleaved

struct MapChunk {
	std::array<std::shared_ptr<const MapTexels>, MAP_CHANNELS> channels; // null: all texels have the initial codes

	bool is_empty() const;
	bool operator==(const MapChunk &p_other) const; // the same codes
};

class PaintMap {
public:
	static constexpr int REACH = 256; // chunks x, z from -REACH to REACH - 1: 16 km to each side
	static constexpr size_t MAX_CHUNKS = 16384; // 67 km^2 painted
	static bool is_in_reach(const MapKey &p_key) { return p_key.x >= -REACH && p_key.z >= -REACH && p_key.x < REACH && p_key.z < REACH; }

	// Sets the density where nothing was painted, 0..1. The default is 0: nothing grows there.
	void set_base_density(double p_density);
	double get_base_density() const;
	// Sets where its heights lie, without moving any (core/paint/move_ground.h does that).
	void set_ground_grid(const GroundGrid &p_grid) { _ground_grid = p_grid; }
	const GroundGrid &get_ground_grid() const { return _ground_grid; }
	int32_t initial_code(MapChannel p_channel, int p_component) const;
	MapTexels initial_texels(MapChannel p_channel) const; // of a chunk

	const std::map<MapKey, MapChunk> &get_chunks() const { return _chunks; }
	std::vector<MapKey> get_keys() const;
	const MapChunk *find(const MapKey &p_key) const; // null: the chunk has the initial codes
	bool uses(MapChannel p_channel) const; // true if any chunk has it

	// Texel i, j of a channel covers i * texel_size to (i + 1) * texel_size metres along x, j along z. The ground's four channels (ground,
	// normal, hole, ledge) are moved from there by the ground grid's offset, and ledges by whole texels of their own.
	int32_t get_code(MapChannel p_channel, int p_component, int p_i, int p_j) const;
	// Sets a code, clamped to the channel's limits. Returns false, and changes nothing, outside the map's reach or if the map is full.
	bool set_code(MapChannel p_channel, int p_component, int p_i, int p_j, int32_t p_code);

	// Returns the channel's value at a place (metres), interpolated between the centres of the four nearest texels if the channel blends,
	// and for ground as its grid says, but never across a ledge. Returns the initial value for a place that is not finite or out of reach.
	double sample(MapChannel p_channel, int p_component, const Eigen::Vector2d &p_place) const;

	// Returns the chunks in which the two differ.
	std::vector<MapKey> compare(const PaintMap &p_other) const;
	// Frees texels that all have the initial codes again, and chunks without texels.
	void compact();
	void drop_empty(); // chunks without texels
	void clear() {
		_chunks.clear();
		_ground_grid = GroundGrid();
	}
	bool is_empty() const { return _chunks.empty(); }
	size_t get_memory_usage() const; // bytes; counts texels that snapshots share in full

	// Replaces a channel of a chunk; null empties it. Returns false if the key is out of reach, the map full or the size wrong.
	bool set_texels(const MapKey &p_key, MapChannel p_channel, std::shared_ptr<const MapTexels> p_texels);

private:
	MapTexels *write(const MapKey &p_key, MapChannel p_channel);

	std::map<MapKey, MapChunk> _chunks;
	int32_t _base_density = info_of(MAP_DENSITY).initial[0];
	GroundGrid _ground_grid;
};

inline int32_t read_code(const uint8_t *p_texels, const MapChannelInfo &p_info, size_t p_index) {
	if (p_info.bytes == 1) {
		return p_texels[p_index];
	}
	int32_t code;
	std::memcpy(&code, p_texels + p_index * 4, 4);
	return code;
}

// Reads texels of one channel; fast if consecutive ones are in the same chunk. Valid until the map changes.
class MapReader {
public:
	MapReader(const PaintMap &p_map, MapChannel p_channel);

	int32_t code(int p_component, int p_i, int p_j) {
		if ((p_i >> _shift) != _key.x || (p_j >> _shift) != _key.z) {
			seek({ p_i >> _shift, p_j >> _shift });
		}
		if (_texels == nullptr) {
			return _initial[size_t(p_component)];
		}
		const int column = p_i & (_info.side - 1), row = p_j & (_info.side - 1);
		return read_code(_texels, _info, size_t(((row << _shift) + column) * _info.components + p_component));
	}
	double value(int p_component, int p_i, int p_j) { return _info.value(code(p_component, p_i, p_j)); }
	double sample(int p_component, const Eigen::Vector2d &p_place);

private:
	void seek(const MapKey &p_key);
	int ledge_code(const Eigen::Vector2d &p_place);
	double sample_between(int p_component, int p_i, int p_j, const Eigen::Array2d &p_t);
	double sample_beside(int p_component, int p_code, int p_i, int p_j, const Eigen::Array2d &p_t);

	const PaintMap &_map;
	const MapChannelInfo &_info;
	MapChannel _channel;
	int _shift; // a chunk has 2^_shift texels on each side
	std::array<int32_t, 4> _initial;
	MapKey _key{ PaintMap::REACH, PaintMap::REACH }; // of _texels; none yet
	const uint8_t *_texels = nullptr;
	MapKey _ledge_key{ PaintMap::REACH, PaintMap::REACH }; // of _ledges; none yet
	const uint8_t *_ledges = nullptr; // the codes of ledges at a place; null: there is no ledge
};

// Returns the chunk that contains texel p_i, p_j of a channel.
MapKey key_of(MapChannel p_channel, int p_i, int p_j);
// Returns the chunk that contains a place (metres); out of reach if the place is.
MapKey key_at(const Eigen::Vector2d &p_place);

} // namespace grass
