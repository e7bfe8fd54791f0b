// SPDX-License-Identifier: MIT
// Friction: what a plate that is pressed on the tips pulls them with, by the moments that it leaves in the joints.
#include <doctest/doctest.h>

#include "blade_scene.h"

#include "core/solver/chain.h"

#include <Eigen/LU>

using namespace grass;
using namespace grass::test;

namespace {

// Returns the force at the tip that holds a blade as it stands, in any unit: of all joints' moments, by least squares.
Eigen::Vector3d find_tip_force(const BladeScene &p_scene, int p_blade) {
	Blade<double> blade;
	for (int k = 0; k < GRASS_KNOTS; k++) {
		const Eigen::Vector3f rest = p_scene.rest(p_blade, k), knot = p_scene.knot(p_blade, k);
		blade.rest[k] = { rest.x(), rest.y(), rest.z() };
		blade.knots[k] = { knot.x(), knot.y(), knot.z() };
	}
	for (int k = GRASS_CLAMPED_KNOTS; k < GRASS_KNOTS; k++) {
		blade.twist[k - 1] = double(p_scene.tile->twist[k - GRASS_CLAMPED_KNOTS][p_blade]);
	}
	measure_lengths(blade);
	blade.width = { double(p_scene.tile->width[0][p_blade]), 0.0, double(p_scene.tile->width[1][p_blade]) };
	StepClock clock;
	const ChainTerms<double> chain = make_chain_terms(blade, make_terms<double>(clock.advance(p_scene.params, 1.0 / 60.0), 0.0f, {}));
	JointGain<double> joints[GRASS_SEGMENTS];
	measure_joints(blade, chain, joints);
	Eigen::Matrix<double, 3 * (GRASS_SEGMENTS - 1), 3> levers;
	Eigen::Matrix<double, 3 * (GRASS_SEGMENTS - 1), 1> moments;
	for (int s = 1; s < GRASS_SEGMENTS; s++) {
		const Eigen::Vector3d lever = (p_scene.knot(p_blade, GRASS_KNOTS - 1) - p_scene.knot(p_blade, s)).cast<double>();
		levers.block<3, 3>(3 * (s - 1), 0) << 0.0, -lever.z(), lever.y(), lever.z(), 0.0, -lever.x(), -lever.y(), lever.x(), 0.0;
		const Vec3<double> turn = joints[s].turn + joints[s].axis * dot(joints[s].axis, joints[s].turn);
		moments.segment<3>(3 * (s - 1)) = Eigen::Vector3d(turn.x, turn.y, turn.z) * joint_stiffness(blade, s, chain, 1.0);
	}
	const Eigen::Matrix3d normal = levers.transpose() * levers;
	return normal.inverse() * (levers.transpose() * moments);
}

// A plate comes down on the tips to 80 % of the blades' length, rests for a second and is pulled aside at p_speed (m/s) for two, at least
// 20 cm far. Of the median blade, in the last quarter of that: force along the plate over the force across it.
double find_friction(double p_friction, double p_speed, int p_iterations) {
	constexpr double LOW = 0.4, HIGH = 0.65; // of the plate's lower side, metres
	BladeScene scene;
	scene.params.iterations = p_iterations;
	scene.add(GRASS_BOX, { 0.0f, 1.0f, 0.0f }, { 4.0f, 0.1f, 4.0f });
	double height = HIGH, aside = 0.0;
	const auto move = [&](double p_height, double p_aside) {
		BladeScene::place(scene.colliders[0], { 0.0f, float(height + 0.1), float(aside) }, { 0.0f, float(p_height + 0.1), float(p_aside) });
		scene.colliders[0].position.w = float(p_friction);
		height = p_height;
		aside = p_aside;
		scene.step();
	};
	for (int i = 1; i <= 60; i++) {
		move(HIGH + (LOW - HIGH) * i / 60.0, 0.0);
	}
	for (int i = 0; i < 60; i++) {
		move(LOW, 0.0);
	}
	const int steps = std::max(120, int(12.0 / p_speed));
	std::vector<Eigen::Vector3d> forces(GRASS_BLADES_PER_TILE, Eigen::Vector3d::Zero());
	for (int i = 0; i < steps; i++) {
		move(LOW, aside + p_speed / 60.0);
		for (int b = 0; b < GRASS_BLADES_PER_TILE && 4 * i >= 3 * steps; b++) {
			forces[size_t(b)] += find_tip_force(scene, b);
		}
	}
	std::vector<double> ratios;
	for (const Eigen::Vector3d &force : forces) {
		ratios.push_back(std::hypot(force.x(), force.z()) / -force.y());
	}
	std::sort(ratios.begin(), ratios.end());
	return ratios[ratios.size() / 2];
}

} // namespace

TEST_CASE("METHOD_DIRECT: a plate that slides over the tips pulls them by its friction, slowly and quickly") {
	struct Pull {
		double friction, speed; // m/s
		int iterations;
	};
	// At 60 steps a second and strong friction two solves leave a quick plate's contacts in a cycle.
	for (const Pull &pull : { Pull{ 0.1, 0.05, 2 }, Pull{ 0.3, 0.05, 2 }, Pull{ 0.6, 0.05, 2 }, Pull{ 0.1, 0.5, 2 }, Pull{ 0.3, 0.5, 2 },
				 Pull{ 0.6, 0.5, 4 } }) {
		CAPTURE(pull.friction);
		CAPTURE(pull.speed);
		const double found = find_friction(pull.friction, pull.speed, pull.iterations);
		CHECK(found > 0.97 * pull.friction);
		CHECK(found < 1.01 * pull.friction);
		MESSAGE("friction ", pull.friction, " at ", pull.speed, " m/s: ", found);
	}
	CHECK(std::abs(find_friction(0.0, 0.5, 2)) < 1e-3);
}
