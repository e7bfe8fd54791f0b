// SPDX-License-Identifier: MIT
#include "core/solver/hang.h"

#include "core/base/functions.h"
#include "core/base/half.h"
#include "core/solver/simulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

namespace grass {

namespace {

constexpr double GRAVITY = 9.81; // m/s^2
constexpr double DIRECTION_STEPS = 16.0; // to which a direction's components are rounded: about 4 degrees
constexpr double STEP = 0.1; // seconds, for blades that swing once a second
constexpr int HANGING_STEPS = 40; // four swings of a blade without overshoot: it is at rest
constexpr int TILES = GRASS_PATCH_BLADES / GRASS_BLADES_PER_TILE;

// Returns parameters with which all species swing alike: where a blade rests depends only on load over frequency squared.
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

// Lets the blades of a tile come to rest, and writes their knots.
void hang_tile(CpuPool &r_pool, int p_tile, const SolverParams &p_solver, Patch &r_hung) {
	StepClock clock;
	GrassSlot slot;
	slot.list = { uint32_t(p_tile * GRASS_BLADES_PER_TILE), 0, 0, GRASS_SLOT_FRESH };
	for (int i = 0; i < HANGING_STEPS; i++) {
		GrassStep step = clock.advance(p_solver, STEP);
		step.field = { 1.0f, 1.0f, 1.0f, float(GRASS_KNOTS) };
		step.clump = { 1.0f, 0.0f, 0.0f, 0.0f }; // the patch's own shapes
		r_pool.step({ std::span(&slot, 1), {}, {}, {}, step });
		slot.list.w = 0;
	}
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const std::vector<Eigen::Vector3f> knots = r_pool.get_knots(0, b);
		for (int k = 1; k < GRASS_KNOTS; k++) {
			uint16_t *texel = &r_hung.texels[Patch::texel_index(p_tile * GRASS_BLADES_PER_TILE + b, k)];
			for (int c = 0; c < 3; c++) {
				texel[c] = float_to_half(knots[size_t(k)][c]);
			}
		}
	}
}

// Turns a blade that hangs where join_patches() would turn it back to where it is in the patch.
void turn_back(Patch &r_hung, const Patch &p_patch, int p_blade) {
	uint16_t *root = &r_hung.texels[Patch::texel_index(p_blade, 0)];
	const uint16_t *own = &p_patch.texels[Patch::texel_index(p_blade, 0)];
	const double angle = half_to_float(own[2]) - half_to_float(root[2]), along_x = cosine(angle), along_z = sine(angle);
	std::copy(own, own + 4, root);
	for (int k = 1; k < GRASS_KNOTS; k++) {
		uint16_t *texel = &r_hung.texels[Patch::texel_index(p_blade, k)];
		const double x = half_to_float(texel[0]), z = half_to_float(texel[2]);
		texel[0] = float_to_half(float(x * along_x - z * along_z));
		texel[2] = float_to_half(float(z * along_x + x * along_z));
	}
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

Patch hang_patch(
		const Patch &p_patch, const SolverParams &p_solver, const Eigen::Vector3d &p_pull, int p_stems, const std::atomic<bool> *p_stop) {
	if (p_patch.is_empty() || p_patch.species != 1) {
		return p_patch;
	}
	auto placed = std::make_shared<const Patch>(p_patch);
	if (p_stems > 1) {
		const std::array patches{ placed };
		const std::array shares{ 1.0 };
		const std::array stems{ p_stems };
		placed = std::make_shared<const Patch>(join_patches(patches, shares, stems));
	}
	Patch hung = *placed;
	CpuPool pool(placed, 1);
	const SolverParams solver = resting(p_solver, p_pull);
	for (int tile = 0; tile < TILES && !(p_stop != nullptr && *p_stop); tile++) {
		hang_tile(pool, tile, solver, hung);
	}
	for (int b = 0; b < GRASS_PATCH_BLADES && p_stems > 1; b++) {
		turn_back(hung, p_patch, b);
	}
	measure_patch(hung);
	return hung;
}

} // namespace grass
