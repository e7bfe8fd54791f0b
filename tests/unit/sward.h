// SPDX-License-Identifier: MIT
// Blades of the default patch that a ball rolls over, as an ensemble: how high they stand, how many are pressed.
#pragma once

#include "blade_scene.h"
#include "grown_tile.h"

#include "core/base/half.h"

namespace grass::test {

// A sward at one time: the mean of its blades' heights, shares of those at rest, and the share that is pressed below half of that.
struct Sward {
	double height, pressed;
};

struct SwardError {
	double height, pressed, worst; // root mean squares over time; the greatest of `pressed`
};

// 512 blades of the default patch, in eight tiles.
inline std::vector<BladeScene> make_sward(const std::function<void(BladeScene &)> &p_set_up) {
	constexpr int TILES = 8, APART = 2000; // APART: blades of the patch from one tile to the next
	constexpr float TILE = 0.5f; // metres
	const std::shared_ptr<const Patch> patch = shared_patch();
	std::vector<BladeScene> scenes(TILES);
	for (int tile = 0; tile < TILES; tile++) {
		BladeScene &scene = scenes[tile];
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const auto number = [&](int p_knot, int p_component) {
				return half_to_float(patch->texels[Patch::texel_index(APART * tile + b, p_knot) + p_component]);
			};
			scene.set_rest(b, 0, Eigen::Vector3f::Zero());
			for (int k = 1; k < GRASS_KNOTS; k++) {
				scene.set_rest(b, k, { number(k, 0), number(k, 1), number(k, 2) });
			}
			scene.tile->root[0][b] = (number(0, 0) - 0.5f) * TILE;
			scene.tile->root[2][b] = (number(0, 1) - 0.5f) * TILE;
			scene.tile->width[0][b] = cos_of(number(0, 2));
			scene.tile->width[1][b] = sin_of(number(0, 2));
		}
		p_set_up(scene);
	}
	return scenes;
}

inline Sward look_at(const std::vector<BladeScene> &p_scenes) {
	const double blades = double(p_scenes.size()) * GRASS_BLADES_PER_TILE;
	Sward sward{};
	for (const BladeScene &scene : p_scenes) {
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			float now = 0.0f, rest = 0.0f;
			for (int k = 1; k < GRASS_KNOTS; k++) {
				now = std::max(now, scene.knot(b, k).y());
				rest = std::max(rest, scene.rest(b, k).y());
			}
			sward.height += double(now / rest) / blades;
			sward.pressed += now < 0.5f * rest ? 1.0 / blades : 0.0;
		}
	}
	return sward;
}

// Returns the sward 30 times a second, while a ball of 15 cm rolls over the middle of its tiles at p_speed (m/s) and for a while after.
inline std::vector<Sward> roll_over(float p_speed, double p_rate, double p_seconds, const std::function<void(BladeScene &)> &p_set_up) {
	constexpr float RADIUS = 0.15f; // metres
	std::vector<BladeScene> scenes = make_sward(p_set_up);
	for (BladeScene &scene : scenes) {
		scene.add(GRASS_SPHERE, { -0.7f, RADIUS, 0.0f }, { RADIUS, 0.0f, 0.0f });
	}
	std::vector<Sward> seen;
	Sward before = look_at(scenes);
	for (int i = 0; i < int(std::lround(p_seconds * p_rate)); i++) {
		const auto place = [&](int p_step) { return Eigen::Vector3f(-0.7f + p_speed * float(p_step / p_rate), RADIUS, 0.0f); };
		for (BladeScene &scene : scenes) {
			BladeScene::place(scene.colliders[0], place(i), place(i + 1));
			scene.step(1.0 / p_rate);
		}
		const Sward now = look_at(scenes);
		const double late = double(i + 1) - double(seen.size() + 1) * p_rate / 30.0; // steps after the next look
		if (late >= -1e-6) {
			seen.push_back({ now.height + (before.height - now.height) * late, now.pressed + (before.pressed - now.pressed) * late });
		}
		before = now;
	}
	return seen;
}

// Of as many looks in both.
inline SwardError difference(const std::vector<Sward> &p_a, const std::vector<Sward> &p_b) {
	SwardError error{};
	for (size_t i = 0; i < p_a.size(); i++) {
		const double height = p_a[i].height - p_b[i].height, pressed = std::abs(p_a[i].pressed - p_b[i].pressed);
		error.height += height * height / double(p_a.size());
		error.pressed += pressed * pressed / double(p_a.size());
		error.worst = std::max(error.worst, pressed);
	}
	return { std::sqrt(error.height), std::sqrt(error.pressed), error.worst };
}

} // namespace grass::test
