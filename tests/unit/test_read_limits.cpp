// SPDX-License-Identifier: MIT
// What files and messages from elsewhere may take: counted in the bytes that they let the codec unpack.
#include "map_scene.h"
#include "sampled.h"

#include "core/base/bytes.h"
#include "core/map/map_changes.h"

#include <doctest/doctest.h>

#include <cstring>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

const int ROUNDS = sampled(1500);

size_t unpacked = 0; // bytes, since the last count
const MapCodec COUNTING{ pack_runs, [](std::span<const uint8_t> p_packed, std::span<uint8_t> r_bytes) {
							unpacked += r_bytes.size();
							return unpack_runs(p_packed, r_bytes);
						} };

// Returns a map of p_side x p_side chunks in a corner of its reach: a texel of each channel p_channels in each of them.
PaintMap wide_map(int p_side, uint32_t p_channels) {
	PaintMap map, one;
	for (int channel = 0; channel < MAP_CHANNELS; channel++) {
		if (p_channels >> channel & 1u) {
			one.set_code(MapChannel(channel), 0, 5, 5, 1);
		}
	}
	for (int z = 0; z < p_side; z++) {
		for (int x = 0; x < p_side; x++) {
			for (int channel = 0; channel < MAP_CHANNELS; channel++) {
				map.set_texels({ x - PaintMap::REACH, z - PaintMap::REACH }, MapChannel(channel),
						one.find({ 0, 0 })->channels[size_t(channel)]); // shared: this map is small
			}
		}
	}
	return map;
}

constexpr uint32_t ALL = (1u << MAP_CHANNELS) - 1;

size_t bytes_of_chunk(uint32_t p_channels) {
	size_t bytes = 0;
	for (int channel = 0; channel < MAP_CHANNELS; channel++) {
		bytes += (p_channels >> channel & 1u) ? info_of(MapChannel(channel)).chunk_bytes() : 0;
	}
	return bytes;
}

ReadLimits limits_of(size_t p_map, size_t p_changes) {
	ReadLimits limits;
	limits.map_bytes = p_map;
	limits.changes_bytes = p_changes;
	limits.map_hint = " (the map's limit)";
	limits.changes_hint = " (the message's limit)";
	return limits;
}

template <typename Mend> MapBytes mutated(const MapBytes &p_bytes, size_t p_from, std::mt19937 &r_random, const Mend &p_mend) {
	MapBytes bytes = p_bytes;
	for (uint32_t changes = 1 + r_random() % 4; changes > 0; changes--) {
		const size_t at = p_from + r_random() % (bytes.size() - p_from);
		bytes[at] = r_random() % 2 == 0 ? uint8_t(r_random()) : uint8_t(0xff);
	}
	p_mend(bytes);
	return bytes;
}

// As a forger does.
void mend_file(MapBytes &r_bytes) {
	const size_t count = get_u32(r_bytes, 16);
	const size_t table_end = 20 + count * 20;
	if (count > PaintMap::MAX_CHUNKS || table_end + 4 > r_bytes.size()) {
		return;
	}
	size_t begin = table_end + 4;
	for (size_t chunk = 0; chunk < count; chunk++) {
		const size_t size = get_u32(r_bytes, 20 + chunk * 20 + 12);
		if (size > r_bytes.size() - begin) {
			break;
		}
		const uint32_t sum = checksum(std::span<const uint8_t>(r_bytes).subspan(begin, size));
		std::memcpy(&r_bytes[20 + chunk * 20 + 16], &sum, 4);
		begin += size;
	}
	const uint32_t sum = checksum(std::span<const uint8_t>(r_bytes).first(table_end));
	std::memcpy(&r_bytes[table_end], &sum, 4);
}

void mend_changes(MapBytes &r_bytes) {
	const uint32_t sum = checksum(std::span<const uint8_t>(r_bytes).first(r_bytes.size() - 4));
	std::memcpy(&r_bytes[r_bytes.size() - 4], &sum, 4);
}

} // namespace

TEST_CASE("read_limits: a file that would take more than a map may is refused before a byte is unpacked") {
	const PaintMap whole = wide_map(60, ALL);
	const MapBytes bytes = write_map(whole, COUNTING);
	CHECK(bytes.size() * 50 < 3600 * bytes_of_chunk(ALL));
	PaintMap map;
	unpacked = 0;
	const std::string reason = read_map(bytes, COUNTING, map);
	CHECK(reason.find("would take 1449 MB of memory, but a map may take at most 1024 MB") == 0);
	CHECK(unpacked == 0);
	CHECK(map.is_empty());
	CHECK(read_map(bytes, COUNTING, map, limits_of(1000, 1000)).find("may take at most 1 MB (the map's limit)") != std::string::npos);
	const MapBytes small = write_map(wide_map(3, ALL), COUNTING);
	const size_t there = 9 * bytes_of_chunk(ALL);
	unpacked = 0;
	CHECK_FALSE(read_map(small, COUNTING, map, limits_of(there - 1, 0)).empty());
	CHECK(unpacked == 0);
	CHECK(read_map(small, COUNTING, map, limits_of(there, 0)) == "");
	CHECK(unpacked == there);
}

TEST_CASE("read_limits: changes are bounded by what one message may change, and by what the map may take") {
	PaintMap map;
	const MapBytes message = write_changes(map, wide_map(20, ALL), COUNTING); // 169 MB
	unpacked = 0;
	CHECK(apply_changes(message, COUNTING, map).reason.find("would change 161 MB of the map, but one message may change at most 64 MB") ==
			0);
	CHECK(unpacked == 0);
	const size_t chunk = bytes_of_chunk(ALL);
	const MapBytes four = write_changes(map, wide_map(2, ALL), COUNTING);
	CHECK(apply_changes(four, COUNTING, map, limits_of(100 * chunk, 4 * chunk - 1)).reason.find("(the message's limit)") !=
			std::string::npos);
	CHECK(apply_changes(four, COUNTING, map, limits_of(3 * chunk, 4 * chunk)).reason.find("(the map's limit)") != std::string::npos);
	CHECK(unpacked == 0);
	CHECK(map.is_empty());
	CHECK(apply_changes(four, COUNTING, map, limits_of(5 * chunk, 4 * chunk)).reason == "");
	CHECK(unpacked == 4 * chunk);
	PaintMap without = map; // a map above its limit still follows what does not make it larger
	without.set_code(MAP_CUT, 0, 7 - PaintMap::REACH * 128, 7 - PaintMap::REACH * 128, 9);
	CHECK(apply_changes(write_changes(map, without, COUNTING), COUNTING, map, limits_of(chunk, chunk)).reason == "");
}

TEST_CASE("read_limits: chunks beyond the ground that is shown are refused, but for those that the map has") {
	ReadLimits limits;
	limits.regions = { { { -32.0, -32.0 }, { 32.0, 32.0 } } };
	CHECK(limits.allow({ -1, 0 }));
	CHECK_FALSE(limits.allow({ 1, 0 }));
	CHECK_FALSE(limits.allow({ 0, -2 }));
	CHECK_FALSE(ReadLimits().allow({ PaintMap::REACH, 0 }));
	PaintMap near, far;
	near.set_code(MAP_CUT, 0, 3, 3, 7);
	far.set_code(MAP_CUT, 0, 128 * 250, 3, 7);
	PaintMap map;
	CHECK(apply_changes(write_changes(map, far, RUNS), RUNS, map, limits).reason ==
			"do not fit: the cut of chunk (250, 0) is outside of every field that shows this map");
	CHECK(read_map(write_map(far, RUNS), RUNS, map, limits) == "holds chunk (250, 0), which is outside of the ground that it is for");
	CHECK(apply_changes(write_changes(map, near, RUNS), RUNS, map, limits).reason == "");
	map = far;
	PaintMap changed = far;
	changed.set_code(MAP_WEAR, 0, 128 * 250, 9, 7);
	CHECK(apply_changes(write_changes(far, changed, RUNS), RUNS, map, limits).reason == "");
}

TEST_CASE("read_limits: whatever was forged in a file or a message, no more is unpacked than is allowed") {
	constexpr uint32_t SMALL = 1u << MAP_CUT | 1u << MAP_HOLE | 1u << MAP_GROUND; // so that thousands take seconds
	const size_t chunk = bytes_of_chunk(SMALL);
	const ReadLimits limits = limits_of(4 * (chunk + sizeof(MapKey) + sizeof(MapChunk)), 4 * chunk);
	const MapBytes file = write_map(wide_map(2, SMALL), COUNTING), message = write_changes(PaintMap(), wide_map(2, SMALL), COUNTING);
	std::mt19937 random(19);
	int read = 0, applied = 0;
	for (int n = 0; n < ROUNDS; n++) {
		PaintMap map;
		unpacked = 0;
		read += read_map(mutated(file, 12, random, mend_file), COUNTING, map, limits).empty();
		CHECK(unpacked <= limits.map_bytes);
		CHECK(map.get_chunks().size() <= 4);
		unpacked = 0;
		map = PaintMap();
		applied += apply_changes(mutated(message, 12, random, mend_changes), COUNTING, map, limits).reason.empty();
		CHECK(unpacked <= limits.changes_bytes);
		CHECK(map.get_memory_usage() <= limits.map_bytes);
	}
	CHECK(read > ROUNDS / 10); // else only refusals were looked at
	CHECK(applied > ROUNDS / 50);
	MESSAGE("forged and taken: " << read << " files, " << applied << " messages of " << ROUNDS);
}
