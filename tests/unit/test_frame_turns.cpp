// SPDX-License-Identifier: MIT
// Who may work in a frame: nobody waits for ever, however busy the others are.
#include "core/base/frame_turns.h"

#include <doctest/doctest.h>

#include <map>
#include <vector>

using namespace grass;

TEST_CASE("turns: whoever asks while there is room may work") {
	FrameTurns turns;
	const int users[3] = {};
	turns.enter_frame(1);
	for (const int &user : users) {
		CHECK(turns.ask(&user, true));
		CHECK(turns.ask(&user, true));
	}
	CHECK_FALSE(turns.ask(&users[0], false));
}

TEST_CASE("turns: of those for whom there never is room each gets a piece in turn") {
	for (const uint64_t count : { 1u, 2u, 5u, 17u }) {
		FrameTurns turns;
		std::vector<int> users(count);
		std::map<const int *, int> pieces;
		for (uint64_t frame = 0; frame < 1 + 10 * count; frame++) {
			turns.enter_frame(frame);
			int in_frame = 0;
			for (int round = 0; round < 3; round++) { // as often as they like
				for (const int &user : users) {
					const bool may = turns.ask(&user, false);
					pieces[&user] += may ? 1 : 0;
					in_frame += may ? 1 : 0;
				}
			}
			CHECK(in_frame == (frame == 0 ? 0 : 1));
		}
		for (const int &user : users) {
			CHECK(pieces[&user] >= 9);
			CHECK(pieces[&user] <= 11);
		}
	}
}

TEST_CASE("turns: one that has room in each frame takes nothing from one that has none") {
	FrameTurns turns;
	const int first = 0, second = 0;
	int pieces = 0;
	for (uint64_t frame = 0; frame < 100; frame++) {
		turns.enter_frame(frame);
		CHECK(turns.ask(&first, true));
		CHECK(turns.is_owed(&first) == (frame > 0));
		CHECK_FALSE(turns.ask(&first, false)); // it has used up the frame
		while (turns.ask(&second, false)) {
			pieces++;
		}
		CHECK_FALSE(turns.is_owed(&first));
	}
	CHECK(pieces == 99);
}

TEST_CASE("turns: one that has gone is not waited for") {
	FrameTurns turns;
	const int gone = 0, there = 0;
	turns.enter_frame(1);
	CHECK_FALSE(turns.ask(&gone, false));
	CHECK_FALSE(turns.ask(&there, false));
	int pieces = 0;
	for (uint64_t frame = 2; frame < 12; frame++) {
		turns.enter_frame(frame);
		while (turns.ask(&there, false)) {
			pieces++;
		}
	}
	CHECK(pieces >= 7);
}
