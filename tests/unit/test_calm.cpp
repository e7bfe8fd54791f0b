// SPDX-License-Identifier: MIT
// METHOD_PBD: blades that only bodies at rest touch come to rest, [Eq 48], and go on as if nothing had held them once a body moves or goes.
#include <doctest/doctest.h>

#include "sampled.h"
#include "sunken_bodies.h"

#include <cstring>

using namespace grass;
using namespace grass::test;

namespace {

bool has_same_knots(const BladeScene &p_a, const BladeScene &p_b) {
	return std::memcmp(p_a.tile->knots, p_b.tile->knots, sizeof(p_a.tile->knots)) == 0;
}

// The same pose, as blades have it that nothing has held.
void copy_without_calm(const BladeScene &p_from, BladeScene &r_to) {
	*r_to.tile = *p_from.tile;
	std::memset(r_to.tile->calm, 0, sizeof(r_to.tile->calm));
	r_to.clock = p_from.clock;
	r_to.colliders = p_from.colliders;
	r_to.planes = p_from.planes;
}

// A body of such a shape and a ball beside it, at rest among the blades for two seconds.
BladeScene make_calm(const Sunken &p_body, const Patch &p_patch, float p_rate, unsigned p_seed) {
	BladeScene scene = make_sunk(p_body, Arrival::FALLS, &p_patch, p_rate, p_seed, Method::PBD);
	scene.add(GRASS_SPHERE, { 0.2f, 0.2f, -0.2f }, { 0.1f, 0.0f, 0.0f });
	scene.step_for(2.0, p_rate);
	return scene;
}

} // namespace

TEST_CASE(
		"METHOD_PBD: blades that bodies at rest hold go on as if never held as soon as a body moves, turns, comes or goes, or air blows") {
	const Patch patch = generate_patch(PatchParams());
	const std::vector<Sunken> bodies = make_sunken();
	for (const float rate : sampled({ 30.0f, 60.0f, 144.0f })) {
		for (size_t i = 0; i < bodies.size(); i += 3) {
			if (bodies[i].shape == GRASS_HULL) {
				continue;
			}
			CAPTURE(bodies[i].name);
			CAPTURE(rate);
			const BladeScene calm = make_calm(bodies[i], patch, rate, unsigned(i));
			const auto takes_same_step = [&](auto p_change) {
				BladeScene held(Method::PBD), free(Method::PBD);
				copy_without_calm(calm, free);
				copy_without_calm(calm, held);
				*held.tile = *calm.tile;
				for (BladeScene *scene : { &held, &free }) {
					p_change(*scene);
					scene->step(1.0 / rate);
				}
				return has_same_knots(held, free);
			};
			CHECK_FALSE(takes_same_step([](BladeScene &) {})); // or nothing would be held
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.colliders.clear(); }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.colliders.pop_back(); }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.colliders.front().position_before.x += 1e-4f; }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.colliders.front().rotation_before = { 0.0f, 0.001f, 0.0f, 1.0f }; }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.add(GRASS_SPHERE, { 0.0f, 0.3f, 0.0f }, { 0.1f, 0.0f, 0.0f }); }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.params.load[0] = 1.0; }));
		}
	}
}

TEST_CASE("METHOD_PBD: a body at rest changes no bit of a swing that does not touch it") {
	BladeScene alone(Method::PBD);
	alone.bend(0.4f);
	BladeScene beside(Method::PBD);
	beside.bend(0.4f);
	beside.add(GRASS_SPHERE, { -0.75f, 0.3f, 0.0f }, { 0.1f, 0.0f, 0.0f }); // nearer than a blade is long and a half
	for (int i = 0; i < 180; i++) {
		alone.step();
		beside.step();
		CAPTURE(i);
		REQUIRE(has_same_knots(alone, beside));
	}
}
