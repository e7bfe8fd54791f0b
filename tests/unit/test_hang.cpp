// SPDX-License-Identifier: MIT
// Blades on walls and ceilings: gravity and wind in the world's axes, in the field's.
#include "core/solver/hang.h"

#include "grown_tile.h"

#include "core/base/functions.h"
#include "core/base/half.h"
#include "core/blades/wind.h"
#include "core/solver/simulate.h"

#include <Eigen/Geometry>

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <deque>
#include <memory>
#include <vector>

using namespace grass;
using namespace grass::test;

namespace {

Eigen::Matrix3d turned(double p_degrees, const Eigen::Vector3d &p_axis) {
	return Eigen::AngleAxisd(p_degrees * DEGREE, p_axis).toRotationMatrix();
}

Eigen::Vector3d knot_of(const Patch &p_patch, int p_blade, int p_knot) {
	const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_blade, p_knot)];
	return { half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]) };
}

double length_of(const Patch &p_patch, int p_blade) {
	double length = knot_of(p_patch, p_blade, 1).norm();
	for (int k = 2; k < GRASS_KNOTS; k++) {
		length += (knot_of(p_patch, p_blade, k) - knot_of(p_patch, p_blade, k - 1)).norm();
	}
	return length;
}

// Returns the mean tip of all blades, as shares of their lengths.
Eigen::Vector3d mean_tip(const Patch &p_patch) {
	Eigen::Vector3d sum = Eigen::Vector3d::Zero();
	for (int b = 0; b < GRASS_PATCH_BLADES; b++) {
		sum += knot_of(p_patch, b, GRASS_KNOTS - 1) / length_of(p_patch, b);
	}
	return sum / GRASS_PATCH_BLADES;
}

const Patch &hung_on(const Eigen::Matrix3d &p_turn) {
	static std::deque<std::pair<Eigen::Matrix3d, Patch>> made;
	for (const auto &[turn, patch] : made) {
		if (turn == p_turn) {
			return patch;
		}
	}
	return made.emplace_back(p_turn, hang_patch(*shared_patch(), SolverParams(), find_pull(p_turn))).second;
}

const Eigen::Matrix3d WALL = turned(90.0, Eigen::Vector3d::UnitX()); // its blades grow towards the world's z
const Eigen::Matrix3d CEILING = turned(180.0, Eigen::Vector3d::UnitX());

} // namespace

TEST_CASE("Hang: gravity in the field's axes, less that of level ground") {
	CHECK(find_pull(Eigen::Matrix3d::Identity()).isZero(0.0));
	CHECK(find_pull(turned(123.0, Eigen::Vector3d::UnitY())).isZero(0.0));
	CHECK(find_pull(turned(UPRIGHT_TILT - 0.1, Eigen::Vector3d::UnitX())).isZero(0.0));
	CHECK_FALSE(find_pull(turned(UPRIGHT_TILT + 0.1, Eigen::Vector3d::UnitX())).isZero(0.0));
	CHECK(find_pull(CEILING).isApprox(Eigen::Vector3d(0.0, 2.0 * 9.81, 0.0), 1e-12));
	// Down, on the wall, is the field's -Y turned back: along its own z.
	CHECK((WALL * find_pull(WALL)).isApprox(Eigen::Vector3d(0.0, -9.81, 9.81), 1e-12));
	CHECK(find_pull(Eigen::Matrix3d::Constant(std::nan(""))).isZero(0.0));
	CHECK(find_pull(turned(90.5, Eigen::Vector3d::UnitX())) == find_pull(WALL)); // they share their blades
}

TEST_CASE("Hang: blades on a wall sag along the world's down, those of a ceiling hang straighter") {
	const Patch &level = *shared_patch(), &wall = hung_on(WALL), &ceiling = hung_on(CEILING);
	// Without the pull blades on a wall would stand out of it as they stand on level ground.
	const Eigen::Vector3d before = WALL * mean_tip(level), after = WALL * mean_tip(wall);
	CHECK(std::abs(before.y()) < 0.02);
	CHECK(after.y() < -0.15);
	CHECK(std::abs(after.x() - before.x()) < 0.02);
	CHECK(after.z() > 0.2); // still away from the wall
	const Eigen::Vector3d under = CEILING * mean_tip(ceiling);
	CHECK(under.y() < -mean_tip(level).y() - 0.05); // they reach farther down than they stood up
	CHECK(std::hypot(under.x(), under.z()) < 0.02);
	CHECK(ceiling.mean_height > level.mean_height);
}

TEST_CASE("Hang: lengths stay, nothing enters the wall, and all of it is finite") {
	const Patch &level = *shared_patch();
	for (const Eigen::Matrix3d &turn : { WALL, CEILING, turned(135.0, Eigen::Vector3d(1, 0, 1).normalized()) }) {
		const Patch &hung = hung_on(turn);
		double worst = 0.0, lowest = 1.0;
		for (int b = 0; b < GRASS_PATCH_BLADES; b++) {
			worst = std::max(worst, std::abs(length_of(hung, b) / length_of(level, b) - 1.0));
			for (int k = 1; k < GRASS_KNOTS; k++) {
				lowest = std::min(lowest, knot_of(hung, b, k).y());
			}
			CHECK(knot_of(hung, b, 1) == knot_of(level, b, 1)); // clamped
		}
		CHECK(worst < 0.01); // a NaN fails too
		CHECK(lowest > -0.001);
		CHECK(hung.mean_length == doctest::Approx(level.mean_length).epsilon(0.002));
		CHECK(hung.mean_width == level.mean_width);
	}
}

TEST_CASE("Hang: stiffer blades sag less, and no pull changes nothing") {
	SolverParams stiff;
	stiff.natural_frequency = 4.0;
	const Patch &level = *shared_patch();
	const Patch hung = hang_patch(level, stiff, find_pull(WALL));
	const double little = (WALL * mean_tip(hung)).y(), much = (WALL * mean_tip(hung_on(WALL))).y();
	CHECK(little < -0.005);
	CHECK(little > 0.4 * much);
	CHECK(hang_patch(level, SolverParams(), Eigen::Vector3d::Zero()).texels == level.texels);
	std::atomic<bool> is_stopped = true;
	CHECK(hang_patch(level, stiff, find_pull(WALL), 1, &is_stopped).texels == level.texels);
	PatchParams none;
	none.length_min = none.length_max = 0.0;
	CHECK(hang_patch(generate_patch(none), stiff, find_pull(WALL)).is_empty());
}

// The pull is the load that the simulation knows: a blade of the level patch comes to rest where the hung one stands.
TEST_CASE("Hang: the solver's blades rest where hung ones stand") {
	CpuPool pool(shared_patch(), 1);
	SolverParams params;
	const Eigen::Vector3d pull = find_pull(WALL);
	for (int i = 0; i < 3; i++) {
		params.load[i] = pull[i];
	}
	StepClock clock;
	GrassSlot slot;
	slot.list = { 0, 0, 0, GRASS_SLOT_FRESH };
	for (int i = 0; i < 1200; i++) {
		GrassStep step = clock.advance(params, 1.0 / 60.0);
		step.field = { 1.0f, 1.0f, 1.0f, float(GRASS_KNOTS) };
		step.clump = { 1.0f, 0.0f, 0.0f, 0.0f };
		pool.step({ std::span(&slot, 1), {}, {}, {}, step });
		slot.list.w = 0;
	}
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const Eigen::Vector3d tip = pool.get_knots(0, b)[GRASS_KNOTS - 1].cast<double>();
		CHECK((tip - knot_of(hung_on(WALL), b, GRASS_KNOTS - 1)).norm() < 0.02 * length_of(*shared_patch(), b));
	}
}

TEST_CASE("Hang: stems that share a root hang as they are turned") {
	const std::vector<double> shares{ 1.0 };
	const std::vector<int> stems{ 4 };
	const auto joined = [&](const Patch &p_patch) {
		const std::vector<std::shared_ptr<const Patch>> patches{ std::make_shared<const Patch>(p_patch) };
		return join_patches(patches, shares, stems);
	};
	const Patch level = joined(*shared_patch()), wall = joined(hang_patch(*shared_patch(), SolverParams(), find_pull(WALL), 4));
	CHECK((WALL * mean_tip(wall)).y() < -0.15);
	for (int stem = 0; stem < 4; stem++) { // each of them, wherever it points
		double drop = 0.0;
		for (int b = stem; b < GRASS_PATCH_BLADES; b += 4) {
			CHECK(knot_of(wall, b, 0) == knot_of(level, b, 0)); // at its root, and turned as without the pull
			const Eigen::Vector3d change = knot_of(wall, b, GRASS_KNOTS - 1) - knot_of(level, b, GRASS_KNOTS - 1);
			drop += (WALL * change).y() / length_of(level, b) / (GRASS_PATCH_BLADES / 4);
		}
		CHECK(drop < -0.15);
	}
}

TEST_CASE("Wind: blows along the world's axes, whatever way a field is turned") {
	const Eigen::Vector2d level = wind_in_field(Eigen::Matrix3d::Identity(), 3.0, 20.0);
	CHECK(level == Eigen::Vector2d(3.0 * std::cos(20.0 * DEGREE), 3.0 * std::sin(20.0 * DEGREE)));
	const auto in_world = [](const Eigen::Matrix3d &p_turn) -> Eigen::Vector3d {
		const Eigen::Vector2d wind = wind_in_field(p_turn, 3.0, 20.0);
		return p_turn * Eigen::Vector3d(wind.x(), 0.0, wind.y());
	};
	const Eigen::Vector3d world(level.x(), 0.0, level.y());
	CHECK(in_world(turned(75.0, Eigen::Vector3d::UnitY())).isApprox(world, 1e-12));
	CHECK(in_world(CEILING).isApprox(world, 1e-12));
	// On the wall what blows along it is left.
	CHECK((in_world(WALL) - Eigen::Vector3d(world.x(), 0.0, 0.0)).norm() < 1e-12);
}
