// SPDX-License-Identifier: MIT
// Slots for the tiles of several fields.
#include "core/tiles/pool_budget.h"

#include <doctest/doctest.h>

#include <random>

using namespace grass;

namespace {

PoolDemand demand(std::initializer_list<std::pair<int, int>> p_tiles_by_band, int p_most = 4096) {
	PoolDemand demand;
	demand.most = p_most;
	for (const auto &[band, tiles] : p_tiles_by_band) {
		demand.tiles[size_t(band)] = tiles;
	}
	return demand;
}

// A field that wants slots for so many tiles in a band, and takes what it is granted.
struct Lawn : PoolBudget::Member {
	explicit Lawn(PoolBudget &r_budget, int p_band = 0) : budget(r_budget), band(p_band) { budget.join(*this); }
	~Lawn() { budget.leave(*this); }
	PoolDemand find_demand() override { return demand({ { band, wanted } }); }
	void tick(int p_wanted) {
		wanted = p_wanted;
		const int limit = budget.grant(*this, used);
		used = std::min(wanted, limit);
		budget.report(*this, used, used < wanted);
	}

	PoolBudget &budget;
	int band, wanted = 0, used = 0;
};

constexpr int UNSEEN = TileView::UNSEEN;

} // namespace

TEST_CASE("pool budget: near tiles first, and where slots end fields share them evenly") {
	using Demands = std::vector<PoolDemand>;
	using Shares = std::vector<int>;
	CHECK(share_pool({}, 100).empty());
	CHECK(share_pool(Demands{ demand({ { 3, 70 } }), demand({ { 4, 70 } }) }, 100) == Shares{ 70, 30 });
	CHECK(share_pool(Demands{ demand({ { 4, 70 } }), demand({ { 3, 70 } }) }, 100) == Shares{ 30, 70 });
	CHECK(share_pool(Demands{ demand({ { 4, 70 } }), demand({ { 4, 10 } }), demand({ { 4, 70 } }) }, 100) == Shares{ 45, 10, 45 });
	CHECK(share_pool(Demands{ demand({ { 2, 10 }, { UNSEEN, 500 } }), demand({ { UNSEEN, 30 } }) }, 100) == Shares{ 70, 30 });
	// What is left is for the next tiles that wake, as far as a field may have them.
	CHECK(share_pool(Demands{ demand({ { 0, 20 } }), demand({}), demand({}, 5) }, 100) == Shares{ 58, 37, 5 });
	CHECK(share_pool(Demands{ demand({ { 0, 20 } }, 10), demand({}, 20) }, 100) == Shares{ 10, 20 });
	CHECK(share_pool(Demands{ demand({ { 0, 7 } }), demand({ { 0, 7 } }) }, 1) == Shares{ 1, 0 });
	CHECK(share_pool(Demands{ demand({ { 0, 7 } }) }, -1) == Shares{ 0 });
}

TEST_CASE("pool budget: shares never exceed the slots, nor what a field may have") {
	std::mt19937 random(4);
	for (int round = 0; round < 300; round++) {
		std::vector<PoolDemand> demands(random() % 9 + 1);
		for (PoolDemand &own : demands) {
			own.most = int(random() % 300);
			for (uint32_t i = random() % 5; i > 0; i--) {
				own.tiles[random() % 64] += int(random() % 200);
			}
		}
		const int slots = int(random() % 1000);
		const std::vector<int> shares = share_pool(demands, slots);
		int sum = 0, most = 0;
		for (size_t i = 0; i < demands.size(); i++) {
			REQUIRE(shares[i] >= 0);
			REQUIRE(shares[i] <= demands[i].most);
			sum += shares[i];
			most += demands[i].most;
		}
		REQUIRE(sum == std::min(slots, most)); // none is left while anybody may have it
	}
}

TEST_CASE("pool budget: while there are enough, each field takes what it wants, at once") {
	PoolBudget budget(100);
	Lawn one(budget), other(budget);
	one.tick(60);
	other.tick(40);
	CHECK(one.used == 60);
	CHECK(other.used == 40);
	CHECK(budget.get_used() == 100);
	one.tick(10);
	other.tick(90);
	CHECK(other.used == 90);
	CHECK(budget.get_shares() == 0);
}

TEST_CASE("pool budget: of too few, a field near the camera takes those of one far away, and it ends once there are enough") {
	PoolBudget budget(100);
	Lawn far(budget, 30), near(budget, 5);
	far.tick(100);
	near.tick(70);
	CHECK(near.used == 0);
	far.tick(100);
	near.tick(70);
	CHECK(far.used == 30);
	CHECK(near.used == 70);
	for (int i = 0; i < 100; i++) { // nothing changes
		far.tick(100);
		near.tick(70);
		REQUIRE(far.used == 30);
		REQUIRE(near.used == 70);
		REQUIRE(budget.get_used() == 100);
	}
	for (int i = 0; i < 40; i++) {
		far.tick(50);
		near.tick(20);
	}
	CHECK(far.used == 50);
	CHECK(near.used == 20);
	const int64_t shares = budget.get_shares();
	near.tick(50); // there are enough again: at once
	CHECK(near.used == 50);
	CHECK(budget.get_shares() == shares);
}

TEST_CASE("pool budget: what another field has not given back yet is granted to nobody") {
	PoolBudget budget(100);
	Lawn far(budget, 30), near(budget, 5);
	far.tick(100);
	near.tick(70);
	near.tick(70); // its share, but the other one ticks later
	CHECK(near.used == 0);
	CHECK(budget.get_used() == 100);
	far.tick(100);
	near.tick(70);
	CHECK(near.used == 70);
	CHECK(budget.get_used() == 100);
}

TEST_CASE("pool budget: a field that leaves gives back what it had, and fewer slots hold soon") {
	PoolBudget budget(100);
	Lawn one(budget);
	{
		Lawn other(budget);
		other.tick(90);
		one.tick(50);
		CHECK(one.used == 10);
	}
	CHECK(budget.get_used() == 10);
	for (int i = 0; i < 40; i++) {
		one.tick(50);
	}
	CHECK(one.used == 50);
	budget.set_slots(20);
	one.tick(50);
	CHECK(one.used == 20); // at once
}

TEST_CASE("pool budget: a field that comes while slots are short has its share at once") {
	PoolBudget budget(100);
	Lawn one(budget);
	one.tick(200);
	one.tick(200);
	REQUIRE(one.used == 100);
	Lawn other(budget);
	other.tick(60);
	one.tick(200);
	other.tick(60);
	CHECK(one.used == 50);
	CHECK(other.used == 50);
}
