// SPDX-License-Identifier: MIT
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

const int ROUNDS = sampled(1000);

// Changes some texels, channels and chunks of a map.
PaintMap changed(const PaintMap &p_map, uint32_t p_seed) {
	PaintMap map = p_map;
	std::mt19937 random(p_seed);
	for (int n = 0; n < 40; n++) {
		const MapChannel channel = MapChannel(random() % MAP_CHANNELS);
		const MapChannelInfo &info = info_of(channel);
		map.set_code(channel, 0, int(random() % uint32_t(info.side)), int(random() % uint32_t(info.side)), int32_t(random() % 256));
	}
	return map;
}

bool are_same(const PaintMap &p_a, const PaintMap &p_b) {
	return write_map(p_a, RUNS) == write_map(p_b, RUNS);
}

// Applies broken or wrong changes: the map stays as it was, and a reason is given.
void check_refused(std::span<const uint8_t> p_bytes, const PaintMap &p_before) {
	PaintMap map = p_before;
	const AppliedChanges applied = apply_changes(p_bytes, RUNS, map);
	CHECK_FALSE(applied.reason.empty());
	CHECK(applied.changed.empty());
	CHECK(map.compare(p_before).empty());
	CHECK(map.get_base_density() == p_before.get_base_density());
}

void mend_checksum(MapBytes &r_bytes) {
	const uint32_t sum = checksum(std::span<const uint8_t>(r_bytes).first(r_bytes.size() - 4));
	std::memcpy(&r_bytes[r_bytes.size() - 4], &sum, 4);
}

} // namespace

TEST_CASE("map_changes: a map follows another one, change by change") {
	PaintMap server = make_map(1), client = server;
	for (uint32_t seed = 10; seed < 20; seed++) {
		const PaintMap before = server;
		server = changed(server, seed);
		if (seed == 13) {
			server.set_base_density(0.75);
		}
		if (seed == 15) {
			server.set_texels({ 0, 0 }, MAP_TINT, nullptr);
		}
		if (seed == 17) {
			server.clear();
		}
		const AppliedChanges applied = apply_changes(write_changes(before, server, RUNS), RUNS, client);
		CHECK(applied.reason == "");
		CHECK(applied.has_base_changed == (seed == 13));
		CHECK(are_same(client, server));
		CHECK(client.get_base_density() == server.get_base_density());
		CHECK(client.is_empty() == server.is_empty()); // texels that are again as at first take no memory
	}
	CHECK(write_changes(server, server, RUNS).empty());
}

TEST_CASE("map_changes: a change of one place is small, and names its chunk") {
	PaintMap before = make_map(2), after = before;
	for (int i = 10; i < 14; i++) {
		after.set_code(MAP_CUT, 0, i, 5, 7);
	}
	const MapBytes bytes = write_changes(before, after, RUNS);
	CHECK(bytes.size() < 400);
	CHECK(10 * bytes.size() < write_map(after, RUNS).size());
	const AppliedChanges applied = apply_changes(bytes, RUNS, before);
	REQUIRE(applied.changed.size() == 1);
	CHECK(applied.changed[0] == MapKey{ 0, 0 });
	CHECK(are_same(before, after));
}

TEST_CASE("map_changes: what comes twice does nothing, what comes too early is refused by name") {
	const PaintMap first = make_map(3);
	PaintMap second = first, third;
	second.set_code(MAP_CUT, 0, 3, 3, 7);
	third = second;
	third.set_code(MAP_CUT, 0, 4, 3, 9);
	const MapBytes one = write_changes(first, second, RUNS), two = write_changes(second, third, RUNS);
	check_refused(two, first);
	PaintMap client = first;
	CHECK(apply_changes(two, RUNS, client).reason.find("another state of the cut of chunk (0, 0)") != std::string::npos);
	CHECK(apply_changes(one, RUNS, client).reason == "");
	const AppliedChanges again = apply_changes(one, RUNS, client);
	CHECK(again.reason == "");
	CHECK(again.changed.empty());
	CHECK(are_same(client, second));
	CHECK(apply_changes(two, RUNS, client).reason == "");
	CHECK(are_same(client, third));
	check_refused(one, client); // it would bring back what was
	PaintMap elsewhere = second; // changes of other places may come in any order
	elsewhere.set_code(MAP_WEAR, 0, -5, -5, 9);
	client = first;
	CHECK(apply_changes(write_changes(second, elsewhere, RUNS), RUNS, client).reason == "");
	CHECK(apply_changes(one, RUNS, client).reason == "");
	CHECK(are_same(client, elsewhere));
}

TEST_CASE("map_changes: another base density, version or kind of bytes is told") {
	const PaintMap before = make_map(4), after = changed(before, 5);
	const MapBytes good = write_changes(before, after, RUNS);
	PaintMap other = before;
	other.set_base_density(1.0);
	check_refused(good, other);
	MapBytes bytes = good;
	bytes[8]++;
	mend_checksum(bytes);
	CHECK(apply_changes(bytes, RUNS, other).reason.find("another version") != std::string::npos);
	check_refused(write_map(before, RUNS), before);
	check_refused({}, before);
	for (size_t size = 0; size < good.size(); size += size < 400 ? 1 : 97) {
		check_refused(std::span(good).first(size), before);
	}
}

TEST_CASE("map_changes: a full map, and a chunk out of reach") {
	PaintMap before, after;
	after.set_code(MAP_CUT, 0, 3, 3, 7);
	MapBytes bytes = write_changes(before, after, RUNS);
	const int32_t far = PaintMap::REACH;
	std::memcpy(&bytes[32], &far, 4);
	mend_checksum(bytes);
	check_refused(bytes, before);
	CHECK(apply_changes(bytes, RUNS, before).reason.find("is out of reach") != std::string::npos);
}

TEST_CASE("map_changes: any byte changed is noticed; behind right checksums it is refused or is a map") {
	const PaintMap before = make_map(6), after = changed(before, 7);
	const MapBytes good = write_changes(before, after, RUNS);
	std::mt19937 random(11);
	int refused = 0;
	for (int n = 0; n < ROUNDS; n++) {
		MapBytes bytes = good;
		for (uint32_t changes = 1 + random() % 4; changes > 0; changes--) {
			bytes[random() % bytes.size()] ^= uint8_t(1 + random() % 255);
		}
		check_refused(bytes, before);
		bytes = good;
		bytes[12 + random() % (bytes.size() - 16)] = uint8_t(random());
		mend_checksum(bytes); // as a forger does
		PaintMap map = before;
		if (apply_changes(bytes, RUNS, map).reason.empty()) {
			PaintMap again;
			CHECK(read_map(write_map(map, RUNS), RUNS, again).empty());
		} else {
			refused++;
			CHECK(map.compare(before).empty());
		}
	}
	CHECK(refused > ROUNDS / 2);
	for (int n = 0; n < 300; n++) {
		MapBytes noise(random() % 2000);
		for (uint8_t &byte : noise) {
			byte = uint8_t(random());
		}
		if (noise.size() > 28) { // with a right beginning and a right end
			std::memcpy(noise.data(), "GRASSDIF\1\0\0\0", 12);
			mend_checksum(noise);
		}
		check_refused(noise, before);
	}
}
