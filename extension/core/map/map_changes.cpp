// SPDX-License-Identifier: MIT
#include "core/map/map_changes.h"

#include "core/map/map_bytes.h"

#include <algorithm>
#include <set>

namespace grass {

namespace {

constexpr char CHANGE_MAGIC[] = "GRASSDIF";
constexpr size_t CHANGE_MAGIC_BYTES = 8, CHANGE_HEADER_BYTES = 32, CHANGE_ENTRY_BYTES = 24, CHANGE_CHECKSUM_BYTES = 4;
constexpr size_t MOST_CHANGES = PaintMap::MAX_CHUNKS * MAP_CHANNELS;

struct Change {
	MapKey key;
	MapChannel channel;
	uint32_t before, after; // checksums
	std::span<const uint8_t> packed;

	std::pair<MapKey, int> place() const { return { key, int(channel) }; }
};

struct ChangeTable {
	std::string reason;
	uint32_t base_before = 0, base_after = 0;
	GroundGrid grid_before, grid_after;
	std::vector<Change> list;
};

// Returns null where the map has none.
const MapTexels *find_texels(const PaintMap &p_map, const MapKey &p_key, size_t p_channel) {
	const MapChunk *chunk = p_map.find(p_key);
	return chunk != nullptr ? chunk->channels[p_channel].get() : nullptr;
}

// Returns a channel's texels: the initial ones where the map has none.
MapTexels texels_of(const PaintMap &p_map, const MapKey &p_key, MapChannel p_channel) {
	const MapTexels *texels = find_texels(p_map, p_key, size_t(p_channel));
	return texels != nullptr ? *texels : p_map.initial_texels(p_channel);
}

void combine(MapTexels &r_texels, const MapTexels &p_other) {
	for (size_t i = 0; i < r_texels.size(); i++) {
		r_texels[i] ^= p_other[i];
	}
}

ChangeTable refuse(std::string p_reason) {
	ChangeTable changes;
	changes.reason = std::move(p_reason);
	return changes;
}

// Reads the table and checks everything in it.
ChangeTable read_table(std::span<const uint8_t> p_bytes) {
	if (p_bytes.size() < CHANGE_MAGIC_BYTES + 4 || std::memcmp(p_bytes.data(), CHANGE_MAGIC, CHANGE_MAGIC_BYTES) != 0) {
		return refuse("are not changes of a grass map: they do not begin with \"GRASSDIF\"");
	}
	const uint32_t version = get_u32(p_bytes, CHANGE_MAGIC_BYTES);
	if (version != MAP_CHANGES_VERSION) {
		return refuse("are from another version of this addon (format " + std::to_string(version) + ", this one reads " +
				std::to_string(MAP_CHANGES_VERSION) + "). Server and clients need the same version");
	}
	if (p_bytes.size() < CHANGE_HEADER_BYTES + CHANGE_CHECKSUM_BYTES) {
		return refuse("are cut off in their header");
	}
	const size_t end = p_bytes.size() - CHANGE_CHECKSUM_BYTES;
	if (get_u32(p_bytes, end) != checksum(p_bytes.first(end))) {
		return refuse("are damaged or cut off: their checksum is wrong");
	}
	ChangeTable changes;
	changes.base_before = get_u32(p_bytes, 12);
	changes.base_after = get_u32(p_bytes, 16);
	const size_t count = get_u32(p_bytes, 20);
	const bool has_grids =
			unpack_ground_grid(get_u32(p_bytes, 24), changes.grid_before) && unpack_ground_grid(get_u32(p_bytes, 28), changes.grid_after);
	if (!has_grids || changes.base_before > 255 || changes.base_after > 255 || count > MOST_CHANGES ||
			CHANGE_HEADER_BYTES + count * CHANGE_ENTRY_BYTES > end) {
		return refuse("are damaged: their header makes no sense");
	}
	size_t at = CHANGE_HEADER_BYTES + count * CHANGE_ENTRY_BYTES;
	for (size_t n = 0; n < count; n++) {
		const size_t entry = CHANGE_HEADER_BYTES + n * CHANGE_ENTRY_BYTES, size = get_u32(p_bytes, entry + 20);
		const uint32_t channel = get_u32(p_bytes, entry + 8);
		if (channel >= MAP_CHANNELS || size > end - at) {
			return refuse("are damaged: change " + std::to_string(n + 1) + " of " + std::to_string(count) + " makes no sense");
		}
		changes.list.push_back({ { int(get_u32(p_bytes, entry)), int(get_u32(p_bytes, entry + 4)) }, MapChannel(channel),
				get_u32(p_bytes, entry + 12), get_u32(p_bytes, entry + 16), p_bytes.subspan(at, size) });
		if (n > 0 && changes.list[n].place() <= changes.list[n - 1].place()) { // each place occurs once
			return refuse("are damaged: change " + std::to_string(n + 1) + " of " + std::to_string(count) + " is out of order");
		}
		at += size;
	}
	return at == end ? changes : refuse("are damaged: they have extra bytes after their end");
}

std::string name_of(const Change &p_change) {
	return "the " + std::string(info_of(p_change.channel).name) + " of chunk (" + std::to_string(p_change.key.x) + ", " +
			std::to_string(p_change.key.z) + ")";
}

// Returns "", or why the changes are rejected, judging by their table alone, since each may unpack to a thousand times its bytes.
std::string look_at_changes(const ChangeTable &p_changes, const PaintMap &p_map, const ReadLimits &p_limits) {
	size_t bytes = 0, map_bytes = p_map.get_memory_usage();
	std::set<MapKey> new_chunks;
	bool is_growing = false;
	for (const Change &change : p_changes.list) {
		if (!PaintMap::is_in_reach(change.key)) {
			return "do not fit: " + name_of(change) + " is out of reach";
		}
		if (p_map.find(change.key) == nullptr && !p_limits.allow(change.key)) {
			return "do not fit: " + name_of(change) + " is outside of every field that shows this map";
		}
		const size_t size = info_of(change.channel).chunk_bytes();
		const bool is_new = find_texels(p_map, change.key, size_t(change.channel)) == nullptr;
		bytes += size;
		map_bytes += is_new ? size : 0;
		if (p_map.find(change.key) == nullptr && new_chunks.insert(change.key).second) {
			map_bytes += sizeof(MapKey) + sizeof(MapChunk);
		}
		is_growing = is_growing || is_new;
	}
	if (bytes > p_limits.changes_bytes) {
		return "would change " + megabytes(bytes) + " of the map, but one message may change at most " + megabytes(p_limits.changes_bytes) +
				p_limits.changes_hint;
	}
	return !is_growing || map_bytes <= p_limits.map_bytes ? std::string()
														  : "would make the map take " + megabytes(map_bytes) +
					" of memory, but it may take at most " + megabytes(p_limits.map_bytes) + p_limits.map_hint;
}

// Applies one change. r_map must have its new base density already.
std::string apply(const Change &p_change, const PaintMap &p_before, const MapCodec &p_codec, PaintMap &r_map, bool &r_has_changed) {
	const MapChannelInfo &info = info_of(p_change.channel);
	MapTexels texels = texels_of(p_before, p_change.key, p_change.channel);
	const uint32_t found = checksum(texels);
	if (found != p_change.before && found != p_change.after) {
		return "begin with another state of " + name_of(p_change) +
				": earlier changes are missing, or this map was changed in another way. Copy the whole `data` of the sender";
	}
	r_has_changed = found != p_change.after;
	if (!r_has_changed) { // it was applied before
		return {};
	}
	MapTexels difference(info.chunk_bytes());
	const bool is_whole = p_codec.unpack(p_change.packed, difference);
	combine(texels, difference);
	if (!is_whole || checksum(texels) != p_change.after || !are_codes(texels, info)) {
		return "are damaged: " + name_of(p_change) + " cannot be read";
	}
	const bool is_initial = texels == r_map.initial_texels(p_change.channel);
	const bool has_room =
			r_map.set_texels(p_change.key, p_change.channel, is_initial ? nullptr : std::make_shared<const MapTexels>(std::move(texels)));
	return has_room ? std::string() : "do not fit: " + name_of(p_change) + " has no room: this map is full";
}

} // namespace

MapBytes write_changes(const PaintMap &p_before, const PaintMap &p_after, const MapCodec &p_codec) {
	MapBytes table, payload;
	uint32_t count = 0;
	for (const MapKey &key : p_after.compare(p_before)) {
		for (int n = 0; n < MAP_CHANNELS; n++) {
			const MapChannel channel = MapChannel(n);
			if (find_texels(p_before, key, size_t(n)) == find_texels(p_after, key, size_t(n))) { // shared, or both missing
				continue;
			}
			MapTexels texels = texels_of(p_before, key, channel);
			const MapTexels after = texels_of(p_after, key, channel);
			if (texels == after) {
				continue;
			}
			const uint32_t sums[] = { checksum(texels), checksum(after) };
			combine(texels, after);
			const MapBytes packed = p_codec.pack(texels);
			for (const uint32_t value : { uint32_t(key.x), uint32_t(key.z), uint32_t(n), sums[0], sums[1], uint32_t(packed.size()) }) {
				put_u32(table, value);
			}
			payload.insert(payload.end(), packed.begin(), packed.end());
			count++;
		}
	}
	const uint32_t base_before = uint32_t(p_before.initial_code(MAP_DENSITY, 0)), base = uint32_t(p_after.initial_code(MAP_DENSITY, 0));
	const GroundGrid &grid_before = p_before.get_ground_grid(), &grid = p_after.get_ground_grid();
	if (count == 0 && base_before == base && grid_before == grid) {
		return {};
	}
	MapBytes bytes(CHANGE_MAGIC, CHANGE_MAGIC + CHANGE_MAGIC_BYTES);
	for (const uint32_t value : { MAP_CHANGES_VERSION, base_before, base, count, pack_ground_grid(grid_before), pack_ground_grid(grid) }) {
		put_u32(bytes, value);
	}
	bytes.insert(bytes.end(), table.begin(), table.end());
	bytes.insert(bytes.end(), payload.begin(), payload.end());
	put_u32(bytes, checksum(bytes));
	return bytes;
}

AppliedChanges apply_changes(std::span<const uint8_t> p_bytes, const MapCodec &p_codec, PaintMap &r_map, const ReadLimits &p_limits) {
	AppliedChanges applied;
	const ChangeTable changes = read_table(p_bytes);
	applied.reason = changes.reason.empty() ? look_at_changes(changes, r_map, p_limits) : changes.reason;
	const uint32_t base = uint32_t(r_map.initial_code(MAP_DENSITY, 0));
	if (applied.reason.empty() && base != changes.base_before && base != changes.base_after) {
		applied.reason = "begin with another base density. Copy the whole `data` of the sender";
	}
	const GroundGrid grid = r_map.get_ground_grid();
	if (applied.reason.empty() && !(grid == changes.grid_before) && !(grid == changes.grid_after)) {
		applied.reason = "begin with ground whose heights lie elsewhere. Copy the whole `data` of the sender";
	}
	if (!applied.reason.empty()) {
		return applied;
	}
	PaintMap map = r_map;
	map.set_ground_grid(changes.grid_after);
	map.set_base_density(info_of(MAP_DENSITY).value(int32_t(changes.base_after)));
	applied.has_base_changed = base != changes.base_after || !(grid == changes.grid_after);
	for (const Change &change : changes.list) {
		bool has_changed = false;
		applied.reason = apply(change, r_map, p_codec, map, has_changed);
		if (!applied.reason.empty()) {
			return { applied.reason, {}, false };
		}
		if (has_changed && (applied.changed.empty() || applied.changed.back() != change.key)) {
			applied.changed.push_back(change.key);
		}
	}
	map.drop_empty();
	r_map = std::move(map);
	return applied;
}

} // namespace grass
