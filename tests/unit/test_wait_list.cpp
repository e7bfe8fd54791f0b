// SPDX-License-Identifier: MIT
#include "core/base/wait_list.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <tuple>

using namespace grass;

TEST_CASE("wait_list: what is wanted comes first, then smaller orders, then what came first") {
	std::mt19937 random(5);
	for (int round = 0; round < 50; round++) {
		WaitList<int> list;
		std::vector<std::tuple<Need, int, int>> all; // need, order, item: in the order of coming
		for (int item = 0; item < 20; item++) {
			const Need need = random() % 2 ? Need::WANTED : Need::PREPARED;
			const int order = int(random() % 5);
			list.add(item, order, need);
			all.emplace_back(need, order, item);
		}
		std::ranges::sort(all);
		CHECK(list.size() == 20);
		for (const auto &[need, order, item] : all) {
			CHECK(list.take() == item);
		}
		CHECK(list.is_empty());
	}
}

TEST_CASE("wait_list: what becomes wanted overtakes, and what is removed never comes") {
	WaitList<char> list;
	list.add('s', 1, Need::WANTED); // a visible field's
	list.add('f', 2, Need::WANTED);
	for (const char prepared : { 'a', 'b', 'c' }) { // another method's
		list.add(prepared, prepared == 'a' ? 1 : 3, Need::PREPARED);
	}
	CHECK(list.take() == 's');
	list.want('c');
	list.want('s'); // is done
	CHECK(list.remove('b'));
	CHECK_FALSE(list.remove('b'));
	CHECK(list.take() == 'f');
	list.add('d', 0, Need::WANTED);
	CHECK(list.take() == 'd');
	CHECK(list.take() == 'c');
	CHECK(list.size() == 1);
	CHECK(list.take() == 'a');
	list.add('e', 0, Need::PREPARED);
	list.clear();
	CHECK(list.is_empty());
}
