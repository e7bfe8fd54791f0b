// SPDX-License-Identifier: MIT
// Blades that something rests on: they stand still, every one of them, and rise when it leaves.
#include <doctest/doctest.h>

#include "blade_scene.h"

#include "core/edge.h"

using namespace grass;
using namespace grass::test;

namespace {

// A shape that comes down on the blades and stays.
struct Rest {
	int shape;
	Eigen::Vector3f size; // metres
	float height, aside; // of its centre where it stays, and of that from the roots, metres
};

std::vector<Rest> make_rests() {
	const Eigen::Vector3f plate(0.5f, 0.1f, 0.5f);
	std::vector<Rest> rests = { { GRASS_BOX, plate, 0.18f, 0.0f }, { GRASS_BOX, plate, 0.35f, 0.0f },
		{ GRASS_CYLINDER, plate, 0.18f, 0.0f }, { GRASS_HULL, plate, 0.18f, 0.0f }, { GRASS_SPHERE, { 0.15f, 0.0f, 0.0f }, 0.15f, 0.1f },
		{ GRASS_SPHERE, { 0.3f, 0.0f, 0.0f }, 0.4f, 0.1f }, { GRASS_CAPSULE, { 0.1f, 0.2f, 0.0f }, 0.32f, 0.1f } };
	std::mt19937 random(7);
	const auto uniform = [&](float p_low, float p_high) { return std::uniform_real_distribution<float>(p_low, p_high)(random); };
	for (int i = 0; i < 15; i++) {
		const Eigen::Vector3f size(uniform(0.08f, 0.25f), uniform(0.06f, 0.2f), uniform(0.08f, 0.25f));
		const int shape = SHAPES[i % 5];
		const float half = shape == GRASS_SPHERE ? size.x() : shape == GRASS_CAPSULE ? size.x() + size.y() : size.y();
		rests.push_back({ shape, size, half + (i % 3 == 0 ? 0.0f : uniform(0.0f, 0.3f)), uniform(-0.3f, 0.3f) });
	}
	return rests;
}

// Two seconds after the shape came to rest, at p_rate steps a second.
BladeScene make_held(const Rest &p_rest, float p_rate) {
	constexpr float START = 0.9f, SPEED = 0.6f, ACROSS = 0.013f; // metres, m/s, metres
	BladeScene scene;
	scene.add(p_rest.shape, { p_rest.aside, START, ACROSS }, p_rest.size);
	float height = START;
	while (height > p_rest.height) {
		const float before = height;
		height = std::max(height - SPEED / p_rate, p_rest.height);
		BladeScene::place(scene.colliders[0], { p_rest.aside, before, ACROSS }, { p_rest.aside, height, ACROSS });
		scene.step(1.0 / p_rate);
	}
	BladeScene::place(scene.colliders[0], { p_rest.aside, height, ACROSS }, { p_rest.aside, height, ACROSS });
	scene.step_for(2.0, p_rate);
	return scene;
}

// Whether the shape holds the blade: it is at the surface, and its clamp, which could not get out, is outside.
bool is_held(const BladeScene &p_scene, int p_blade) {
	constexpr float AT = 0.004f; // metres, the solver's skin
	const TileCollider collider = p_scene.tile_colliders()[0];
	const Vec3<float> root = Vec3<float>{} - collider.centre;
	const Eigen::Vector3f clamp = p_scene.knot(p_blade, 1);
	const Edge<float> edge = find_edge(collider, turned(inverse(collider.turn), root),
			turned(inverse(collider.turn), root + Vec3<float>{ clamp.x(), clamp.y(), clamp.z() }), 1.0f);
	float deepest = -1.0f;
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		deepest = std::max(deepest, p_scene.depth_in(collider, p_blade, k));
	}
	return edge.face.distance > 0.0f && deepest > -AT;
}

} // namespace

TEST_CASE("METHOD_DIRECT: two seconds after a body came to rest on them, 99 % of the blades that it holds move less than 1e-5 L a step, "
		  "all less than 2e-3 L") {
	for (const float rate : { 30.0f, 60.0f, 144.0f }) {
		CAPTURE(rate);
		int held = 0, moving = 0;
		for (const Rest &rest : make_rests()) {
			CAPTURE(rest.shape);
			CAPTURE(rest.height);
			CAPTURE(rest.aside);
			BladeScene scene = make_held(rest, rate);
			float most[GRASS_BLADES_PER_TILE] = {};
			BladeScene before;
			for (int i = 0; i < int(rate); i++) {
				*before.tile = *scene.tile;
				scene.step(1.0 / rate);
				for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
					for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
						most[b] = std::max(most[b], (scene.knot(b, k) - before.knot(b, k)).norm() / scene.length);
					}
				}
			}
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				if (is_held(scene, b)) {
					held++;
					moving += most[b] > 1e-5f ? 1 : 0;
					CAPTURE(b);
					CHECK(most[b] < 2e-3f);
				}
			}
		}
		CHECK(held > 500);
		CHECK(moving <= held / 100);
		MESSAGE(rate << " steps a second: " << moving << " of " << held << " move");
	}
}

TEST_CASE("METHOD_DIRECT: what a body held rises when it leaves, and is at rest four seconds later") {
	for (const Rest &rest : make_rests()) {
		CAPTURE(rest.shape);
		CAPTURE(rest.height);
		BladeScene scene = make_held(rest, 60.0f);
		scene.colliders.clear();
		scene.step_for(4.0);
		CHECK(scene.distance_from_rest() < 1e-3f);
	}
}

TEST_CASE("METHOD_DIRECT: a blade that is folded at its root and lies on the ground, away from where it leans, rises at once") {
	BladeScene scene;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float side = 0.2f + 0.2f * float(b) / float(GRASS_BLADES_PER_TILE); // of the fold, shares of a segment
		const Eigen::Vector3f tip = scene.rest(b, GRASS_KNOTS - 1);
		const Eigen::Vector3f lean = Eigen::Vector3f(tip.x() + 1e-4f, 0.0f, tip.z()).normalized();
		Eigen::Vector3f knot = scene.rest(b, 1);
		for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3f down = lean * side - Eigen::Vector3f::UnitY() * std::sqrt(1.0f - side * side);
			const Eigen::Vector3f along = (Eigen::Vector3f::UnitY() * 0.02f * float(k - 2) - lean).normalized();
			knot += (k == GRASS_CLAMPED_KNOTS ? down : along) * (scene.length / GRASS_SEGMENTS);
			scene.set_knot(b, k, knot);
		}
	}
	scene.step_for(4.0);
	CHECK(scene.distance_from_rest() < 0.01f);
}
