// SPDX-License-Identifier: MIT
// What the ground shows of grass that is not drawn blade by blade.
#include "core/blades/clump.h"
#include "core/lod/lod.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace grass;

namespace {
const glsl::vec3 GREEN(0.1f, 0.2f, 0.03f), DRY_STRAW(0.4f, 0.3f, 0.1f);

double distance(const glsl::vec3 &p_a, const glsl::vec3 &p_b) {
	return double(glsl::length(p_a - p_b));
}
} // namespace

TEST_CASE("far: the mean colour is that of many blades [Eq C1] [Eq C2]") {
	std::mt19937 random(5);
	std::uniform_real_distribution<float> share(0.0f, 1.0f);
	for (const float dry : { 0.0f, 0.25f, 1.0f }) {
		for (const float along : { 0.1f, 0.6f, 0.95f }) {
			for (const float tint : { -0.8f, 0.0f, 0.9f }) {
				const float gust = share(random) - 0.25f;
				glsl::vec3 sum;
				constexpr int BLADES = 20000;
				for (int i = 0; i < BLADES; i++) {
					const glsl::vec4 own(share(random), share(random), share(random), share(random));
					sum += glsl::grass_blade_color(GREEN, DRY_STRAW, dry, along, tint, gust, own);
				}
				const glsl::vec3 mean = glsl::grass_mean_color(GREEN, DRY_STRAW, dry, along, tint, gust);
				CHECK(distance(sum / float(BLADES), mean) < 0.01 * double(glsl::length(mean)));
			}
		}
	}
}

TEST_CASE("far: gusts are strong as often as their mean says") {
	double sum = 0.0;
	constexpr int SIDE = 300;
	for (int x = 0; x < SIDE; x++) {
		for (int z = 0; z < SIDE; z++) {
			sum += double(glsl::grass_gust_at({ 2.3f * float(x), 3.1f * float(z) }, glsl::vec2(0.0f), { 4.0f, 1.0f }, 7.0f));
		}
	}
	CHECK(sum / (SIDE * SIDE) == doctest::Approx(GRASS_GUST_MEAN).epsilon(0.03));
}

TEST_CASE("far: what a line of sight sees lies as deep as blades that narrow evenly let it [Eq L12]") {
	for (const double meets : { 0.05, 0.5, 1.0, 2.0, 4.0, 16.0, 100.0 }) {
		double seen = 0.0, depth = 0.0;
		constexpr int STEPS = 20000;
		for (int i = 0; i < STEPS; i++) {
			const double u = (i + 0.5) / STEPS, chance = 2.0 * meets * u * std::exp(-meets * u * u) / STEPS;
			seen += chance;
			depth += chance * u;
		}
		CHECK(double(grass_far_depth(float(meets))) == doctest::Approx(depth / seen).epsilon(0.03));
	}
}

TEST_CASE("far: [Eq L8] and [Eq L12] agree on what thinned grass shows") {
	for (const float meets : { 8.0f, 40.0f }) {
		const float share = float(GRASS_LOD_DEPTH) / meets;
		CHECK(double(grass_far_depth(float(GRASS_LOD_DEPTH)) * std::sqrt(share)) ==
				doctest::Approx(double(grass_far_depth(meets))).epsilon(0.03));
	}
}

TEST_CASE("far: blades end where they are low in the picture, but not where nothing carries their colour [Eq L9]") {
	CHECK(grass_lod_ends(100.0f, 1.0f, 1.0f) == 1.0f);
	CHECK(grass_lod_ends(float(GRASS_FAR_WHOLE), 1.0f, 1.0f) == 1.0f);
	CHECK(grass_lod_ends(0.5f * float(GRASS_FAR_WHOLE + GRASS_FAR_GONE), 1.0f, 1.0f) == doctest::Approx(0.5));
	CHECK(grass_lod_ends(float(GRASS_FAR_GONE), 1.0f, 1.0f) == 0.0f);
	CHECK(grass_lod_ends(0.0f, 1.0f, 0.0f) == 1.0f);
	CHECK(grass_lod_ends(float(GRASS_FAR_GONE), 0.0f, 1.0f) == 1.0f); // before a low eye
}

TEST_CASE("far: the ground carries what is not drawn, and nothing near the eye [Eq L10] [Eq L11]") {
	CHECK(grass_far_hidden(grass_far_meets(1.0f, 0.7f), 20.0f) == 0.0f); // all blades are drawn
	CHECK(grass_far_meets(1.0f, 1.0f) == doctest::Approx(GRASS_FAR_BESIDE * GRASS_FAR_ABOVE));
	const float steep = grass_far_meets(1.0f, 0.7f), low = grass_far_meets(1.0f, 0.02f);
	CHECK(low > 30.0f);
	CHECK(grass_far_hidden(low, 20.0f) > 0.99f); // most blades hide others [Eq L7]
	CHECK(grass_far_hidden(steep, 1.0f) == doctest::Approx(1.0 - std::exp(-double(steep)))); // none is drawn: soil shows between
	float before = 0.0f;
	for (float heights = 6.0f; heights > 1.0f; heights -= 0.1f) {
		const float hidden = grass_far_hidden(steep, heights);
		CHECK(hidden >= before);
		CHECK(hidden - before < 0.1f);
		before = hidden;
	}
	CHECK(grass_far_hidden(0.0f, 1.0f) == 0.0f); // bare ground
}
