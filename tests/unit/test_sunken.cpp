// SPDX-License-Identifier: MIT
// Boulders and planks: bodies at rest that stand in the ground, on roots or close above them, however they came there.
#include <doctest/doctest.h>

#include "sampled.h"
#include "sunken_bodies.h"

#include <string>

using namespace grass;
using namespace grass::test;

namespace {

constexpr Arrival ARRIVALS[] = { Arrival::FALLS, Arrival::APPEARS, Arrival::SLIDES };

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

// All bodies, come to in every way, on one root and on many.
Around look_around_all(const Patch &p_patch, Method p_method, float p_rate) {
	Around sum;
	unsigned seed = unsigned(p_rate);
	for (const Sunken &body : make_sunken()) {
		Around own;
		for (const Arrival arrival : ARRIVALS) {
			for (const Patch *patch : { static_cast<const Patch *>(nullptr), &p_patch }) {
				BladeScene scene = make_sunk(body, arrival, patch, p_rate, seed++, p_method);
				add_to(own, look_around(scene, p_rate));
				CHECK(scene.stretch() < 1e-3f);
			}
		}
		add_to(sum, own);
		if (own.covered_moving + own.touching_moving + own.pierced + own.cut + own.standing_out > 0) {
			MESSAGE(std::string(body.name) << ": " << own.covered_moving << " of " << own.covered << " covered blades move, "
										   << own.touching_moving << " of " << own.touching << " beside it, " << own.pierced
										   << " are pierced, " << own.cut << " cut, " << own.standing_out << " stand out");
		}
	}
	MESSAGE(p_rate << " steps a second: " << sum.covered_moving << " of " << sum.covered << " covered blades move, " << sum.touching_moving
				   << " of " << sum.touching << " beside bodies and " << sum.trembling << " tremble, " << sum.pierced << " are pierced, "
				   << sum.cut << " cut, " << sum.standing_out << " stand out");
	return sum;
}

} // namespace

TEST_CASE("METHOD_DIRECT: a second after a body came to rest in the ground, on roots or above them the blades that it covers are still and "
		  "lie, and two in a hundred of the others that touch it move by more than 1 mm a step, and none is pierced") {
	const Patch patch = generate_patch(PatchParams());
	for (const float rate : sampled({ 30.0f, 60.0f, 144.0f })) {
		CAPTURE(rate);
		const Around around = look_around_all(patch, Method::DIRECT, rate);
		CHECK(around.covered > 3000);
		CHECK(around.covered_moving == 0);
		CHECK(around.standing_out == 0);
		CHECK(around.covered_sunk > 0.7 * around.covered); // grass is pressed where a body has only appeared, too
		CHECK(around.touching > 500);
		CHECK(around.touching_moving * 50 <= around.touching);
		CHECK(around.pierced == 0);
		CHECK(around.cut * 400 <= around.touching); // edges in a wedge between the body and the ground
	}
}

TEST_CASE(
		"METHOD_PBD: the blades that such a body covers are still and lie, and of the others that touch it one in a hundred moves by more "
		"than 0.1 mm a step, since it came to touch it late") {
	const Patch patch = generate_patch(PatchParams());
	for (const float rate : sampled({ 30.0f, 60.0f, 144.0f })) {
		CAPTURE(rate);
		const Around around = look_around_all(patch, Method::PBD, rate);
		CHECK(around.covered > 3000);
		CHECK(around.covered_moving == 0);
		CHECK(around.standing_out == 0);
		CHECK(around.pierced * 500 <= around.touching);
		CHECK(around.touching > 500);
		CHECK(around.trembling * 100 <= around.touching);
	}
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
