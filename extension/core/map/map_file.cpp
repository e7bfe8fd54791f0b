// SPDX-License-Identifier: MIT
#include "core/map/map_file.h"

#include "core/map/map_bytes.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace grass {

static_assert(std::endian::native == std::endian::little, "texels are stored and written as they are in memory");

namespace {

constexpr char MAGIC[] = "GRASSMAP";
constexpr size_t MAGIC_BYTES = 8, HEADER_BYTES = 20, GRID_BYTES = 4, ENTRY_BYTES = 20, CHECKSUM_BYTES = 4;
constexpr uint32_t ALL_CHANNELS = (1u << MAP_CHANNELS) - 1;

// Converts a channel's texels to their differences from the plane through their neighbours, or (p_back) these to texels. Splits codes of 4
// bytes, lowest bytes first, so that the high bytes, which rarely change, are next to each other.
template <typename Code> void filter(std::span<const uint8_t> p_from, std::span<uint8_t> r_to, const MapChannelInfo &p_info, bool p_back) {
	const size_t side = size_t(p_info.side), components = size_t(p_info.components), plane = side * side;
	for (size_t c = 0; c < components; c++) {
		std::vector<Code> above(side), row(side);
		for (size_t j = 0; j < side; j++) {
			Code left = 0, corner = 0; // in the first row and column only one neighbour is known
			for (size_t i = 0; i < side; i++) {
				const size_t n = j * side + i, texel = (n * components + c) * sizeof(Code);
				const Code predicted = i == 0 ? above[0] : Code(left + above[i] - corner);
				Code change = 0;
				if (p_back) {
					for (size_t b = 0; b < sizeof(Code); b++) {
						change = Code(change | Code(p_from[(c * sizeof(Code) + b) * plane + n]) << (8 * b));
					}
					left = Code(predicted + change);
					std::memcpy(&r_to[texel], &left, sizeof(Code));
				} else {
					std::memcpy(&left, &p_from[texel], sizeof(Code));
					change = Code(left - predicted);
					for (size_t b = 0; b < sizeof(Code); b++) {
						r_to[(c * sizeof(Code) + b) * plane + n] = uint8_t(change >> (8 * b));
					}
				}
				row[i] = left;
				corner = above[i];
			}
			std::swap(above, row);
		}
	}
}

void filter(std::span<const uint8_t> p_from, std::span<uint8_t> r_to, const MapChannelInfo &p_info, bool p_back) {
	p_info.bytes == 1 ? filter<uint8_t>(p_from, r_to, p_info, p_back) : filter<uint32_t>(p_from, r_to, p_info, p_back);
}

uint32_t channels_of(const MapChunk &p_chunk) {
	uint32_t channels = 0;
	for (size_t channel = 0; channel < MAP_CHANNELS; channel++) {
		channels |= p_chunk.channels[channel] ? 1u << channel : 0u;
	}
	return channels;
}

size_t chunk_size(uint32_t p_channels) {
	size_t bytes = 0;
	for (int channel = 0; channel < MAP_CHANNELS; channel++) {
		bytes += (p_channels >> channel & 1u) ? info_of(MapChannel(channel)).chunk_bytes() : 0;
	}
	return bytes;
}

MapBytes pack_chunk(const MapChunk &p_chunk, const MapCodec &p_codec) {
	MapBytes bytes(chunk_size(channels_of(p_chunk)));
	size_t at = 0;
	for (int channel = 0; channel < MAP_CHANNELS; channel++) {
		if (const auto &texels = p_chunk.channels[size_t(channel)]) {
			filter(*texels, std::span(bytes).subspan(at, texels->size()), info_of(MapChannel(channel)), false);
			at += texels->size();
		}
	}
	return p_codec.pack(bytes);
}

// Returns false if these are not the bytes of such a chunk.
bool unpack_chunk(std::span<const uint8_t> p_packed, const MapKey &p_key, uint32_t p_channels, const MapCodec &p_codec, PaintMap &r_map) {
	MapBytes bytes(chunk_size(p_channels));
	if (!p_codec.unpack(p_packed, bytes)) {
		return false;
	}
	size_t at = 0;
	for (int channel = 0; channel < MAP_CHANNELS; channel++) {
		if (p_channels >> channel & 1u) {
			const MapChannelInfo &info = info_of(MapChannel(channel));
			auto texels = std::make_shared<MapTexels>(info.chunk_bytes());
			filter(std::span(bytes).subspan(at, texels->size()), *texels, info, true);
			at += texels->size();
			if (!are_codes(*texels, info) || !r_map.set_texels(p_key, MapChannel(channel), std::move(texels))) {
				return false;
			}
		}
	}
	return true;
}

std::string of_bytes(size_t p_there, size_t p_wanted) {
	return std::to_string(p_there) + " of " + std::to_string(p_wanted) + " bytes are present";
}

struct FileChunk {
	MapKey key;
	uint32_t channels, checksum;
	std::span<const uint8_t> packed;
};

struct FileTable {
	uint32_t base = 0;
	GroundGrid grid;
	std::vector<FileChunk> chunks;
};

// Reads the table. Returns "", or what is wrong with it.
std::string read_file_table(std::span<const uint8_t> p_bytes, FileTable &r_table) {
	if (p_bytes.size() < MAGIC_BYTES + 4 || std::memcmp(p_bytes.data(), MAGIC, MAGIC_BYTES) != 0) {
		return "is not a grass map: it does not begin with \"GRASSMAP\"";
	}
	const uint32_t version = get_u32(p_bytes, MAGIC_BYTES);
	if (version > MAP_FILE_VERSION) {
		return "was saved by a newer version of this addon (format " + std::to_string(version) + ", this one reads up to " +
				std::to_string(MAP_FILE_VERSION) + "). Update the addon to open it";
	}
	if (p_bytes.size() < HEADER_BYTES) {
		return "is cut off: " + of_bytes(p_bytes.size(), HEADER_BYTES) + " of its header";
	}
	r_table.base = get_u32(p_bytes, 12);
	const bool has_grid = version > MAP_FILE_UNGRIDDED && p_bytes.size() >= HEADER_BYTES + GRID_BYTES;
	const size_t begin = HEADER_BYTES + (version > MAP_FILE_UNGRIDDED ? GRID_BYTES : 0);
	const size_t count = get_u32(p_bytes, 16), table_end = begin + count * ENTRY_BYTES;
	if (version == 0 || r_table.base > 255 || count > PaintMap::MAX_CHUNKS ||
			(has_grid && !unpack_ground_grid(get_u32(p_bytes, HEADER_BYTES), r_table.grid))) {
		return "is damaged: its header makes no sense";
	}
	if (p_bytes.size() < table_end + CHECKSUM_BYTES) {
		return "is cut off: " + of_bytes(p_bytes.size(), table_end + CHECKSUM_BYTES) + " of its table of chunks";
	}
	if (get_u32(p_bytes, table_end) != checksum(p_bytes.first(table_end))) {
		return "is damaged: the checksum of its table of chunks is wrong";
	}
	size_t at = table_end + CHECKSUM_BYTES;
	for (size_t n = 0; n < count; n++) {
		const size_t entry = begin + n * ENTRY_BYTES, size = get_u32(p_bytes, entry + 12);
		const auto packed = at + size <= p_bytes.size() ? p_bytes.subspan(at, size) : std::span<const uint8_t>();
		r_table.chunks.push_back({ { int(get_u32(p_bytes, entry)), int(get_u32(p_bytes, entry + 4)) }, get_u32(p_bytes, entry + 8),
				get_u32(p_bytes, entry + 16), packed });
		at += size;
	}
	if (p_bytes.size() < at) {
		return "is cut off: " + of_bytes(p_bytes.size(), at);
	}
	if (p_bytes.size() > at) {
		return "is damaged: it has " + std::to_string(p_bytes.size() - at) + " extra bytes after its end";
	}
	return {};
}

// Returns "", or why the chunks are rejected, judging by the table alone, since each may unpack to a thousand times its bytes.
std::string look_at_chunks(const FileTable &p_table, const ReadLimits &p_limits) {
	size_t bytes = 0;
	for (size_t n = 0; n < p_table.chunks.size(); n++) {
		const FileChunk &chunk = p_table.chunks[n];
		if ((chunk.channels & ~ALL_CHANNELS) != 0) { // the table's checksum is right, so this was written intentionally
			return "was saved by a newer version of this addon: its map has channels that this one does not know. Update the addon to open "
				   "it";
		}
		const std::string place = "(" + std::to_string(chunk.key.x) + ", " + std::to_string(chunk.key.z) + ")";
		if (chunk.channels == 0 || (n > 0 && chunk.key <= p_table.chunks[n - 1].key) || !PaintMap::is_in_reach(chunk.key)) {
			return "is damaged: its chunk " + std::to_string(n + 1) + " of " + std::to_string(p_table.chunks.size()) + ", " + place +
					", makes no sense";
		}
		if (!p_limits.allow(chunk.key)) {
			return "holds chunk " + place + ", which is outside of the ground that it is for";
		}
		bytes += chunk_size(chunk.channels);
	}
	return bytes <= p_limits.map_bytes ? std::string()
									   : "would take " + megabytes(bytes) + " of memory, but a map may take at most " +
					megabytes(p_limits.map_bytes) + p_limits.map_hint;
}

} // namespace

bool are_codes(const MapTexels &p_texels, const MapChannelInfo &p_info) {
	for (size_t i = 0; i < p_texels.size(); i += size_t(p_info.bytes)) {
		int32_t code = p_texels[i];
		if (p_info.bytes == 4) {
			std::memcpy(&code, &p_texels[i], 4);
		}
		if (code < p_info.lowest || code > p_info.highest) {
			return false;
		}
	}
	return true;
}

MapBytes write_map(const PaintMap &p_map, const MapCodec &p_codec) {
	PaintMap map = p_map;
	map.compact();
	MapBytes bytes(MAGIC, MAGIC + MAGIC_BYTES), payload;
	const bool has_grid = !(map.get_ground_grid() == GroundGrid());
	put_u32(bytes, has_grid ? MAP_FILE_VERSION : MAP_FILE_UNGRIDDED);
	put_u32(bytes, uint32_t(map.initial_code(MAP_DENSITY, 0)));
	put_u32(bytes, uint32_t(map.get_chunks().size()));
	if (has_grid) {
		put_u32(bytes, pack_ground_grid(map.get_ground_grid()));
	}
	for (const auto &[key, chunk] : map.get_chunks()) {
		const MapBytes packed = pack_chunk(chunk, p_codec);
		for (const uint32_t value : { uint32_t(key.x), uint32_t(key.z), channels_of(chunk), uint32_t(packed.size()), checksum(packed) }) {
			put_u32(bytes, value);
		}
		payload.insert(payload.end(), packed.begin(), packed.end());
	}
	put_u32(bytes, checksum(bytes));
	bytes.insert(bytes.end(), payload.begin(), payload.end());
	return bytes;
}

std::string read_map(std::span<const uint8_t> p_bytes, const MapCodec &p_codec, PaintMap &r_map, const ReadLimits &p_limits) {
	FileTable table;
	std::string reason = read_file_table(p_bytes, table);
	reason = reason.empty() ? look_at_chunks(table, p_limits) : reason;
	if (!reason.empty()) {
		return reason;
	}
	PaintMap map;
	map.set_base_density(info_of(MAP_DENSITY).value(int32_t(table.base)));
	map.set_ground_grid(table.grid);
	for (size_t n = 0; n < table.chunks.size(); n++) {
		const FileChunk &chunk = table.chunks[n];
		if (checksum(chunk.packed) != chunk.checksum || !unpack_chunk(chunk.packed, chunk.key, chunk.channels, p_codec, map)) {
			return "is damaged: its chunk " + std::to_string(n + 1) + " of " + std::to_string(table.chunks.size()) + " cannot be read";
		}
	}
	r_map = std::move(map);
	return {};
}

} // namespace grass
