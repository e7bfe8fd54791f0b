// SPDX-License-Identifier: MIT
// Bodies that stand in the ground, on it or close above it, and what a tile of blades does around them.
#pragma once

#include "held_bodies.h"

#include "core/base/half.h"
#include "core/blades/patch.h"

#include <array>
#include <vector>

namespace grass::test {

struct Sunken {
	const char *name;
	int shape;
	Eigen::Vector3f size; // metres
	float height; // of its centre, metres
	float tilt = 0.0f; // radians
	Eigen::Vector3f axis = Eigen::Vector3f::UnitX(); // of the tilt
	bool is_cut = false; // a hull without corners
};

inline std::vector<Sunken> make_sunken() {
	constexpr float LYING_DOWN = 1.5708f; // radians
	const Eigen::Vector3f X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1), XZ(1, 0, 1), ACROSS_ALL(1, 0.3f, 1);
	return { { "ball, sunk 0.1 r", GRASS_SPHERE, { 0.4f, 0, 0 }, 0.36f }, { "ball, sunk 0.3 r", GRASS_SPHERE, { 0.4f, 0, 0 }, 0.28f },
		{ "ball, sunk 0.5 r", GRASS_SPHERE, { 0.4f, 0, 0 }, 0.2f }, { "ball, sunk 0.7 r", GRASS_SPHERE, { 0.4f, 0, 0 }, 0.12f },
		{ "ball, sunk 0.9 r", GRASS_SPHERE, { 0.4f, 0, 0 }, 0.04f }, { "ball, sunk 1.2 r", GRASS_SPHERE, { 0.4f, 0, 0 }, -0.08f },
		{ "small ball", GRASS_SPHERE, { 0.15f, 0, 0 }, 0.075f },
		{ "capsule lying, axis at the ground", GRASS_CAPSULE, { 0.4f, 0.5f, 0 }, 0.0f, LYING_DOWN, Z },
		{ "capsule lying", GRASS_CAPSULE, { 0.2f, 0.5f, 0 }, 0.1f, LYING_DOWN, X },
		{ "capsule upright", GRASS_CAPSULE, { 0.3f, 0.5f, 0 }, 0.5f },
		{ "capsule tilted", GRASS_CAPSULE, { 0.3f, 0.4f, 0 }, 0.2f, 0.8f, XZ }, { "box", GRASS_BOX, { 0.4f, 0.3f, 0.3f }, 0.15f, 0.3f, Y },
		{ "box tilted", GRASS_BOX, { 0.3f, 0.3f, 0.3f }, 0.15f, 0.7f, ACROSS_ALL },
		{ "box standing", GRASS_BOX, { 0.25f, 0.6f, 0.25f }, 0.6f }, { "plate at the roots", GRASS_BOX, { 0.5f, 0.03f, 0.4f }, 0.05f },
		{ "plate hovering", GRASS_BOX, { 0.5f, 0.0225f, 0.4f }, 0.12f },
		{ "hull hovering", GRASS_HULL, { 0.4f, 0.0225f, 0.3f }, 0.25f, 0.1f, XZ, true },
		{ "hull hovering, tilted", GRASS_HULL, { 0.3f, 0.04f, 0.3f }, 0.15f, 0.5f, XZ, true },
		{ "rock", GRASS_HULL, { 0.4f, 0.35f, 0.3f }, 0.1f, 0.5f, ACROSS_ALL, true },
		{ "stone", GRASS_HULL, { 0.12f, 0.1f, 0.14f }, 0.06f, 0.4f, ACROSS_ALL, true },
		{ "cylinder upright", GRASS_CYLINDER, { 0.3f, 0.3f, 0 }, 0.1f }, { "log", GRASS_CYLINDER, { 0.2f, 0.6f, 0 }, 0.1f, LYING_DOWN, X },
		{ "cylinder tilted", GRASS_CYLINDER, { 0.25f, 0.3f, 0 }, 0.1f, 0.6f, XZ }, { "post", GRASS_CYLINDER, { 0.05f, 0.6f, 0 }, 0.5f } };
}

enum class Arrival { FALLS, APPEARS, SLIDES };

// Returns a body among blades at its place, which it came to as p_arrival says. p_patch: blades all over the tile; null: all on one root.
inline BladeScene make_sunk(const Sunken &p_body, Arrival p_arrival, const Patch *p_patch, float p_rate, unsigned p_seed, Method p_method) {
	BladeScene scene(p_method);
	for (int b = 0; p_patch != nullptr && b < GRASS_BLADES_PER_TILE; b++) {
		const auto texel = [&](int p_knot) {
			const uint16_t *halves = &p_patch->texels[Patch::texel_index(int(p_seed % 20) * 509 + b, p_knot)];
			return Eigen::Vector3f(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
		};
		scene.tile->root[0][b] = (texel(0).x() - 0.5f) * 0.5f;
		scene.tile->root[2][b] = (texel(0).y() - 0.5f) * 0.5f;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			scene.set_rest(b, k, k > 0 ? texel(k) : Eigen::Vector3f::Zero());
		}
	}
	Numbers numbers(p_seed);
	const float aside = numbers.between(-0.25f, 0.25f), up = numbers.between(-0.02f, 0.02f), across = numbers.between(-0.25f, 0.25f);
	const Eigen::Vector3f place(aside, p_body.height + up, across);
	const Eigen::Quaternionf turn(Eigen::AngleAxisf(p_body.tilt, p_body.axis.normalized()));
	GrassCollider &collider = scene.add(p_body.shape, place, p_body.size);
	collider.rotation = collider.rotation_before = { turn.x(), turn.y(), turn.z(), turn.w() };
	if (p_body.is_cut) {
		cut_corners(scene, p_body.size);
	}
	const Eigen::Vector3f from = p_arrival == Arrival::FALLS ? Eigen::Vector3f(0.0f, 1.6f, 0.0f) : Eigen::Vector3f(1.4f, 0.0f, 0.0f);
	constexpr float SPEED = 1.3f; // m/s
	const int steps = p_arrival == Arrival::APPEARS ? 0 : int(std::ceil(from.norm() * p_rate / SPEED));
	for (int i = 0; i < steps; i++) {
		const auto at = [&](int p_step) { return Eigen::Vector3f(place + from * (1.0f - float(p_step) / float(steps))); };
		BladeScene::place(scene.colliders[0], at(i), at(i + 1));
		scene.step(1.0 / p_rate);
	}
	BladeScene::place(scene.colliders[0], place, place);
	return scene;
}

// Of blades a second after the body came to rest, in the second that follows.
struct Around {
	int covered = 0, covered_moving = 0; // their clamps are inside; of those, farther than 1e-5 of their length in a step
	int standing_out = 0; // of those, with a knot outside of the body and more than 6 cm above the ground
	int touching = 0, touching_moving = 0; // others at its surface, and those that go farther than 1 mm in a step
	int trembling = 0; // of those at its surface, farther than 0.1 mm in a step
	int pierced = 0, cut = 0; // of those whose roots are outside, with a knot more than 1 mm inside, and with an edge
	double covered_sunk = 0.0; // sum of how far tips of covered blades are below where they rest, blade lengths
};

inline Around look_around(BladeScene &r_scene, float p_rate) {
	std::array<float, GRASS_BLADES_PER_TILE> most{}; // moved in one step, metres
	BladeScene before;
	r_scene.step_for(1.0, p_rate);
	for (int i = 0; i < int(p_rate); i++) {
		*before.tile = *r_scene.tile;
		r_scene.step(1.0 / p_rate);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
				most[size_t(b)] = std::max(most[size_t(b)], (r_scene.knot(b, k) - before.knot(b, k)).norm());
			}
		}
	}
	const TileCollider collider = r_scene.tile_colliders()[0];
	Around around;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float length = (r_scene.rest(b, 1) - r_scene.rest(b, 0)).norm() / float(GRASS_CLAMP_SHARE);
		float deepest = -1.0f, knots = -1.0f, root = -1.0f; // metres
		bool stands_out = false;
		for (int s = 0; s < GRASS_SEGMENTS; s++) {
			for (int i = 0; i <= 8; i++) {
				float &most_deep = s == 0 ? root : deepest;
				most_deep = std::max(most_deep, r_scene.depth_in(collider, b, s, float(i) / 8.0f));
			}
			knots = s > 0 ? std::max(knots, r_scene.depth_in(collider, b, s + 1)) : knots;
			stands_out = stands_out || (s > 0 && r_scene.knot(b, s + 1).y() > 0.06f && r_scene.depth_in(collider, b, s + 1) < 0.0f);
		}
		const float moved = most[size_t(b)];
		if (r_scene.depth_in(collider, b, 1) > 0.0f) {
			around.covered++;
			around.covered_moving += moved > 1e-5f * length ? 1 : 0;
			around.standing_out += stands_out ? 1 : 0;
			around.covered_sunk += double(r_scene.rest(b, GRASS_KNOTS - 1).y() - r_scene.knot(b, GRASS_KNOTS - 1).y()) / double(length);
			continue;
		}
		const bool touches = deepest > -AT;
		around.touching += touches ? 1 : 0;
		around.touching_moving += touches && moved > 1e-3f ? 1 : 0;
		around.trembling += touches && moved > 1e-4f ? 1 : 0;
		around.pierced += root <= 0.0f && knots > 1e-3f ? 1 : 0;
		around.cut += root <= 0.0f && deepest > 1e-3f ? 1 : 0;
	}
	return around;
}

} // namespace grass::test
