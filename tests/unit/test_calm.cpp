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

// Returns a body of such a shape and a ball beside it, at rest among the blades for two seconds.
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
	int poses = 0, held_poses = 0;
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
			poses++;
			held_poses += takes_same_step([](BladeScene &) {}) ? 0 : 1;
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.colliders.clear(); }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.colliders.pop_back(); }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.colliders.front().position_before.x += 1e-4f; }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.colliders.front().rotation_before = { 0.0f, 0.001f, 0.0f, 1.0f }; }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.add(GRASS_SPHERE, { 0.0f, 0.3f, 0.0f }, { 0.1f, 0.0f, 0.0f }); }));
			CHECK(takes_same_step([](BladeScene &r_scene) { r_scene.params.load[0] = 1.0; }));
		}
	}
	CHECK(held_poses >= (poses + 1) / 2); // below small bodies blades may come to rest by themselves
	MESSAGE("blades are held in " << held_poses << " of " << poses << " poses");
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

TEST_CASE("METHOD_PBD: a blade comes to rest on a tiny disc that it touches in few of its steps") {
	struct Disc {
		Eigen::Vector3f size, place;
		vec4 rotation;
		float heading, lean, curve, root_x, root_z; // of the blade: radians, metres
	};
	const Disc discs[] = {
		{ { 0.0252f, 0.00397f, 0.0f }, { 0.0163f, 0.08401f, -0.03419f }, { -0.50980467f, -0.30068812f, -0.11110701f, 0.79833645f },
				3.22330165f, 0.24049279f, 0.98860031f, 0.04701359f, -0.03627391f },
		{ { 0.01685297f, 0.00213064f, 0.0f }, { 0.07052828f, 0.09253512f, 0.00902934f },
				{ 0.63261622f, -0.27229157f, -0.7119413f, 0.1370903f }, 4.63726425f, 0.16041018f, 0.65002048f, 0.06393107f, 0.03442397f },
	};
	for (const Disc &disc : discs) {
		CAPTURE(disc.heading);
		BladeScene scene(Method::PBD);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			scene.tile->root[0][b] = disc.root_x;
			scene.tile->root[2][b] = disc.root_z;
			Eigen::Vector3f knot = Eigen::Vector3f::Zero();
			for (int k = 0; k < GRASS_KNOTS; k++) {
				scene.set_rest(b, k, knot);
				const float angle = disc.lean + disc.curve * float(knot_share(k) + 0.5 * segment_share(k));
				const Eigen::Vector3f way(sin_of(angle) * cos_of(disc.heading), cos_of(angle), sin_of(angle) * sin_of(disc.heading));
				knot += scene.length * float(segment_share(k)) * way;
			}
		}
		GrassCollider &collider = scene.add(GRASS_CYLINDER, disc.place, disc.size);
		collider.rotation = collider.rotation_before = disc.rotation;
		const auto place = [&](int p_step) {
			return Eigen::Vector3f(disc.place + Eigen::Vector3f(std::max(0.5f - float(p_step) / 60.0f, 0.0f) * 0.8f, 0.0f, 0.0f));
		};
		float most = 0.0f; // in the last second, blade lengths a step
		for (int i = 0; i < 480; i++) {
			BladeScene::place(scene.colliders[0], place(i), place(i + 1));
			const BladeScene before = [&] {
				BladeScene copy(Method::PBD);
				*copy.tile = *scene.tile;
				return copy;
			}();
			scene.step();
			most = i >= 420 ? std::max(most, scene.distance_from(before)) : most;
		}
		CHECK(most < 1e-3f);
	}
}
