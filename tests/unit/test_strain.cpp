// SPDX-License-Identifier: MIT
// Blades by their strains: the basis, what they stand like under loads, and what must hold to the bit.
#include "strain_scene.h"

#include "core/solver/section.h"
#include "kirchhoff_rod.h"

#include <doctest/doctest.h>

#include <array>
#include <numbers>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int TIP = GRASS_KNOTS - 1;
constexpr double PI = std::numbers::pi;

Eigen::Vector3d tip_of(const StrainScene &p_scene) {
	return p_scene.knot(0, TIP).cast<double>() / 0.5;
}
// Where the tip stands under a load of density area g length^3 / EI at the root, shares of the length.
Eigen::Vector3d standing(StrainScene p_scene, const Eigen::Vector3d &p_load) {
	p_scene.params().damping_ratio = 1.0;
	const double share = 2.0 * PI * p_scene.params().natural_frequency / 3.5160152685;
	const double bending = share * share * make_section(p_scene.params().taper).stiffness;
	for (int i = 0; i < 900; i++) {
		for (int c = 0; c < 3; c++) {
			p_scene.params().load[c] = p_load[c] * bending * 0.5 * std::min(1.0, (i + 1) / 300.0);
		}
		p_scene.step();
	}
	return tip_of(p_scene);
}

// Random loads, forces and kinds of blades: one step after another.
struct Blown {
	StrainScene scene;
	AirLoad air;
	std::mt19937 engine;
	std::vector<StrainSection<float>> sections{ make_strain_section(0.3, 2.0), make_strain_section(0.3, 5.0) };

	explicit Blown(TileStep p_step, unsigned p_seed) : engine(p_seed) {
		scene.blades.step_function = p_step;
		scene.params().damping_ratio = 0.05;
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			scene.blades.tile->species[b] = uint8_t(engine() % 2);
		}
	}
	void step() {
		std::uniform_real_distribution<float> of(-1.0f, 1.0f);
		for (double &load : scene.params().load) {
			load = 20.0 * double(of(engine));
		}
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			for (auto &row : air.load) {
				row[b] = 8.0f * of(engine);
			}
			air.drag[b] = 1.0f + of(engine);
		}
		scene.blades.tile->air = &air;
		scene.blades.tile->sections = sections.data();
		SolverParams other = scene.params();
		other.natural_frequency = 3.0;
		other.width_to_thickness = 5.0;
		const std::array steps{ scene.blades.clock.advance(scene.params(), 1.0 / 60.0), scene.blades.clock.repeat(other) };
		scene.blades.energy = scene.blades.step_function(*scene.blades.tile, steps, 0.0f, {});
	}
};

template <class A> bool is_same(const A &p_a, const A &p_b) {
	return std::memcmp(&p_a, &p_b, sizeof(A)) == 0;
}
bool has_same_blades(const TileState &p_a, const TileState &p_b) {
	return is_same(p_a.knots, p_b.knots) && is_same(p_a.before, p_b.before) && is_same(p_a.twist, p_b.twist) &&
			is_same(p_a.strains, p_b.strains) && is_same(p_a.strains_before, p_b.strains_before);
}

} // namespace

TEST_CASE("strains: the table of the basis is what its definition gives, and keeps a bend's lever beyond the first joint") {
	for (int order = 0; order < GRASS_STRAIN_ORDERS; order++) {
		for (int joint = 1; joint <= GRASS_STRAIN_JOINTS; joint++) {
			CHECK(double(JOINT_TURNS[joint - 1][order]) == doctest::Approx(joint_turn_of(joint, order)).epsilon(1e-7));
		}
	}
	for (int knot = 2; knot <= TIP; knot++) { // the first function is the root of 3 times 1 - s
		const double s = knot_share(knot);
		double offset = 0.0;
		for (int joint = 1; joint < knot; joint++) {
			offset += joint_turn_of(joint, 0) * (knot_share(knot) - knot_share(joint));
		}
		CHECK(offset == doctest::Approx(std::sqrt(3.0) * (s * s / 2.0 - s * s * s / 6.0)).epsilon(1e-9));
	}
}

TEST_CASE("strains: of an even round blade the springs are 1 on the diagonal, and masses weigh powers of the way as the blade does") {
	const StrainSection<float> even = make_strain_section(0.0, 1.0);
	for (int i = 0; i < GRASS_STRAIN_ORDERS; i++) {
		for (int j = 0; j <= i; j++) {
			CHECK(double(even.soft.at[half_place(i, j)]) == doctest::Approx(i == j ? 1.0 : 0.0).epsilon(1e-6));
			CHECK(double(even.stiff.at[half_place(i, j)]) == doctest::Approx(i == j ? 1.0 : 0.0).epsilon(1e-6));
		}
	}
	for (const double taper : { 0.0, 0.3, 0.9 }) {
		const StrainSection<float> section = make_strain_section(taper, 5.0);
		for (int power = 2; power <= 7; power++) {
			double sum = 0.0;
			for (int i = 0; i < GRASS_STRAIN_MASSES; i++) {
				CHECK(section.mass[i] > 0.0f);
				sum += double(section.mass[i]) * std::pow(knot_share(GRASS_STRAIN_FIRST_MASS + 2 * i), power);
			}
			CHECK(sum == doctest::Approx(1.0 / (power + 1) - taper / (power + 2)).epsilon(1e-6));
		}
	}
}

TEST_CASE("strains: a blade hangs as the elastica within 0.3 %, from a slight sag to a blade that hangs down") {
	for (const auto &[gamma, drop] :
			{ std::pair(0.1, 0.012498), std::pair(1.0, 0.123471), std::pair(5.0, 0.495905), std::pair(20.0, 0.829881) }) {
		StrainScene scene = StrainScene::straight();
		scene.params().taper = 0.0;
		scene.params().width_to_thickness = 1.0;
		const double found = standing(std::move(scene), { gamma, 0.0, 0.0 }).x();
		INFO("under ", gamma, ": ", found);
		CHECK(found == doctest::Approx(drop).epsilon(0.003));
	}
}

TEST_CASE("strains: a blade that tapers and is wider than thick bends as such a rod within 1.2 %: in its plane, aslant and across") {
	for (const double turn : { 0.0, 2.0 }) {
		for (const auto &[taper, wide] : { std::pair(0.9, 1.0), std::pair(0.5, 5.0), std::pair(0.3, 20.0) }) {
			for (const double gamma : { 0.3, 8.0 }) {
				for (const double heading : { 0.0, 0.25 * PI, 0.5 * PI }) {
					const Eigen::Vector3d load = Eigen::Vector3d(std::cos(heading), 0.0, std::sin(heading)) * gamma;
					StrainScene scene = StrainScene::along(
							[turn](double p_s) { return Eigen::Vector3d(std::sin(turn * p_s), std::cos(turn * p_s), 0.0); });
					scene.params().taper = taper;
					scene.params().width_to_thickness = wide;
					const Eigen::Vector3d rest = tip_of(scene), found = standing(std::move(scene), load) - rest;
					const KirchhoffRod unloaded = leaf(turn, taper, wide, Eigen::Vector3d::Zero());
					const Eigen::Vector3d wanted = leaf(turn, taper, wide, load).tip() - unloaded.shoot(Eigen::Vector3d::Zero()).place;
					const double error = (found - wanted).norm() / wanted.norm();
					INFO(turn, ", taper ", taper, ", ", wide, " x, ", gamma, ", ", heading, ": ", error);
					CHECK(error < 0.012);
				}
			}
		}
	}
}

TEST_CASE("strains: a blade at rest stays there to the bit, and one that settles arrives there exactly") {
	StrainScene scene;
	scene.step_for(2.0);
	CHECK(scene.blades.is_exactly_at_rest());
	CHECK(scene.largest_number() == 0.0f);
	scene.hold(8.0, { 1.0, 0.0, 0.5 });
	scene.step();
	CHECK(scene.offset(0, TIP).norm() > 0.2f);
	scene.blades.blend = 0.5f;
	scene.step();
	CHECK(scene.offset(0, TIP).norm() > 0.02f);
	scene.blades.blend = 1.0f;
	scene.step();
	CHECK(scene.blades.is_exactly_at_rest());
	CHECK(scene.largest_number() == 0.0f);
}

TEST_CASE("strains: all lane widths compute what one float does, bit for bit, and float moves as double within 1e-4 of a length") {
	for (unsigned seed = 1; seed <= 3; seed++) {
		Blown one(step_scalar_float, seed);
		Blown exact(step_scalar_double, seed);
		std::vector<std::unique_ptr<Blown>> wide;
		for (const TileStep step : get_lane_steps()) {
			wide.push_back(std::make_unique<Blown>(step, seed));
		}
		float apart = 0.0f;
		for (int i = 0; i < 300; i++) {
			one.step();
			exact.step();
			for (const auto &lanes : wide) {
				lanes->step();
				REQUIRE(has_same_blades(*lanes->scene.blades.tile, *one.scene.blades.tile));
				REQUIRE(lanes->scene.blades.energy == one.scene.blades.energy);
			}
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				apart = std::max(apart, (one.scene.knot(b, TIP) - exact.scene.knot(b, TIP)).norm() / 0.5f);
			}
		}
		CHECK(one.scene.largest_number() > 0.5f);
		CHECK(apart < 1e-4f);
	}
}

TEST_CASE("strains: segments keep their length to 1e-5, and each blade moves as its own species alone does, to the bit") {
	Blown mixed(step_lanes, 7);
	Blown alone(step_lanes, 7);
	std::memset(alone.scene.blades.tile->species, 1, sizeof(alone.scene.blades.tile->species));
	for (int i = 0; i < 100; i++) {
		mixed.step();
		alone.step();
	}
	int others = 0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const bool is_same = mixed.scene.knot(b, TIP) == alone.scene.knot(b, TIP);
		CHECK(is_same == (mixed.scene.blades.tile->species[b] == 1));
		others += is_same ? 0 : 1;
		for (int s = 0; s < GRASS_SEGMENTS; s++) {
			const float wanted = (mixed.scene.blades.rest(b, s + 1) - mixed.scene.blades.rest(b, s)).norm();
			CHECK((mixed.scene.knot(b, s + 1) - mixed.scene.knot(b, s)).norm() == doctest::Approx(double(wanted)).epsilon(1e-5));
		}
	}
	CHECK(others > 10);
}

TEST_CASE("strains: a blade with a number that is not finite is put to rest, and its neighbours move on") {
	for (const TileStep step : get_lane_steps()) {
		Blown broken(step, 5);
		Blown whole(step, 5);
		for (int i = 0; i < 10; i++) {
			broken.step();
			whole.step();
		}
		broken.scene.blades.tile->strains[1][9] = NOT_A_NUMBER;
		broken.scene.blades.tile->before[0][GRASS_STRAIN_FIRST_MASS + 4 - GRASS_CLAMPED_KNOTS][20] = NOT_A_NUMBER;
		broken.step();
		whole.step();
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const Eigen::Vector3f wanted = b == 9 || b == 20 ? broken.scene.blades.rest(b, TIP) : whole.scene.knot(b, TIP);
			CHECK(broken.scene.knot(b, TIP) == wanted);
		}
	}
}
