// SPDX-License-Identifier: MIT
#include "core/field/knot_watch.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace grass;

namespace {

// Tile 7 is awake, all others rest.
int slot_of(int p_tile) {
	return p_tile == 7 ? 3 : GRASS_NO_SLOT;
}

WantedBlade blade(int p_tile, int p_blade) {
	return { number_of(p_tile, p_blade), slot_of(p_tile) };
}

// What a device would tell of them: the step, the blade and the place of each number.
KnotWatch::Answer answer_to(const std::vector<WantedBlade> &p_blades, uint64_t p_step) {
	KnotWatch::Answer answer{ p_step, {}, {} };
	for (const WantedBlade &wanted : p_blades) {
		answer.blades.push_back(wanted.number);
		for (int i = 0; i < KNOT_NUMBERS; i++) {
			answer.knots.push_back(float(p_step) + 0.001f * float(blade_in_tile(wanted.number)) + 10.0f * float(i));
		}
	}
	return answer;
}

} // namespace

TEST_CASE("knot watch: nothing is read while nobody asks") {
	KnotWatch watch;
	CHECK(!watch.is_due(1));
	CHECK(watch.get_age(9) == 0);
	CHECK(!watch.ask(blade(2, 0)));
	CHECK(watch.is_due(1)); // its tile may wake with the next step
	CHECK(watch.begin_read(1, slot_of).empty());
	CHECK(!watch.is_due(1)); // it did not
}

TEST_CASE("knot watch: who asks is told what came last") {
	KnotWatch watch;
	CHECK(!watch.ask(blade(7, 40)));
	CHECK(!watch.ask(blade(7, 5)));
	const std::vector<WantedBlade> wanted = watch.begin_read(1, slot_of);
	REQUIRE(wanted.size() == 2);
	CHECK(wanted[0].number == number_of(7, 5)); // rising
	CHECK(wanted[1].slot == 3);
	CHECK(!watch.ask(blade(7, 5))); // on its way
	watch.receive(answer_to(wanted, 1));
	const SimulatedKnots knots = watch.ask(blade(7, 40));
	REQUIRE(knots);
	CHECK((*knots)[0].isZero());
	CHECK((*knots)[GRASS_CLAMPED_KNOTS].x() == doctest::Approx(1.04f));
	CHECK((*knots)[GRASS_KNOTS - 1].z() == doctest::Approx(1.04f + 10.0f * float(KNOT_NUMBERS - 1)));
	CHECK(watch.get_age(3) == 2);
	CHECK(!watch.ask(blade(7, 6)));
	CHECK(!watch.ask({ number_of(7, 40), GRASS_NO_SLOT })); // the tile has gone to sleep
}

TEST_CASE("knot watch: blades that moved or are new are due") {
	KnotWatch watch;
	watch.ask(blade(7, 1));
	watch.receive(answer_to(watch.begin_read(4, slot_of), 4));
	watch.ask(blade(7, 1));
	CHECK(!watch.is_due(4));
	CHECK(watch.is_due(5));
	watch.ask(blade(7, 2));
	CHECK(watch.is_due(4));
}

TEST_CASE("knot watch: what nobody asks for any more is forgotten, the rest is not") {
	KnotWatch watch;
	watch.ask(blade(7, 1));
	for (uint64_t step = 1; step <= KnotWatch::READS_KEPT; step++) {
		watch.ask(blade(7, 2));
		REQUIRE(watch.begin_read(step, slot_of).size() == 2);
	}
	watch.ask(blade(7, 2));
	const std::vector<WantedBlade> left = watch.begin_read(100, slot_of);
	REQUIRE(left.size() == 1);
	CHECK(left[0].number == number_of(7, 2));
	const size_t before = watch.get_memory_usage();
	watch.receive(answer_to(left, 100));
	CHECK(watch.get_memory_usage() > before);
	watch.clear();
	CHECK(!watch.is_due(101));
	CHECK(!watch.ask(blade(7, 2)));
}
