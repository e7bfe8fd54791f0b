// SPDX-License-Identifier: MIT
// Bodies that come down on a tile of blades and stay, and how many of the blades that they hold still move.
#pragma once

#include "blade_scene.h"

#include "core/solver/edge.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace grass::test {

// A shape that comes down on the blades and stays.
struct Rest {
	int shape;
	Eigen::Vector3f size; // metres
	float height, aside; // of its centre where it stays, and of that from the roots, metres
	Eigen::Quaternionf turn = Eigen::Quaternionf::Identity();
	bool is_cut = false; // a hull without corners
};

class Numbers {
public:
	explicit Numbers(unsigned p_seed) : _random(p_seed) {}
	float between(float p_low, float p_high) { return std::uniform_real_distribution<float>(p_low, p_high)(_random); }

private:
	std::mt19937 _random;
};

inline std::vector<Rest> make_rests() {
	const Eigen::Vector3f plate(0.5f, 0.1f, 0.5f);
	std::vector<Rest> rests = { { GRASS_BOX, plate, 0.18f, 0.0f }, { GRASS_BOX, plate, 0.35f, 0.0f },
		{ GRASS_CYLINDER, plate, 0.18f, 0.0f }, { GRASS_HULL, plate, 0.18f, 0.0f }, { GRASS_SPHERE, { 0.15f, 0.0f, 0.0f }, 0.15f, 0.1f },
		{ GRASS_SPHERE, { 0.3f, 0.0f, 0.0f }, 0.4f, 0.1f }, { GRASS_CAPSULE, { 0.1f, 0.2f, 0.0f }, 0.32f, 0.1f } };
	Numbers numbers(7);
	for (int i = 0; i < 15; i++) {
		const float x = numbers.between(0.08f, 0.25f), y = numbers.between(0.06f, 0.2f), z = numbers.between(0.08f, 0.25f);
		const int shape = SHAPES[i % 5];
		const float half = shape == GRASS_SPHERE ? x : shape == GRASS_CAPSULE ? x + y : y;
		const float above = i % 3 == 0 ? 0.0f : numbers.between(0.0f, 0.3f);
		rests.push_back({ shape, { x, y, z }, half + above, numbers.between(-0.3f, 0.3f) });
	}
	return rests;
}

// Returns how high the centre of a shape is that stands on the ground.
inline float half_height(const Rest &p_rest) {
	const Eigen::Vector3f up = (p_rest.turn.conjugate() * Eigen::Vector3f::UnitY()).cwiseAbs();
	switch (p_rest.shape) {
		case GRASS_SPHERE:
			return p_rest.size.x();
		case GRASS_CAPSULE:
			return p_rest.size.x() + up.y() * p_rest.size.y();
		case GRASS_CYLINDER:
			return up.y() * p_rest.size.y() + std::sqrt(std::max(1.0f - up.y() * up.y(), 0.0f)) * p_rest.size.x();
		default:
			return up.dot(p_rest.size);
	}
}

// Small, middling and large ones that stand on the ground or hang above it, level and tilted.
struct Kind {
	const char *name;
	int shape;
	float least_tilt, most_tilt; // radians from upright
	bool is_cut;
};
inline constexpr Kind KINDS[] = { { "ball", GRASS_SPHERE, 0.0f, 0.0f, false }, { "box, flat", GRASS_BOX, 0.0f, 0.0f, false },
	{ "box, tilted", GRASS_BOX, 0.1f, 1.4f, false }, { "capsule, upright", GRASS_CAPSULE, 0.0f, 0.0f, false },
	{ "capsule, lying", GRASS_CAPSULE, 1.0f, 1.57f, false }, { "cylinder, upright", GRASS_CYLINDER, 0.0f, 0.0f, false },
	{ "cylinder, tilted", GRASS_CYLINDER, 0.1f, 1.57f, false }, { "hull, tilted", GRASS_HULL, 0.1f, 1.4f, false },
	{ "hull without corners, tilted", GRASS_HULL, 0.1f, 1.4f, true } };

inline std::vector<Rest> make_rests(const Kind &p_kind, int p_count, unsigned p_seed) {
	Numbers numbers(p_seed);
	std::vector<Rest> rests;
	for (int i = 0; i < p_count; i++) {
		const float scale = i % 4 == 3 ? 2.0f : i % 4 == 2 ? 0.4f : 1.0f;
		const float x = numbers.between(0.08f, 0.25f), y = numbers.between(0.06f, 0.2f), z = numbers.between(0.08f, 0.25f);
		const float yaw = numbers.between(-3.14f, 3.14f), tilt = numbers.between(p_kind.least_tilt, p_kind.most_tilt);
		const float heading = numbers.between(-3.14f, 3.14f);
		Rest rest{ p_kind.shape, Eigen::Vector3f(x, y, z) * scale, 0.0f, numbers.between(-0.3f, 0.3f), Eigen::Quaternionf::Identity(),
			p_kind.is_cut };
		rest.turn = Eigen::AngleAxisf(tilt, Eigen::Vector3f(std::cos(heading), 0.0f, std::sin(heading))) *
				Eigen::AngleAxisf(yaw, Eigen::Vector3f::UnitY());
		rest.height = half_height(rest) + (i % 3 == 0 ? 0.0f : numbers.between(0.0f, 0.3f));
		rests.push_back(rest);
	}
	return rests;
}

inline constexpr float ACROSS = 0.013f; // of the bodies from the roots, metres

// Moves the scene's first collider, p_rest, straight from one height to another, metres, in p_steps steps.
inline void move(BladeScene &r_scene, const Rest &p_rest, float p_from, float p_to, int p_steps, float p_rate) {
	for (int i = 0; i < p_steps; i++) {
		const float before = p_from + (p_to - p_from) * float(i) / float(p_steps);
		const float now = p_from + (p_to - p_from) * float(i + 1) / float(p_steps);
		BladeScene::place(r_scene.colliders[0], { p_rest.aside, before, ACROSS }, { p_rest.aside, now, ACROSS });
		r_scene.step(1.0 / p_rate);
	}
	BladeScene::place(r_scene.colliders[0], { p_rest.aside, p_to, ACROSS }, { p_rest.aside, p_to, ACROSS });
}

// Takes the corners off the scene's last collider, a hull of this size.
inline void cut_corners(BladeScene &r_scene, const Eigen::Vector3f &p_size) {
	for (int i = 0; i < 8; i++) {
		const Eigen::Vector3f corner(i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f);
		const Eigen::Vector3f normal = corner.normalized();
		r_scene.planes.push_back({ normal.x(), normal.y(), normal.z(), 0.8f * normal.cwiseAbs().dot(p_size) });
	}
	r_scene.colliders.back().position_before.w = float(r_scene.planes.size());
}

// Two seconds after the shape came to rest, at p_rate steps a second.
inline BladeScene make_held(const Rest &p_rest, float p_rate, const SolverParams &p_params = {}) {
	constexpr float SPEED = 0.6f; // m/s
	const float start = std::max(0.9f, p_rest.height + 0.55f); // metres, above all blades
	BladeScene scene;
	scene.params = p_params;
	GrassCollider &collider = scene.add(p_rest.shape, { p_rest.aside, start, ACROSS }, p_rest.size);
	collider.rotation = collider.rotation_before = { p_rest.turn.x(), p_rest.turn.y(), p_rest.turn.z(), p_rest.turn.w() };
	if (p_rest.is_cut) {
		cut_corners(scene, p_rest.size);
	}
	move(scene, p_rest, start, p_rest.height, int(std::ceil((start - p_rest.height) * p_rate / SPEED)), p_rate);
	scene.step_for(2.0, p_rate);
	return scene;
}

inline constexpr float AT = 0.004f; // metres, the solver's skin

// Returns whether the shape stands on the blade's root: its clamp, which cannot get out, is inside.
inline bool is_buried(const BladeScene &p_scene, int p_blade) {
	return p_scene.depth_in(p_scene.tile_colliders()[0], p_blade, 1) > AT;
}

// Returns whether the shape holds the blade: it is at the surface, and its clamp, which could not get out, is outside.
inline bool is_held(const BladeScene &p_scene, int p_blade) {
	const TileCollider collider = p_scene.tile_colliders()[0];
	const Vec3<float> root = Vec3<float>{} - collider.centre;
	const Eigen::Vector3f clamp = p_scene.knot(p_blade, 1);
	const Edge<float> edge = find_edge(collider, turned(inverse_of(collider.turn), root),
			turned(inverse_of(collider.turn), root + Vec3<float>{ clamp.x(), clamp.y(), clamp.z() }), 1.0f);
	float deepest = -1.0f;
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		deepest = std::max(deepest, p_scene.depth_in(collider, p_blade, k));
	}
	return edge.face.distance > 0.0f && deepest > -AT;
}

struct Count {
	int held = 0, moving = 0; // of those, farther than 1e-5 of their length in a step
	int buried = 0, moving_buried = 0;
};

// Watches each blade for a second.
inline Count count_moving(BladeScene &r_scene, float p_rate) {
	std::array<float, GRASS_BLADES_PER_TILE> most{}; // moved in one step, blade lengths
	BladeScene before;
	for (int i = 0; i < int(p_rate); i++) {
		*before.tile = *r_scene.tile;
		r_scene.step(1.0 / p_rate);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
				most[b] = std::max(most[b], (r_scene.knot(b, k) - before.knot(b, k)).norm() / r_scene.length);
			}
		}
	}
	Count count;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const int moves = most[b] > 1e-5f ? 1 : 0;
		if (is_held(r_scene, b)) {
			count.held++;
			count.moving += moves;
		} else if (is_buried(r_scene, b)) {
			count.buried++;
			count.moving_buried += moves;
		}
	}
	return count;
}

inline Count count_moving(const std::vector<Rest> &p_rests, float p_rate, const SolverParams &p_params = {}) {
	Count all;
	for (const Rest &rest : p_rests) {
		BladeScene scene = make_held(rest, p_rate, p_params);
		const Count count = count_moving(scene, p_rate);
		all.held += count.held;
		all.moving += count.moving;
		all.buried += count.buried;
		all.moving_buried += count.moving_buried;
	}
	return all;
}

} // namespace grass::test
