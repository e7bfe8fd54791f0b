// SPDX-License-Identifier: MIT
// The reference problems among colliders.
#pragma once

#include "problem.h"
#include "sward.h"

namespace grass::test {

// A ball rolls through at 5 m/s, for 0.3 seconds.
inline Track sphere_sweep(const Config &p_config) {
	BladeScene scene = make_scene(p_config, Keep::KNOTS, p_config.substeps, 0.5);
	scene.add(GRASS_SPHERE, Eigen::Vector3f::Zero(), { 0.15f, 0.0f, 0.0f });
	const float stride = 5.0f * float(FRAME) / float(p_config.substeps);
	Track path;
	float x = -0.6f;
	for (int frame = 0; frame < 18; frame++) {
		for (int i = 0; i < p_config.substeps; i++, x += stride) {
			BladeScene::place(scene.colliders[0], { x, 0.2f, 0.02f }, { x + stride, 0.2f, 0.02f });
			scene.step(FRAME / p_config.substeps);
		}
		append_knots(scene, path);
	}
	return path;
}

// A ball without friction rolls past the blades' root at p_speed, 9 cm aside, for p_frames.
inline Track pass_by(const Config &p_config, float p_speed, int p_frames) {
	BladeScene scene = make_scene(p_config, Keep::KNOTS, p_config.substeps, 0.5);
	scene.params.friction = 0.0;
	scene.add(GRASS_SPHERE, Eigen::Vector3f::Zero(), { 0.15f, 0.0f, 0.0f });
	const double delta = FRAME / p_config.substeps;
	const auto place = [&](int p_step) { return Eigen::Vector3f(-0.5f + p_speed * float(p_step * delta), 0.15f, 0.09f); };
	Track path;
	for (int i = 0; i < p_frames * p_config.substeps; i++) {
		BladeScene::place(scene.colliders[0], place(i), place(i + 1));
		scene.step(delta);
		if ((i + 1) % p_config.substeps == 0) {
			append_knots(scene, path);
		}
	}
	return path;
}
inline Track slow_pass(const Config &p_config) {
	return pass_by(p_config, 1.0f, 90);
}
inline Track fast_pass(const Config &p_config) {
	return pass_by(p_config, 5.0f, 48);
}

// A body that moves from one place to another in two seconds and holds blades there.
struct Press {
	int shape;
	Eigen::Vector3f size, from, to;
};
inline const Press PLATE = { GRASS_BOX, { 2.0f, 0.05f, 2.0f }, { 0.0f, 0.6f, 0.0f }, { 0.0f, 0.25f, 0.0f } };
inline const Press POST = { GRASS_CAPSULE, { 0.03f, 1.0f, 0.0f }, { -0.04f, 0.3f, 0.0f }, { 0.05f, 0.3f, 0.0f } };
constexpr int PRESS_FRAMES = 240; // until blades are held still

inline BladeScene make_press(const Config &p_config, const Press &p_press) {
	BladeScene scene = make_scene(p_config, Keep::KNOTS, PRESS_FRAMES * p_config.substeps, 1.0);
	scene.params.friction = 0.0;
	scene.add(p_press.shape, p_press.from, p_press.size);
	const float half = float(std::sqrt(0.5));
	if (p_press.shape == GRASS_CAPSULE) { // lying across
		scene.colliders[0].rotation = scene.colliders[0].rotation_before = { half, 0.0f, 0.0f, half };
	}
	const int moves = PRESS_FRAMES / 2 * p_config.substeps;
	const auto place = [&](int p_step) {
		return Eigen::Vector3f(p_press.from + (p_press.to - p_press.from) * (float(std::min(p_step, moves)) / float(moves)));
	};
	for (int i = 0; i < PRESS_FRAMES * p_config.substeps; i++) {
		BladeScene::place(scene.colliders[0], place(i), place(i + 1));
		scene.step(FRAME / p_config.substeps);
	}
	return scene;
}

// Returns how far a blade is from the body's surface, metres.
inline float find_gap(const BladeScene &p_scene, int p_blade) {
	constexpr int POINTS = 16; // of a segment
	const TileCollider body = p_scene.tile_colliders()[0];
	float gap = 1.0f;
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		for (int i = 0; i <= POINTS; i++) {
			gap = std::min(gap, -p_scene.depth_in(body, p_blade, s, float(i) / POINTS));
		}
	}
	return gap;
}

// How far from the body's surface it holds blades: the mean, blade lengths. None should be farther, and none in it.
inline double standoff(const Config &p_config, const Press &p_press) {
	const BladeScene scene = make_press(p_config, p_press);
	double sum = 0.0;
	int held = 0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const float gap = find_gap(scene, b);
		if (gap < scene.length / GRASS_SEGMENTS) {
			sum += std::abs(double(gap / scene.length));
			held++;
		}
	}
	return sum / std::max(held, 1);
}

// Returns the farthest that a knot of a held blade goes in a step, in half a second: blade lengths. A tape does not hold it.
inline double tremble(const Config &p_config, const Press &p_press) {
	BladeScene scene = make_press(p_config, p_press);
	float most = 0.0f;
	for (int i = 0; i < 30 * p_config.substeps; i++) {
		BladeScene before;
		*before.tile = *scene.tile;
		scene.step(FRAME / p_config.substeps);
		most = std::max(most, scene.distance_from(before));
	}
	return double(most);
}

// Returns a ball at 5 m/s over the blades' roots, the same way again in every step: for the time that contact takes.
inline BladeScene make_swept(const Config &p_config, Keep p_keep) {
	BladeScene scene = make_scene(p_config, p_keep, 1, 0.5);
	scene.add(GRASS_SPHERE, Eigen::Vector3f::Zero(), { 0.15f, 0.0f, 0.0f });
	const float half = 0.5f * 5.0f * float(FRAME) / float(p_config.substeps);
	BladeScene::place(scene.colliders[0], { -half, 0.2f, 0.02f }, { half, 0.2f, 0.02f });
	return scene;
}

// Returns the sward that a ball rolls over at p_speed. A tape does not hold it: its blades are of more places in the patch than one.
inline std::vector<Sward> ensemble(const Config &p_config, float p_speed, double p_seconds) {
	return roll_over(p_speed, p_config.substeps / FRAME, p_seconds, [&](BladeScene &r_scene) {
		r_scene.params.method = p_config.method;
		r_scene.params.iterations = p_config.iterations;
		r_scene.step_function = p_config.step;
	});
}
inline std::vector<Sward> slow_ensemble(const Config &p_config) {
	return ensemble(p_config, 1.0f, 2.5);
}
inline std::vector<Sward> fast_ensemble(const Config &p_config) {
	return ensemble(p_config, 5.0f, 1.2);
}

} // namespace grass::test
