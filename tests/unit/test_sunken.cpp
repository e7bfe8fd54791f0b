// SPDX-License-Identifier: MIT
// Boulders and planks: bodies at rest that stand in the ground, on roots or close above them, however they came there.
#include <doctest/doctest.h>

#include "sampled.h"
#include "sunken_bodies.h"

#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>

using namespace grass;
using namespace grass::test;

namespace {

constexpr Arrival ARRIVALS[] = { Arrival::FALLS, Arrival::APPEARS, Arrival::SLIDES };
constexpr float RATES[] = { 30.0f, 60.0f, 144.0f }; // steps a second

std::string describe(const Around &p_around) {
	std::ostringstream text;
	text << p_around.covered_moving << " of " << p_around.covered << " covered blades move, " << p_around.touching_moving << " of "
		 << p_around.touching << " beside bodies, " << p_around.trembling << " tremble, " << p_around.pierced << " are pierced, "
		 << p_around.cut << " cut, " << p_around.standing_out << " stand out";
	return text.str();
}

void add_to(Around &r_sum, const Around &p_one) {
	r_sum.covered += p_one.covered;
	r_sum.covered_moving += p_one.covered_moving;
	r_sum.standing_out += p_one.standing_out;
	r_sum.touching += p_one.touching;
	r_sum.touching_moving += p_one.touching_moving;
	r_sum.trembling += p_one.trembling;
	r_sum.pierced += p_one.pierced;
	r_sum.cut += p_one.cut;
	r_sum.covered_sunk += p_one.covered_sunk;
}

// Returns all bodies at all of RATES, on one root and on many. Each comes in another way than its neighbours and than at the next rate.
// GRASS_SUNKEN_DRAW=N in the environment draws other places: the marks below hold from draw to draw, not of one.
// Checks what holds of both methods.
Around look_around_all(Method p_method) {
	const Patch blades = generate_patch(PatchParams());
	const char *draw = std::getenv("GRASS_SUNKEN_DRAW");
	unsigned seed = 1000 * unsigned(draw != nullptr ? std::atoi(draw) : 0);
	Around sum;
	size_t first_way = 0; // of the first body
	for (const float rate : sampled(RATES)) {
		size_t way = first_way++;
		for (const Sunken &body : make_sunken()) {
			Around own;
			const Arrival arrival = ARRIVALS[way++ % std::size(ARRIVALS)];
			for (const Patch *patch : { static_cast<const Patch *>(nullptr), &blades }) {
				BladeScene scene = make_sunk(body, arrival, patch, rate, seed++, p_method);
				add_to(own, look_around(scene, rate));
				CHECK(scene.stretch() < 1e-3f);
			}
			add_to(sum, own);
			if (own.covered_moving + own.trembling + own.pierced + own.cut + own.standing_out > 0) {
				MESSAGE(std::string(body.name) << ", " << rate << " steps a second: " << describe(own));
			}
		}
	}
	MESSAGE("all: " << describe(sum));
	CHECK(sum.covered > 1000);
	CHECK(sum.covered_moving == 0);
	CHECK(sum.standing_out == 0);
	CHECK(sum.touching > 500);
	CHECK(sum.pierced * 500 <= sum.touching);
	return sum;
}

} // namespace

TEST_CASE("METHOD_DIRECT: a second after a body came to rest in the ground, on roots or above them the blades that it covers are still and "
		  "lie, two in a hundred of the others that touch it move by more than 1 mm a step, and two in a thousand are pierced") {
	const Around around = look_around_all(Method::DIRECT);
	CHECK(around.covered_sunk > 0.7 * around.covered); // grass is pressed where a body has only appeared, too
	CHECK(around.touching_moving * 50 <= around.touching);
	CHECK(around.cut * 400 <= around.touching); // edges in a wedge between the body and the ground
}

TEST_CASE("METHOD_PBD: the blades that such a body covers are still and lie, and of the others that touch it four in a hundred tremble by "
		  "more than 0.1 mm a step, since they came to touch it late, and two in a thousand are pierced") {
	const Around around = look_around_all(Method::PBD);
	CHECK(around.trembling * 25 <= around.touching);
}

TEST_CASE_TEMPLATE("Grass that a sunken body has laid rises when it leaves, and is at rest four seconds later", M, Direct, Pbd) {
	const Patch patch = generate_patch(PatchParams());
	for (const Sunken &body : make_sunken()) {
		CAPTURE(body.name);
		BladeScene scene = make_sunk(body, Arrival::FALLS, &patch, 60.0f, 3, M::METHOD);
		scene.step_for(1.0);
		scene.colliders.clear();
		scene.step_for(4.0);
		CHECK(scene.distance_from_rest() < 0.01f);
	}
}
