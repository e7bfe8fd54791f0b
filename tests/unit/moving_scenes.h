// SPDX-License-Identifier: MIT
// Bodies, blasts and hills as games have them: what a field's blades do as they change from chains to their strains, beside a pool that
// moves chains all the time.
#pragma once

#include "grown_tile.h"

#include "core/base/half.h"
#include "core/field/field.h"
#include "core/paint/brush.h"
#include "core/solver/simulate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace grass::test {

inline constexpr double SCENE_TICK = 1.0 / 60.0;

// A field on the CPU, and a pool that takes its steps by chains.
class PooledField : public Simulator {
public:
	explicit PooledField(const FieldSetup &p_setup, const MapLayers *p_map = nullptr) : pool(p_setup.patch), chains(p_setup.patch) {
		FieldParams params;
		params.detail = SimulationDetail::WHOLE;
		field.set(p_setup, field.bounds_of(p_setup), p_map, {}, params);
	}
	void step(const StepInput &p_input) override {
		pool.step(p_input);
		records.assign(p_input.slots.begin(), p_input.slots.end());
		std::vector<GrassSlot> of_chains = records;
		for (GrassSlot &slot : of_chains) {
			slot.list.w &= ~uint32_t(GRASS_SLOT_ALONE);
		}
		StepInput input = p_input;
		input.slots = of_chains;
		chains.step(input);
		_step = p_input.number;
	}
	void join(std::span<const GrassSlot> p_slots, const GrassStep &) override {
		for (const GrassSlot &slot : p_slots) {
			pool.join(slot);
			chains.join(slot);
		}
	}
	void resize_pool(int p_slots, std::span<const SlotMove> p_moves) override {
		pool.resize(p_slots, p_moves);
		chains.resize(p_slots, p_moves);
	}
	EnergyReport read_energy() override { return { _step > 0 ? _step - 1 : 0, pool.get_energy(), pool.get_bends() }; }
	void tick(const FieldView &p_view, std::vector<ColliderShape> p_bodies, std::span<const Force> p_forces) {
		field.see(*this, p_view, true);
		field.begin_tick(*this, true, SCENE_TICK);
		field.resume();
		field.tick(*this, p_bodies, SCENE_TICK, p_forces);
	}
	// Returns how far the knots of a slot are from where chains have them, metres: the farthest of each blade.
	std::vector<float> apart(int p_slot) const {
		std::vector<float> most(GRASS_BLADES_PER_TILE, 0.0f);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const std::vector<Eigen::Vector3f> knots = pool.get_knots(p_slot, b), other = chains.get_knots(p_slot, b);
			for (size_t k = 0; k < knots.size(); k++) {
				most[size_t(b)] = std::max(most[size_t(b)], (knots[k] - other[k]).norm());
			}
		}
		return most;
	}

	Field field;
	CpuPool pool, chains;
	std::vector<GrassSlot> records; // of the last step

private:
	uint64_t _step = 0;
};

// Bodies, forces and ground, as functions of a scene's time.
struct MovingScene {
	std::function<std::vector<ColliderShape>(double)> bodies = [](double) { return std::vector<ColliderShape>(); };
	std::vector<std::pair<double, Force>> blasts; // seconds until each
	bool has_hills = false;
	Eigen::Vector3f eye{ 0.0f, 1.7f, 14.0f };
};

inline ColliderShape shape_at(int p_type, const Eigen::Vector3d &p_size, const Eigen::Vector3d &p_now, const Eigen::Vector3d &p_before) {
	ColliderShape shape;
	shape.type = p_type;
	shape.size = p_size;
	shape.now.position = p_now;
	shape.before.position = p_before;
	return shape;
}

// Where a thrown ball is: it flies, bounces once, and rolls until friction stops it. p_ground: its centre's least height.
inline Eigen::Vector3d thrown_at(const Eigen::Vector3d &p_from, const Eigen::Vector3d &p_speed, double p_ground, double p_time) {
	const double g = 9.81, lands = (p_speed.y() + std::sqrt(p_speed.y() * p_speed.y() + 2.0 * g * (p_from.y() - p_ground))) / g;
	const double flown = std::min(p_time, lands), rolls = std::clamp(p_time - lands, 0.0, 2.5);
	Eigen::Vector3d place = p_from + p_speed * flown;
	place.y() = std::max(p_from.y() + p_speed.y() * flown - 0.5 * g * flown * flown, p_ground);
	const double along = 0.6 * (rolls - 0.2 * rolls * rolls);
	return place + Eigen::Vector3d(p_speed.x() * along, 0.0, p_speed.z() * along);
}

inline MovingScene thrown_scene(std::mt19937 &r_random) {
	struct Ball {
		Eigen::Vector3d from, speed;
		double radius, start;
	};
	std::uniform_real_distribution<double> share(-1.0, 1.0);
	std::vector<Ball> balls;
	for (int i = 0; i < 20; i++) {
		balls.push_back({ { 6.0 * share(r_random), 1.5, 6.0 + 5.0 * share(r_random) },
				{ 3.0 * share(r_random), 2.5 + 2.0 * share(r_random), -6.0 + 3.0 * share(r_random) }, 0.22 + 0.1 * share(r_random),
				0.4 + 0.4 * share(r_random) });
	}
	MovingScene scene;
	scene.bodies = [balls](double p_time) {
		std::vector<ColliderShape> shapes;
		for (const Ball &ball : balls) {
			const auto at = [&](double p_at) { return thrown_at(ball.from, ball.speed, ball.radius, std::max(p_at - ball.start, 0.0)); };
			shapes.push_back(shape_at(GRASS_SPHERE, { ball.radius, 0, 0 }, at(p_time), at(p_time - SCENE_TICK)));
		}
		return shapes;
	};
	return scene;
}

// Two feet that take turns.
inline MovingScene walker_scene(std::mt19937 &r_random) {
	std::uniform_real_distribution<double> share(-1.0, 1.0);
	const double x = 4.0 * share(r_random), stride = 0.75 + 0.1 * share(r_random), phase = share(r_random);
	MovingScene scene;
	scene.bodies = [=](double p_time) {
		std::vector<ColliderShape> shapes;
		for (const int side : { 0, 1 }) {
			const auto at = [&](double p_at) {
				const double steps = p_at * 2.0 + phase + side, number = std::floor(steps / 2.0), swing = steps - 2.0 * number;
				const double way = 2.0 * stride * (number + std::clamp(swing, 0.0, 1.0) - side * 0.5);
				const double lift = swing < 1.0 ? 0.18 * std::sin(3.14159 * swing) : 0.0;
				return Eigen::Vector3d(x + (side == 0 ? -0.12 : 0.12), 0.07 + lift, 5.0 - way);
			};
			shapes.push_back(shape_at(GRASS_BOX, { 0.05, 0.06, 0.14 }, at(p_time), at(p_time - SCENE_TICK)));
		}
		return shapes;
	};
	return scene;
}

inline MovingScene jeep_scene(std::mt19937 &r_random) {
	std::uniform_real_distribution<double> share(-1.0, 1.0);
	const double z = 2.0 + 3.0 * share(r_random), speed = 8.0 + 3.0 * share(r_random);
	MovingScene scene;
	scene.bodies = [=](double p_time) {
		std::vector<ColliderShape> shapes;
		for (const double wheel_x : { -1.2, 1.2 }) {
			for (const double wheel_z : { -0.75, 0.75 }) {
				const auto at = [&](double p_at) { return Eigen::Vector3d(wheel_x - 12.0 + speed * p_at, 0.36, z + wheel_z); };
				shapes.push_back(shape_at(GRASS_SPHERE, { 0.36, 0, 0 }, at(p_time), at(p_time - SCENE_TICK)));
			}
		}
		const auto at = [&](double p_at) { return Eigen::Vector3d(-12.0 + speed * p_at, 0.75, z); };
		shapes.push_back(shape_at(GRASS_BOX, { 1.8, 0.3, 0.8 }, at(p_time), at(p_time - SCENE_TICK)));
		return shapes;
	};
	return scene;
}

inline MovingScene blast_scene(std::mt19937 &r_random) {
	std::uniform_real_distribution<double> share(-1.0, 1.0);
	MovingScene scene;
	for (int i = 0; i < 3; i++) {
		Force blast;
		blast.place = { 6.0 * share(r_random), 0.4, 5.0 * share(r_random) - 2.0 };
		blast.speed = 16.0 + 4.0 * share(r_random);
		blast.radius = 4.0;
		scene.blasts.push_back({ 0.1 + 0.5 * i, blast });
	}
	return scene;
}

// Balls that roll down a hill.
inline MovingScene hill_scene(std::mt19937 &r_random) {
	std::uniform_real_distribution<double> share(-1.0, 1.0);
	std::vector<Eigen::Vector3d> starts;
	for (int i = 0; i < 6; i++) {
		starts.push_back({ 6.0 + 2.0 * share(r_random), 0.2 + 0.1 * share(r_random), 5.0 * share(r_random) });
	}
	MovingScene scene;
	scene.has_hills = true;
	scene.eye = { 0.0f, 4.5f, 14.0f };
	scene.bodies = [starts](double p_time) {
		std::vector<ColliderShape> shapes;
		for (const Eigen::Vector3d &start : starts) {
			const auto at = [&](double p_at) {
				const double x = start.x() - 1.2 * std::min(std::max(p_at, 0.0), 2.0) * std::max(p_at, 0.0);
				return Eigen::Vector3d(x, 0.5 * x + 0.25 * start.z() + start.y(), start.z());
			};
			shapes.push_back(shape_at(GRASS_SPHERE, { start.y() * 1.12, 0, 0 }, at(p_time), at(p_time - SCENE_TICK)));
		}
		return shapes;
	};
	return scene;
}

inline constexpr std::array<const char *, 5> SCENE_NAMES{ "thrown bodies", "a walker", "a jeep", "blasts", "hills" };
inline MovingScene make_scene(int p_scene, uint32_t p_seed) {
	std::mt19937 random(p_seed);
	MovingScene (*const scenes[])(std::mt19937 &) = { thrown_scene, walker_scene, jeep_scene, blast_scene, hill_scene };
	return scenes[size_t(p_scene)](random);
}

// What became of the blades of a scene as they changed to their strains for the first time.
struct Changes {
	std::vector<float> jumps; // how far each of them is from where its chain would be after the step, metres
	int64_t tile_steps = 0, strain_steps = 0; // of tiles without a collider, all and those by strains
	float largest() const { return jumps.empty() ? 0.0f : *std::ranges::max_element(jumps); }
};

// Returns a picture of 1080 lines, 75 degrees high.
inline FieldView player_view(const Eigen::Vector3f &p_eye) {
	ViewCamera camera;
	camera.planes.fill(Eigen::Vector4f(1.0f, 0.0f, 0.0f, 1000.0f));
	camera.eye = p_eye;
	camera.pixel_slope = 2.0f * std::tan(0.5f * 75.0f * 3.14159265f / 180.0f) / 1080.0f;
	FieldView view;
	view.cameras = { camera };
	view.is_watched = true;
	return view;
}

inline FieldSetup scene_setup(bool p_is_mapped) {
	FieldSetup setup;
	setup.grid = TileGrid::make(40.0, 40.0, 256.0); // tiles of half a metre
	setup.patch = shared_patch();
	setup.pool_size = 1536;
	setup.is_mapped = p_is_mapped;
	return setup;
}

inline Changes run_scene(int p_scene, uint32_t p_seed, int p_ticks) {
	const MovingScene scene = make_scene(p_scene, p_seed);
	const FieldSetup setup = scene_setup(scene.has_hills);
	PaintMap map;
	MapLayers layers(setup.map_place());
	if (scene.has_hills) {
		paint(map, MapTool::PAINT, 1.0, disc(0.0, 0.0, 40.0));
		for (int j = -25; j < 25; j++) {
			for (int i = -25; i < 25; i++) {
				map.set_code(MAP_GROUND, 0, i, j, info_of(MAP_GROUND).code(0.5 * (i + 0.5) + 0.25 * (j + 0.5)));
			}
		}
		layers.update(map, layers.get_region());
	}
	PooledField field(setup, scene.has_hills ? &layers : nullptr);
	const FieldView view = player_view(scene.eye);
	std::set<int> changed; // tiles, since they woke
	Changes changes;
	for (int tick = 0; tick < p_ticks; tick++) {
		const double time = tick * SCENE_TICK;
		std::vector<ColliderShape> bodies = scene.bodies(time);
		std::vector<Force> forces;
		for (const auto &[begin, blast] : scene.blasts) {
			if (time >= begin && time < begin + blast.duration) {
				forces.push_back(blast);
				forces.back().age = time - begin;
				bodies.push_back(forces.back().make_shape(int(forces.size()) - 1));
			}
		}
		field.tick(view, bodies, forces);
		for (const GrassSlot &slot : field.records) {
			if (slot.list.w & (GRASS_SLOT_RETIRED | GRASS_SLOT_FRESH)) {
				changed.erase(slot.tile.z);
				continue;
			}
			const bool is_alone = slot.list.w & GRASS_SLOT_ALONE;
			changes.tile_steps += slot.list.z == 0 ? 1 : 0;
			changes.strain_steps += is_alone ? 1 : 0;
			if (is_alone && changed.insert(slot.tile.z).second) {
				const std::vector<float> apart = field.apart(slot.tile.w);
				changes.jumps.insert(changes.jumps.end(), apart.begin(), apart.end());
			}
		}
	}
	return changes;
}

inline void check_scene(int p_scene, uint32_t p_seed, int p_ticks) {
	const Changes changes = run_scene(p_scene, p_seed, p_ticks);
	INFO(SCENE_NAMES[size_t(p_scene)] << ", seed " << p_seed << ": of " << changes.jumps.size() << " blades that changed one jumped by "
									  << 1e3f * changes.largest() << " mm; " << changes.strain_steps << " of " << changes.tile_steps
									  << " steps of tiles without colliders were by strains");
	// A breeze moves its tiles over at once, while it throws blades by centimetres a step.
	const bool has_bodies = make_scene(p_scene, p_seed).blasts.empty();
	CHECK(changes.jumps.size() > 1000);
	CHECK(changes.largest() > 0.0f);
	CHECK(changes.largest() < 0.008f); // a blade that a body has bent sharply at its root
	const auto jumped = std::ranges::count_if(changes.jumps, [](float p_jump) { return p_jump > 0.001f; });
	CHECK(jumped < int(changes.jumps.size()) / (has_bodies ? 1000 : 400));
	CHECK(double(changes.strain_steps) > 0.28 * double(changes.tile_steps));
}

} // namespace grass::test
