// SPDX-License-Identifier: MIT
// A record plays as it was, names the tick in which something is different, and survives damage.
#include "field_scene.h"
#include "map_scene.h"

#include "core/field/field_record.h"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TICKS = 40;

// Returns the ticks of a ball that rolls through the grass while a whirl stirs it, with their hashes.
std::vector<TickRecord> record_scene() {
	FieldScene scene;
	std::vector<TickRecord> ticks;
	Force whirl;
	whirl.kind = ForceKind::VORTEX;
	whirl.place = { -4.0, 0.5, 3.0 };
	whirl.duration = 0.0;
	for (int n = 0; n < TICKS; n++) {
		TickRecord tick;
		tick.number = uint32_t(n);
		tick.delta = TICK;
		tick.slots = scene.setup.pool_size;
		tick.params = scene.params;
		whirl.age = n * TICK;
		tick.forces = { whirl };
		scene.put_ball({ 0.05 * n, 0.1, 0.5 }, { 0.05 * std::max(n - 1, 0), 0.1, 0.5 });
		tick.colliders = scene.bodies;
		tick.colliders.push_back(whirl.make_shape(0));
		scene.bodies = tick.colliders;
		scene.field.begin_tick(scene.simulator, true, TICK);
		scene.field.tick(scene.simulator, scene.bodies, TICK, tick.forces);
		tick.hash = scene.simulator.hash();
		ticks.push_back(tick);
	}
	return ticks;
}

// Returns the first tick after which blades are elsewhere than they were.
std::optional<uint32_t> find_difference(std::vector<TickRecord> p_ticks) {
	FieldScene scene;
	for (TickRecord &tick : p_ticks) {
		scene.field.set_params(tick.params);
		scene.field.begin_tick(scene.simulator, true, tick.delta);
		scene.field.tick(scene.simulator, tick.colliders, tick.delta, tick.forces);
		if (scene.simulator.hash() != tick.hash) {
			return tick.number;
		}
	}
	return {};
}

std::vector<uint8_t> bytes_of(const std::vector<TickRecord> &p_ticks) {
	std::vector<uint8_t> bytes;
	for (const TickRecord &tick : p_ticks) {
		write_tick(bytes, tick);
	}
	return bytes;
}

std::vector<TickRecord> ticks_in(std::span<const uint8_t> p_bytes) {
	std::vector<TickRecord> ticks;
	TickRecord tick;
	for (size_t at = 0; at < p_bytes.size() && read_tick(p_bytes, at, tick);) {
		ticks.push_back(tick);
	}
	return ticks;
}

std::vector<uint8_t> file_of(const std::vector<TickRecord> &p_ticks, size_t p_ticks_a_part) {
	std::vector<uint8_t> file = begin_record();
	const auto add = [&file](RecordKind p_kind, std::span<const uint8_t> p_bytes) {
		const std::vector<uint8_t> part = pack_part(p_kind, p_bytes, RUNS);
		file.insert(file.end(), part.begin(), part.end());
	};
	for (size_t at = 0; at < p_ticks.size(); at += p_ticks_a_part) {
		const auto first = p_ticks.begin() + std::ptrdiff_t(at);
		add(RecordKind::TICKS, bytes_of({ first, first + std::ptrdiff_t(std::min(p_ticks_a_part, p_ticks.size() - at)) }));
	}
	const std::string_view end = "was stopped";
	add(RecordKind::END, { reinterpret_cast<const uint8_t *>(end.data()), end.size() });
	return file;
}

// Reads a file whatever is in it, and returns its ticks.
std::vector<TickRecord> read_file(const std::vector<uint8_t> &p_file, RecordReader &r_reader) {
	std::vector<TickRecord> ticks;
	if (r_reader.open(p_file).empty()) {
		while (const std::optional<RecordPart> part = r_reader.read(RUNS)) {
			const std::vector<TickRecord> more = ticks_in(part->bytes);
			ticks.insert(ticks.end(), more.begin(), more.end());
		}
	}
	return ticks;
}

} // namespace

TEST_CASE("field record: what was recorded plays as it was, bit for bit") {
	const std::vector<TickRecord> recorded = record_scene();
	RecordReader reader;
	const std::vector<TickRecord> read = read_file(file_of(recorded, 16), reader);
	CHECK(reader.get_end() == "was stopped");
	CHECK(reader.is_complete());
	CHECK(bytes_of(read) == bytes_of(recorded));
	CHECK(recorded.front().hash != recorded.back().hash); // blades move
	CHECK(!find_difference(read));
}

TEST_CASE("field record: a body or a force that is elsewhere in one tick is found in that tick") {
	std::vector<TickRecord> moved = record_scene(), blown = moved;
	moved[20].colliders[0].now.position.x() += 1e-3;
	CHECK(find_difference(moved).value_or(TICKS) == 20);
	blown[12].forces[0].speed *= 1.01;
	CHECK(find_difference(blown).value_or(TICKS) == 12);
}

TEST_CASE("field record: a file that was cut off is good up to there") {
	const std::vector<TickRecord> recorded = record_scene();
	const std::vector<uint8_t> file = file_of(recorded, 8);
	size_t most = 0;
	for (size_t left_out = file.size(); left_out > 0; left_out -= left_out > 97 ? 97 : 1) {
		const size_t length = file.size() - left_out;
		RecordReader reader;
		const std::vector<TickRecord> read = read_file({ file.begin(), file.begin() + std::ptrdiff_t(length) }, reader);
		CHECK(read.size() % 8 == 0);
		CHECK(read.size() >= most);
		CHECK(!reader.is_broken());
		CHECK(!reader.is_complete());
		CHECK((length < 12 || reader.get_end().starts_with("was cut off")));
		most = read.size();
	}
	CHECK(most == TICKS);
}

TEST_CASE("field record: damage is found, and says where") {
	const std::vector<uint8_t> file = file_of(record_scene(), 8);
	for (size_t at = 12; at < file.size(); at += 101) {
		std::vector<uint8_t> damaged = file;
		damaged[at] ^= 0x10u;
		RecordReader reader;
		const std::vector<TickRecord> read = read_file(damaged, reader);
		CHECK(read.size() <= TICKS);
		CHECK(reader.get_end() != "was stopped");
		CHECK(reader.get_end().find("part ") != std::string::npos);
	}
	RecordReader reader;
	CHECK(reader.open({ 'G', 'R', 'A' }) == "is no record of grass: it does not begin as one");
	std::vector<uint8_t> newer = file;
	newer[8]++;
	CHECK(reader.open(newer).starts_with("has version 2"));
}

TEST_CASE("field record: ticks that no field can have are refused or repaired") {
	TickRecord tick;
	tick.colliders.resize(1);
	const auto is_read = [](const TickRecord &p_tick) { return ticks_in(bytes_of({ p_tick })).size() == 1; };
	CHECK(is_read(tick));
	TickRecord bad = tick;
	bad.colliders[0].force = 0; // there is none
	CHECK(!is_read(bad));
	bad = tick;
	bad.forces.resize(GRASS_MAX_FORCES + 1);
	CHECK(!is_read(bad));
	bad = tick;
	bad.forces.resize(1);
	bad.forces[0].kind = ForceKind(-1);
	CHECK(!is_read(bad));
	bad = tick;
	bad.slots = -5;
	bad.params.solver.natural_frequency = std::nan("");
	bad.params.sleep_delay = -1.0;
	const std::vector<TickRecord> repaired = ticks_in(bytes_of({ bad }));
	REQUIRE(repaired.size() == 1);
	CHECK(repaired[0].slots == 0);
	CHECK(repaired[0].params.solver.natural_frequency == NATURAL_FREQUENCY.initial);
	CHECK(repaired[0].params.sleep_delay == SLEEP_DELAY.minimum);
}
