// SPDX-License-Identifier: MIT
#include "core/blades/blade.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "core/base/half.h"
#include "core/blades/patch.h"

using namespace grass;

TEST_CASE("clump: stays within its range, fills it, and reaches both sides of every effect") {
	Clump least = clump_at(Eigen::Vector2f(0.0f, 0.0f), {});
	Clump most = least;
	Eigen::Vector2f least_lean = from_glsl(least.lean), most_lean = least_lean;
	for (float x = -60.0f; x < 60.0f; x += 0.37f) {
		for (float z = -60.0f; z < 60.0f; z += 0.41f) {
			const Clump here = clump_at(Eigen::Vector2f(x, z), {});
			least.height = std::min(least.height, here.height);
			most.height = std::max(most.height, here.height);
			least_lean = least_lean.cwiseMin(from_glsl(here.lean));
			most_lean = most_lean.cwiseMax(from_glsl(here.lean));
			least.tint = std::min(least.tint, here.tint);
			most.tint = std::max(most.tint, here.tint);
		}
	}
	const float lean = float(GRASS_CLUMP_LEAN);
	CHECK(least.height >= doctest::Approx(1.0 - GRASS_CLUMP_SHORTER));
	CHECK(least.height < 0.65f);
	CHECK(most.height <= doctest::Approx(CLUMP_TALLEST));
	CHECK(most.height > 1.25f);
	CHECK(most_lean.maxCoeff() <= doctest::Approx(lean));
	CHECK(most_lean.minCoeff() > 0.9f * lean);
	CHECK(least_lean.minCoeff() >= doctest::Approx(-lean));
	CHECK(least_lean.maxCoeff() < -0.9f * lean);
	CHECK(least.tint < -0.9f);
	CHECK(most.tint > 0.9f);
}

TEST_CASE("clump: a strength of zero is no effect, bit for bit") {
	for (float x = -5.0f; x < 5.0f; x += 0.3f) {
		const Clump here = clump_at(Eigen::Vector2f(x, 2.0f * x), ClumpParams{ 1.6f, 0.0f, 0.0f, 0.0f });
		CHECK(here.height == 1.0f);
		CHECK(here.lean == glsl::vec2(0.0f));
		CHECK(here.tint == 0.0f);
		const Eigen::Vector3f texel(0.1f, 0.2f, x);
		CHECK(rest_knot(texel, 3, here) == texel);
	}
}

TEST_CASE("clump: is a smooth function of the place, also across its lattice and the origin") {
	const float step = 0.001f;
	double steepest = 0.0, sharpest = 0.0;
	for (float x = -8.0f; x < 8.0f; x += step) {
		const auto height = [](float p_x) { return double(clump_at(Eigen::Vector2f(p_x, 0.7f * p_x + 0.3f), {}).height); };
		const double slope = (height(x + step) - height(x)) / step;
		const double slope_before = (height(x) - height(x - step)) / step;
		steepest = std::max(steepest, std::abs(slope));
		sharpest = std::max(sharpest, std::abs(slope - slope_before));
	}
	CHECK(steepest < 2.5); // per metre
	CHECK(sharpest < 0.05); // per metre: no kink
	CHECK(steepest > 0.2);
}

TEST_CASE("clump: its size scales it") {
	const Clump small = clump_at(Eigen::Vector2f(0.8f, -1.1f), ClumpParams{ 1.0f, 1.0f, 1.0f, 1.0f });
	const Clump large = clump_at(Eigen::Vector2f(3.2f, -4.4f), ClumpParams{ 4.0f, 1.0f, 1.0f, 1.0f });
	CHECK(small.height == doctest::Approx(large.height));
	CHECK(small.tint == doctest::Approx(large.tint));
}

TEST_CASE("blade: a root's place counts from the field's centre") {
	const Eigen::Vector2f tiles(4.0f, 6.0f);
	CHECK(root_place({ 0, 0 }, { 0, 0 }, tiles, 0.5f) == Eigen::Vector2f(-1.0f, -1.5f));
	CHECK(root_place({ 2, 3 }, { 0, 0 }, tiles, 0.5f) == Eigen::Vector2f(0.0f, 0.0f));
	CHECK(root_place({ 3, 5 }, { 1, 1 }, tiles, 0.5f) == Eigen::Vector2f(1.0f, 1.5f));
}

TEST_CASE("blade: a tilt turns the vertical by twice the angle whose tangent it is, and keeps lengths") {
	const glsl::vec3 up(0.0f, 1.0f, 0.0f);
	const Eigen::Vector2f lean(0.3f, -0.1f);
	const Eigen::Vector3f turned = from_glsl(up + glsl::grass_tilt_change(up, to_glsl(lean)));
	CHECK(turned.norm() == doctest::Approx(1.0).epsilon(1e-6));
	CHECK(std::acos(turned.y()) == doctest::Approx(2.0 * std::atan(lean.norm())).epsilon(1e-5));
	CHECK(turned.x() / turned.z() == doctest::Approx(-3.0).epsilon(1e-5));
}

TEST_CASE("blade: rest knots keep the root at the origin, segments in proportion and every knot above the ground") {
	const Patch patch = generate_patch({});
	float lowest = 1.0f;
	for (int blade = 0; blade < GRASS_PATCH_BLADES; blade += 3) {
		const Clump here = clump_at(Eigen::Vector2f(0.11f * float(blade), -0.07f * float(blade)), {});
		Eigen::Vector3f before = Eigen::Vector3f::Zero();
		float shortest = 1.0f, longest = 0.0f;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			const uint16_t *halves = &patch.texels[Patch::texel_index(blade, k)];
			const Eigen::Vector3f texel(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
			const Eigen::Vector3f knot = rest_knot(texel, k, here);
			if (k == 0) {
				REQUIRE(knot.norm() == 0.0f);
				continue;
			}
			const float segment = (knot - before).norm() * (k == 1 ? 1.0f / float(GRASS_CLAMP_SEGMENTS) : 1.0f);
			shortest = std::min(shortest, segment);
			longest = std::max(longest, segment);
			lowest = std::min(lowest, knot.y() / knot.norm());
			before = knot;
		}
		REQUIRE(longest - shortest < 1.2e-3f);
	}
	CHECK(lowest > 0.03f); // sine of the elevation
}

// [Eq B1] [Eq B2] Of fields side by side, 16 km from the noise's origin.
TEST_CASE("clump: the noise continues from one field to the next, wherever they are") {
	constexpr float SIDE = 256.0f;
	for (const double metres : { 0.0, 128.0, -4224.0, 8064.0 }) {
		ClumpParams left, right;
		left.set_origin({ metres, -metres });
		right.set_origin({ metres + double(SIDE), -metres });
		double most = 0.0, least = 2.0, tallest = 0.0;
		for (float z = -100.0f; z < 100.0f; z += 1.7f) {
			const Clump here = clump_at(Eigen::Vector2f(0.5f * SIDE, z), left), there = clump_at(Eigen::Vector2f(-0.5f * SIDE, z), right);
			most = std::max({ most, std::abs(double(here.height) - double(there.height)), std::abs(double(here.tint) - double(there.tint)),
					double((from_glsl(here.lean) - from_glsl(there.lean)).cwiseAbs().maxCoeff()) });
			least = std::min(least, double(here.height));
			tallest = std::max(tallest, double(here.height));
		}
		CHECK(most < 1e-3);
		CHECK(tallest - least > 0.4); // there are clumps
	}
	ClumpParams plain;
	plain.set_origin({ 0.0, 0.0 });
	CHECK_FALSE(plain.is_elsewhere());
	CHECK(plain == ClumpParams());
}
