// SPDX-License-Identifier: MIT
// The levels of an options menu: what they scale, in which order, and within which limits.
#include "core/field/field_setup.h"
#include "core/field/quality.h"
#include "core/tiles/tile_params.h"
#include "field/field_params.h"
#include "grown_tile.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace grass;

namespace {

Quality level(QualityLevel p_level) {
	return { Quality::of_level(p_level) };
}

// What is drawn of a default field of 128 m from its middle: 1.7 m above the ground, 75 degrees high, 1920 x 1080, in the light of a sun.
struct Drawn {
	double blades, shadow_blades, triangles; // the last in the picture and in shadows

	explicit Drawn(const Quality &p_quality) {
		FieldSetup setup;
		setup.grid = TileGrid::make(128.0, 128.0, DENSITY.initial);
		setup.patch = test::shared_patch();
		const auto scaled = [&](QualityFactorId p_id, const Tunable &p_tunable) {
			return float(p_quality.scale(p_id, p_tunable, p_tunable.initial));
		};
		FieldView view;
		view.lod.far = scaled(QUALITY_LOD_FAR, LOD_FAR);
		view.lod.error = scaled(QUALITY_LOD_ERROR, LOD_ERROR);
		view.lod.pixels_min = scaled(QUALITY_PIXELS_MIN, PIXELS_MIN);
		view.lod.shadow_coarseness = scaled(QUALITY_SHADOW_COARSENESS, SHADOW_COARSENESS);
		view.lod.is_carried = true;
		view.shadow_distance = scaled(QUALITY_SHADOW_DISTANCE, SHADOW_DISTANCE);
		view.shadow_margin = float(SHADOW_MARGIN.initial);
		view.falls = { setup.blade_height() * Eigen::Vector3f(1.0f, -1.0f, 0.5f) };
		const double half = std::tan(0.5 * 75.0 * 3.14159265358979 / 180.0), near = 0.05, far = 4000.0;
		Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
		projection.diagonal() << 9.0 / 16.0 / half, 1.0 / half, -(far + near) / (far - near), 0.0;
		projection(2, 3) = -2.0 * far * near / (far - near);
		projection(3, 2) = -1.0;
		view.cameras = { view_of_eye(projection, Eigen::Affine3d(Eigen::Translation3d(0.0, 1.7, 0.0)), near, 1080.0) };
		TileCull cull;
		cull.choose(setup.cull_field(), view, nullptr, [](int) { return GRASS_NO_SLOT; });
		blades = double(cull.get_blades()[0]);
		shadow_blades = double(cull.get_blades()[1]);
		triangles = 0.0;
		for (int i = 0; i < GRASS_ALL_LEVELS; i++) {
			triangles += double(cull.get_count(i)) * get_lod_level(i).blades * (2 * get_lod_level(i).segments - 1);
		}
	}
};

} // namespace

TEST_CASE("quality: high is as designed, to the bit, and is what a field begins with") {
	CHECK(Quality() == level(QualityLevel::HIGH));
	CHECK(level(QualityLevel::CUSTOM) == level(QualityLevel::HIGH));
	for (const FieldParam &param : FIELD_PARAMS) {
		if (param.factor == QUALITY_FACTORS) {
			continue;
		}
		for (const double share : { 0.0, 0.1, 1.0 / 3.0, 0.77, 1.0 }) {
			const double value = param.tunable.minimum + share * (param.tunable.maximum - param.tunable.minimum);
			CHECK(Quality().scale(param.factor, param.tunable, value) == value);
		}
	}
	for (const int64_t tiles : { 0, 1, 33, 4096, TileParams::MAX_POOL_SIZE }) {
		CHECK(Quality().scale_pool(tiles) == tiles);
	}
}

TEST_CASE("quality: each factor has the name of what it multiplies") {
	for (const FieldParam &param : FIELD_PARAMS) {
		if (param.factor != QUALITY_FACTORS) {
			CHECK(std::string(param.tunable.name) == QUALITY_TABLE[param.factor].tunable.name);
		}
	}
}

TEST_CASE("quality: each level draws and simulates at least as much as the one below") {
	for (const QualityFactor &factor : QUALITY_TABLE) {
		INFO("factor ", factor.tunable.name);
		const bool is_cost = factor.id != QUALITY_PIXELS_MIN && factor.id != QUALITY_LOD_ERROR && factor.id != QUALITY_SHADOW_COARSENESS;
		for (size_t i = 0; i < factor.of_levels.size(); i++) {
			CHECK(factor.tunable.allows(factor.of_levels[i]));
			if (i > 0) {
				CHECK((is_cost ? factor.of_levels[i] >= factor.of_levels[i - 1] : factor.of_levels[i] <= factor.of_levels[i - 1]));
			}
		}
		CHECK(factor.of_levels.front() != factor.of_levels.back());
		CHECK(factor.tunable.initial == factor.of_levels[size_t(QualityLevel::HIGH)]);
	}
}

TEST_CASE("quality: what is scaled stays within its own limits") {
	Quality most, least;
	for (const QualityFactor &factor : QUALITY_TABLE) {
		most.factors[factor.id] = factor.tunable.maximum;
		least.factors[factor.id] = factor.tunable.minimum;
	}
	CHECK(most.scale(QUALITY_PIXELS_MIN, PIXELS_MIN, 3.0) == PIXELS_MIN.maximum);
	CHECK(least.scale(QUALITY_SHADOW_COARSENESS, SHADOW_COARSENESS, 2.0) == SHADOW_COARSENESS.minimum);
	CHECK(least.scale(QUALITY_SHADOW_DISTANCE, SHADOW_DISTANCE, 60.0) == 0.0);
	CHECK(most.scale(QUALITY_PIXELS_MIN, PIXELS_MIN, 0.0) == 0.0); // "all blades" stays all blades
	CHECK(most.scale_pool(TileParams::MAX_POOL_SIZE) == TileParams::MAX_POOL_SIZE);
	CHECK(most.scale_pool(0) == 0);
	CHECK(level(QualityLevel::LOW).scale_pool(1) == 1); // a pool does not vanish by rounding
	CHECK(level(QualityLevel::LOW).scale_pool(4096) == 1024);
	CHECK(level(QualityLevel::ULTRA).scale_pool(4096) == 8192);
	CHECK(least.scale_pool(4096) == 0);
}

// The shares stand in docs/guide/performance.md.
TEST_CASE("quality: what each level draws, as shares of what was designed") {
	const Drawn high(level(QualityLevel::HIGH));
	REQUIRE(high.shadow_blades > 0.0);
	struct Shares {
		QualityLevel level;
		double blades, shadow_blades, triangles;
	};
	for (const Shares &shares : { Shares{ QualityLevel::LOW, 0.67, 0.1, 0.3 }, Shares{ QualityLevel::MEDIUM, 0.81, 0.34, 0.5 },
				 Shares{ QualityLevel::ULTRA, 1.25, 2.06, 1.61 } }) {
		INFO("level ", int(shares.level));
		const Drawn drawn(level(shares.level));
		CHECK(drawn.blades / high.blades == doctest::Approx(shares.blades).epsilon(0.01));
		CHECK(drawn.shadow_blades / high.shadow_blades == doctest::Approx(shares.shadow_blades).epsilon(0.01));
		CHECK(drawn.triangles / high.triangles == doctest::Approx(shares.triangles).epsilon(0.01));
	}
}
