// SPDX-License-Identifier: MIT
#include "map_scene.h"
#include "sampled.h"

#include "core/base/bytes.h"
#include "core/base/lanes.h" // GRASS_IS_SANITIZED
#include "core/map/map_file.h"

#include <doctest/doctest.h>

#include <cstring>
#include <random>

using namespace grass;
using namespace grass::test;

namespace {

// Damaged files that a test tries. Under a sanitizer nearly all: what each makes the reader read is what it is there for.
#if defined(GRASS_IS_SANITIZED)
const int ROUNDS = 150;
#else
const int ROUNDS = sampled(200);
#endif

void put_checksum(MapBytes &r_bytes, size_t p_at, size_t p_begin, size_t p_count) {
	const uint32_t sum = checksum(std::span<const uint8_t>(r_bytes).subspan(p_begin, p_count));
	std::memcpy(&r_bytes[p_at], &sum, 4);
}

// Reads broken bytes into a map that holds something: it must still hold that, and a reason be given.
void check_refused(std::span<const uint8_t> p_bytes, const PaintMap &p_before) {
	PaintMap map = p_before;
	const std::string reason = read_map(p_bytes, RUNS, map);
	CHECK_FALSE(reason.empty());
	CHECK(map.compare(p_before).empty());
	CHECK(map.get_base_density() == p_before.get_base_density());
}

} // namespace

TEST_CASE("map_file: every code comes back, and the same map gives the same bytes") {
	for (uint32_t seed = 1; seed < 6; seed++) {
		const PaintMap map = make_map(seed);
		const MapBytes bytes = write_map(map, RUNS);
		PaintMap read;
		CHECK(read_map(bytes, RUNS, read) == "");
		CHECK(read.compare(map).empty());
		CHECK(read.get_base_density() == map.get_base_density());
		CHECK(write_map(read, RUNS) == bytes);
	}
	PaintMap nothing;
	PaintMap read = make_map(1);
	CHECK(read_map(write_map(nothing, RUNS), RUNS, read) == "");
	CHECK(read.is_empty());
}

TEST_CASE("map_file: even ground and slopes cost next to nothing, whatever their height") {
	PaintMap map;
	for (int j = 0; j < 64; j++) {
		for (int i = 0; i < 64; i++) {
			map.set_code(MAP_GROUND, 0, i, j, 100000 + 300 * i - 77 * j);
		}
	}
	CHECK(info_of(MAP_GROUND).chunk_bytes() == 16384);
	CHECK(write_map(map, RUNS).size() < 1200); // the first row and column are what the plane does not foretell
}

TEST_CASE("map_file: a file cut off anywhere is refused, and says how much is there") {
	const PaintMap before = make_map(9);
	const MapBytes bytes = write_map(make_map(2), RUNS);
	for (size_t size = 0; size < bytes.size(); size += size < 400 ? 1 : 997) {
		check_refused(std::span(bytes).first(size), before);
	}
	PaintMap map;
	CHECK(read_map(std::span(bytes).first(bytes.size() - 1), RUNS, map) ==
			"is cut off: " + std::to_string(bytes.size() - 1) + " of " + std::to_string(bytes.size()) + " bytes are present");
	MapBytes longer = bytes;
	longer.push_back(0);
	CHECK(read_map(longer, RUNS, map) == "is damaged: it has 1 extra bytes after its end");
}

TEST_CASE("map_file: a newer version and another kind of file are told apart from damage") {
	const PaintMap before = make_map(9);
	MapBytes bytes = write_map(make_map(2), RUNS);
	bytes[8] = MAP_FILE_VERSION + 1;
	PaintMap map;
	CHECK(read_map(bytes, RUNS, map).find("newer version") != std::string::npos);
	check_refused(bytes, before);
	bytes[0] = 'g';
	CHECK(read_map(bytes, RUNS, map).find("is not a grass map") != std::string::npos);
	check_refused(bytes, before);
}

TEST_CASE("map_file: a channel that nobody knows here was written by a newer version, even under this version's number") {
	MapBytes bytes = write_map(make_map(2), RUNS);
	uint32_t count;
	std::memcpy(&count, &bytes[16], 4);
	const uint32_t channels = 1u << MAP_CHANNELS;
	std::memcpy(&bytes[20 + 8], &channels, 4);
	PaintMap map;
	CHECK(read_map(bytes, RUNS, map).find("is damaged") != std::string::npos); // the checksum tells of chance
	put_checksum(bytes, 20 + size_t(count) * 20, 0, 20 + size_t(count) * 20);
	CHECK(read_map(bytes, RUNS, map).find("newer version") != std::string::npos);
	check_refused(bytes, make_map(9));
}

TEST_CASE("map_file: the first version is read, too") {
	const PaintMap written = make_map(5);
	MapBytes bytes = write_map(written, RUNS);
	uint32_t count;
	std::memcpy(&count, &bytes[16], 4);
	bytes[8] = 1;
	put_checksum(bytes, 20 + size_t(count) * 20, 0, 20 + size_t(count) * 20);
	PaintMap map;
	CHECK(read_map(bytes, RUNS, map) == "");
	CHECK(map.compare(written).empty());
}

TEST_CASE("map_file: any byte changed is noticed") {
	const PaintMap before = make_map(9);
	const MapBytes good = write_map(make_map(3), RUNS);
	std::mt19937 random(11);
	for (int n = 0; n < ROUNDS; n++) {
		MapBytes bytes = good;
		for (uint32_t changes = 1 + random() % 4; changes > 0; changes--) {
			bytes[random() % bytes.size()] ^= uint8_t(1 + random() % 255);
		}
		check_refused(bytes, before);
	}
}

TEST_CASE("map_file: damage behind right checksums is refused or is a map, and never half of one") {
	const PaintMap before = make_map(9);
	const MapBytes good = write_map(make_map(4), RUNS);
	uint32_t count;
	std::memcpy(&count, &good[16], 4);
	const size_t table_end = 20 + size_t(count) * 20;
	std::mt19937 random(13);
	int refused = 0;
	for (int n = 0; n < ROUNDS; n++) {
		MapBytes bytes = good;
		const bool in_table = n % 2 == 0;
		const size_t at = in_table ? 12 + random() % (table_end - 12) : table_end + 4 + random() % (bytes.size() - table_end - 4);
		bytes[at] = uint8_t(random());
		for (size_t chunk = 0, begin = table_end + 4; chunk < count; chunk++) { // a forger mends the checksums
			uint32_t size;
			std::memcpy(&size, &bytes[20 + chunk * 20 + 12], 4);
			if (size > bytes.size() - begin) {
				break;
			}
			put_checksum(bytes, 20 + chunk * 20 + 16, begin, size);
			begin += size;
		}
		put_checksum(bytes, table_end, 0, table_end);
		PaintMap map = before;
		if (read_map(bytes, RUNS, map).empty()) {
			PaintMap again;
			CHECK(read_map(write_map(map, RUNS), RUNS, again).empty());
			CHECK(again.compare(map).empty());
		} else {
			refused++;
			CHECK(map.compare(before).empty());
		}
	}
	CHECK(refused > ROUNDS / 5);
}

TEST_CASE("map_file: noise of any length is refused") {
	const PaintMap before = make_map(9);
	std::mt19937 random(17);
	for (int n = 0; n < 500; n++) {
		MapBytes bytes(random() % 2000);
		for (uint8_t &byte : bytes) {
			byte = uint8_t(random());
		}
		if (n % 2 == 0 && bytes.size() > 12) { // with a right beginning
			std::memcpy(bytes.data(), "GRASSMAP\1\0\0\0", 12);
		}
		check_refused(bytes, before);
	}
}
