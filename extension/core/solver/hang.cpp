// SPDX-License-Identifier: MIT
#include "core/solver/hang.h"

#include "core/base/half.h"
#include "core/solver/simulate.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace grass {

namespace {

constexpr double GRAVITY = 9.81; // m/s^2
constexpr double DIRECTION_STEPS = 16.0; // to which a direction's components are rounded: about 4 degrees
constexpr double DEGREE = std::numbers::pi / 180.0;
constexpr double STEP = 0.1; // seconds, for blades that swing once a second
constexpr int STEPS = 40; // four swings of a blade without overshoot: it is at rest
constexpr int TILES = GRASS_PATCH_BLADES / GRASS_BLADES_PER_TILE;

// Where a blade rests depends on load over frequency squared, so all species swing alike here.
SolverParams resting(const SolverParams &p_solver, const Eigen::Vector3d &p_pull) {
	SolverParams solver = p_solver.sanitised();
	const Eigen::Vector3d load = p_pull / (solver.natural_frequency * solver.natural_frequency);
	solver.method = Method::DIRECT;
	solver.natural_frequency = 1.0;
	solver.damping_ratio = 1.0;
	for (int i = 0; i < 3; i++) {
		solver.load[i] = load[i];
	}
	return solver;
}

} // namespace

Eigen::Vector3d find_pull(const Eigen::Matrix3d &p_turn) {
	const Eigen::Vector3d level = -Eigen::Vector3d::UnitY(), down = p_turn.transpose() * level;
	if (!down.allFinite() || down.dot(level) >= std::cos(UPRIGHT_TILT * DEGREE)) {
		return Eigen::Vector3d::Zero();
	}
	const Eigen::Vector3d rounded = (down * DIRECTION_STEPS).array().round();
	return GRAVITY * (rounded.normalized() - level);
}

Patch hang_patch(const Patch &p_patch, const SolverParams &p_solver, const Eigen::Vector3d &p_pull, const std::atomic<bool> *p_stop) {
	Patch hung = p_patch;
	if (p_patch.is_empty() || p_patch.species != 1) {
		return hung;
	}
	CpuPool pool(std::make_shared<const Patch>(p_patch), 1);
	const SolverParams solver = resting(p_solver, p_pull);
	for (int tile = 0; tile < TILES && !(p_stop != nullptr && *p_stop); tile++) {
		StepClock clock;
		GrassSlot slot;
		slot.list = { uint32_t(tile * GRASS_BLADES_PER_TILE), 0, 0, GRASS_SLOT_FRESH };
		for (int i = 0; i < STEPS; i++) {
			GrassStep step = clock.advance(solver, STEP);
			step.field = { 1.0f, 1.0f, 1.0f, float(GRASS_KNOTS) };
			step.clump = { 1.0f, 0.0f, 0.0f, 0.0f }; // the patch's own shapes
			pool.step({ std::span(&slot, 1), {}, {}, {}, step });
			slot.list.w = 0;
		}
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const std::vector<Eigen::Vector3f> knots = pool.get_knots(0, b);
			for (int k = 1; k < GRASS_KNOTS; k++) {
				uint16_t *texel = &hung.texels[Patch::texel_index(tile * GRASS_BLADES_PER_TILE + b, k)];
				for (int c = 0; c < 3; c++) {
					texel[c] = float_to_half(knots[size_t(k)][c]);
				}
			}
		}
	}
	measure_patch(hung);
	return hung;
}

} // namespace grass
