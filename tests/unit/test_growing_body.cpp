// SPDX-License-Identifier: MIT
// A body that grows pushes blades as one that moves: finer contact is nearer to where contact converges to, not farther.
#include "rolled_blades.h"
#include "tile_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace grass;
using namespace grass::test;

namespace {

constexpr double SECONDS = 0.4; // in which it grows
constexpr float FIRST = 0.125f; // share of its size

float size_at(double p_time) {
	return FIRST + (1.0f - FIRST) * float(std::min(p_time / SECONDS, 1.0));
}

// Returns the blades 60 times a second while a body beside them grows, and for a while after that.
std::vector<Look> grow_among(int p_shape, float p_friction, const Stepping &p_stepping) {
	BladeScene scene = make_rolled({ 1.0f, true, p_friction });
	scene.params.iterations = p_stepping.iterations;
	scene.params.contact_rate = p_stepping.contact_rate;
	scene.add(p_shape, { 0.05f, 0.16f, 0.01f }, Eigen::Vector3f::Zero()).position.w = p_friction;
	const int per_look = int(p_stepping.rate / 60.0);
	std::vector<Look> looks;
	for (int i = 0; i < int(std::lround(0.7 * p_stepping.rate)); i++) {
		const float before = size_at(i / p_stepping.rate), now = size_at((i + 1) / p_stepping.rate), size = 0.15f * now;
		scene.colliders[0].size = { size, size, size, 1.0f - before / now };
		scene.step(1.0 / p_stepping.rate);
		if ((i + 1) % per_look == 0) {
			looks.push_back(look_at_places(scene));
		}
	}
	return looks;
}

ColliderShape make_box(const TileManager &p_manager, double p_size) {
	ColliderShape box = make_ball(p_manager, 3, 5);
	box.type = GRASS_BOX;
	box.size = Eigen::Vector3d(1.0, 2.0, 0.5) * p_size;
	return box;
}

} // namespace

TEST_CASE("METHOD_DIRECT: beside a body that grows blades are the nearer to where they converge to the higher contact_rate is") {
	constexpr Stepping LIMIT{ 5760.0, 8, CONTACT_RATE.minimum };
	for (const int shape : { GRASS_SPHERE, GRASS_BOX }) {
		CAPTURE(shape);
		std::vector<double> errors[3];
		const double rates[] = { 400.0, 800.0, 3200.0 };
		for (const float friction : { 0.0f, 0.5f }) {
			const std::vector<Look> limit = grow_among(shape, friction, LIMIT);
			for (size_t i = 0; i < std::size(rates); i++) {
				add_errors(grow_among(shape, friction, { 60.0, int(ITERATIONS.initial), rates[i] }), limit, 1, errors[i]);
			}
		}
		double before = 1.0;
		for (size_t i = 0; i < std::size(rates); i++) {
			const double error = median_of(errors[i]);
			MESSAGE("shape " << shape << ", contact_rate " << rates[i] << ": " << error << " L");
			CHECK(error < before);
			before = error;
		}
		CHECK(before < 0.032);
	}
}

TEST_CASE("tiles: the record of a collider says how much smaller it was in the step before, and only if it is the same one") {
	TileManager manager = make_manager();
	const auto growth_after = [&](const ColliderShape &p_shape) {
		step(manager, { p_shape });
		REQUIRE(manager.get_colliders().size() == 1);
		return manager.get_colliders()[0].size.w;
	};
	CHECK(growth_after(make_box(manager, 0.1)) == 0.0f);
	CHECK(growth_after(make_box(manager, 0.1)) == 0.0f);
	CHECK(growth_after(make_box(manager, 0.125)) == doctest::Approx(0.2));
	CHECK(growth_after(make_box(manager, 0.1)) == doctest::Approx(-0.25));
	CHECK(growth_after(make_box(manager, 0.1)) == 0.0f);
	ColliderShape longer = make_box(manager, 0.1);
	longer.size.x() *= 1.5;
	CHECK(growth_after(longer) == 0.0f); // in one direction only
	CHECK(growth_after(make_box(manager, 0.3)) == 0.0f); // another shape
	ColliderShape elsewhere = make_box(manager, 0.25);
	elsewhere.before.position.x() = elsewhere.now.position.x() += 0.1;
	CHECK(growth_after(elsewhere) == 0.0f); // put there
	ColliderShape moves = elsewhere;
	moves.size *= 0.8;
	moves.now.position.x() += 0.01;
	CHECK(growth_after(moves) == doctest::Approx(-0.25));
	moves.before = moves.now;
	moves.owner = 7;
	moves.size *= 1.25;
	CHECK(growth_after(moves) == 0.0f);
	moves.size *= 1.25;
	CHECK(moves.has_moved() == false);
	CHECK(growth_after(moves) == doctest::Approx(0.2));
}
