// SPDX-License-Identifier: MIT
#include "core/map/map_file.h"

#include "core/map/map_bytes.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace grass {

static_assert(std::endian::native == std::endian::little, "texels are kept and written as they lie in memory");

namespace {

constexpr char MAGIC[] = "GRASSMAP";
constexpr size_t MAGIC_BYTES = 8, HEADER_BYTES = 20, ENTRY_BYTES = 20, CHECKSUM_BYTES = 4;
constexpr uint32_t ALL_CHANNELS = (1u << MAP_CHANNELS) - 1;

// Turns a channel's texels into their differences from the plane through their neighbours, or (p_back) these into texels.
// Splits codes of 4 bytes, lowest bytes first, so that the high ones, which rarely change, lie together.
template <typename Code> void filter(std::span<const uint8_t> p_from, std::span<uint8_t> r_to, const MapChannelInfo &p_info, bool p_back) {
	const size_t side = size_t(p_info.side), components = size_t(p_info.components), plane = side * side;
	std::vector<Code> texels(plane);
	const auto predicted = [&](size_t p_i, size_t p_j) {
		const Code left = p_i > 0 ? texels[p_j * side + p_i - 1] : Code(0), above = p_j > 0 ? texels[(p_j - 1) * side + p_i] : Code(0);
		const Code corner = p_i > 0 && p_j > 0 ? texels[(p_j - 1) * side + p_i - 1] : Code(0);
		return Code(p_j == 0 ? left : (p_i == 0 ? above : left + above - corner));
	};
	for (size_t c = 0; c < components; c++) {
		for (size_t j = 0; j < side; j++) {
			for (size_t i = 0; i < side; i++) {
				const size_t n = j * side + i, texel = (n * components + c) * sizeof(Code);
				if (p_back) {
					Code change = 0;
					for (size_t b = 0; b < sizeof(Code); b++) {
						change = Code(change | Code(p_from[(c * sizeof(Code) + b) * plane + n]) << (8 * b));
					}
					texels[n] = Code(predicted(i, j) + change);
					std::memcpy(&r_to[texel], &texels[n], sizeof(Code));
				} else {
					std::memcpy(&texels[n], &p_from[texel], sizeof(Code));
					const Code change = Code(texels[n] - predicted(i, j));
					for (size_t b = 0; b < sizeof(Code); b++) {
						r_to[(c * sizeof(Code) + b) * plane + n] = uint8_t(change >> (8 * b));
					}
				}
			}
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

// False if the bytes are not those of such a chunk.
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
	return std::to_string(p_there) + " of " + std::to_string(p_wanted) + " bytes are there";
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
	put_u32(bytes, MAP_FILE_VERSION);
	put_u32(bytes, uint32_t(map.initial_code(MAP_DENSITY, 0)));
	put_u32(bytes, uint32_t(map.get_chunks().size()));
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

std::string read_map(std::span<const uint8_t> p_bytes, const MapCodec &p_codec, PaintMap &r_map) {
	if (p_bytes.size() < MAGIC_BYTES + 4 || std::memcmp(p_bytes.data(), MAGIC, MAGIC_BYTES) != 0) {
		return "is no grass map: it does not begin with \"GRASSMAP\"";
	}
	const uint32_t version = get_u32(p_bytes, MAGIC_BYTES);
	if (version > MAP_FILE_VERSION) {
		return "was saved by a newer version of this addon (format " + std::to_string(version) + ", this one reads up to " +
				std::to_string(MAP_FILE_VERSION) + "). Update the addon to open it";
	}
	if (p_bytes.size() < HEADER_BYTES) {
		return "is cut off: " + of_bytes(p_bytes.size(), HEADER_BYTES) + " of its header";
	}
	const uint32_t base = get_u32(p_bytes, 12), count = get_u32(p_bytes, 16);
	const size_t table_end = HEADER_BYTES + size_t(count) * ENTRY_BYTES;
	if (version == 0 || base > 255 || count > PaintMap::MAX_CHUNKS) {
		return "is damaged: its header makes no sense";
	}
	if (p_bytes.size() < table_end + CHECKSUM_BYTES) {
		return "is cut off: " + of_bytes(p_bytes.size(), table_end + CHECKSUM_BYTES) + " of its table of chunks";
	}
	if (get_u32(p_bytes, table_end) != checksum(p_bytes.first(table_end))) {
		return "is damaged: the checksum of its table of chunks is wrong";
	}
	size_t wanted = table_end + CHECKSUM_BYTES;
	for (size_t n = 0; n < count; n++) {
		wanted += get_u32(p_bytes, HEADER_BYTES + n * ENTRY_BYTES + 12);
	}
	if (p_bytes.size() < wanted) {
		return "is cut off: " + of_bytes(p_bytes.size(), wanted);
	}
	if (p_bytes.size() > wanted) {
		return "is damaged: it goes on for " + std::to_string(p_bytes.size() - wanted) + " bytes after its end";
	}
	PaintMap map;
	map.set_base_density(info_of(MAP_DENSITY).value(int32_t(base)));
	size_t at = table_end + CHECKSUM_BYTES;
	for (size_t n = 0; n < count; n++) {
		const size_t entry = HEADER_BYTES + n * ENTRY_BYTES;
		const MapKey key{ int(get_u32(p_bytes, entry)), int(get_u32(p_bytes, entry + 4)) };
		const uint32_t channels = get_u32(p_bytes, entry + 8);
		const auto packed = p_bytes.subspan(at, get_u32(p_bytes, entry + 12));
		at += packed.size();
		if ((channels & ~ALL_CHANNELS) != 0) { // the table's checksum is right, so this was written on purpose
			return "was saved by a newer version of this addon: its map has channels that this one does not know. Update the addon to open "
				   "it";
		}
		const bool is_sound = channels != 0 && map.find(key) == nullptr;
		if (!is_sound || checksum(packed) != get_u32(p_bytes, entry + 16) || !unpack_chunk(packed, key, channels, p_codec, map)) {
			return "is damaged: its chunk " + std::to_string(n + 1) + " of " + std::to_string(count) + " cannot be read";
		}
	}
	r_map = std::move(map);
	return {};
}

} // namespace grass
