// SPDX-License-Identifier: MIT
#include "core/lod.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

// shaders/shared/lod.inc as C++, so that the twins can be compared here: just the GLSL that it uses.
namespace twin {

struct vec3 {
	float x, y, z;
};
struct vec4 {
	vec3 xyz;
	float w;
};
float dot(vec3 p_a, vec3 p_b) {
	return p_a.x * p_b.x + p_a.y * p_b.y + p_a.z * p_b.z;
}
vec3 abs(vec3 p_a) {
	return { std::abs(p_a.x), std::abs(p_a.y), std::abs(p_a.z) };
}
float clamp(double p_value, double p_min, double p_max) {
	return float(std::clamp(p_value, p_min, p_max));
}

#include "../../shaders/shared/lod.inc"

} // namespace twin

using namespace grass;

namespace {

// A camera at p_eye that looks along -z, 90 degrees high and wide.
Frustum make_frustum(const Eigen::Vector3f &p_eye, float p_near, float p_far) {
	const float s = std::sqrt(0.5f);
	const Eigen::Vector3f normals[] = { { 0, 0, 1 }, { 0, 0, -1 }, { s, 0, s }, { -s, 0, s }, { 0, s, s }, { 0, -s, s } };
	const float distances[] = { -p_near, p_far, 0, 0, 0, 0 };
	Frustum frustum;
	for (int i = 0; i < 6; i++) {
		frustum[size_t(i)] << normals[i], normals[i].dot(p_eye) + distances[i];
	}
	return frustum;
}

const Eigen::Vector3f TILE(0.25f, 0.5f, 0.25f);

} // namespace

TEST_CASE("lod: L(z) is the paper's line, full at the near plane, never below an eighth") {
	CHECK(grass_lod_blades(0.1f, 0.1f, 100.0f) == 64.0f);
	CHECK(grass_lod_blades(0.0f, 0.1f, 100.0f) == 64.0f);
	CHECK(grass_lod_blades(40.1f, 0.1f, 100.0f) == doctest::Approx((1.0 - 7.0 * 40.0 / 800.0) * 64.0));
	CHECK(grass_lod_blades(100.1f, 0.1f, 100.0f) == doctest::Approx(8.0));
	CHECK(grass_lod_blades(1e9f, 0.1f, 100.0f) == 8.0f);
	float before = 64.0f;
	for (int i = 0; i < 1000; i++) {
		const float blades = grass_lod_blades(0.15f * float(i), 0.1f, 100.0f);
		CHECK(blades <= before);
		before = blades;
	}
}

TEST_CASE("lod: the level's mesh always holds the blades, and is the smallest that does") {
	const LodParams params;
	int level_before = 0;
	for (int i = 0; i < 4000; i++) {
		const float distance = 0.05f * float(i);
		const float blades = grass_lod_blades(distance, params.near, params.far);
		const int level = grass_lod_level(blades, distance, params.fine, params.medium);
		REQUIRE(level >= level_before);
		REQUIRE(level < GRASS_LOD_LEVELS);
		const LodLevel mesh = get_lod_level(level);
		REQUIRE(float(mesh.blades) >= blades);
		REQUIRE((mesh.blades == 16 || 0.5f * float(mesh.blades) < blades));
		level_before = level;
	}
	CHECK(level_before == 4);
}

TEST_CASE("lod: segments fall with the distance") {
	CHECK(get_lod_level(grass_lod_level(64.0f, 7.9f, 8.0f, 20.0f)).segments == 15);
	CHECK(get_lod_level(grass_lod_level(64.0f, 8.0f, 8.0f, 20.0f)).segments == 7);
	CHECK(get_lod_level(grass_lod_level(64.0f, 20.0f, 8.0f, 20.0f)).segments == 3);
	CHECK(grass_lod_level(32.0f, 1.0f, 8.0f, 20.0f) == 3);
	CHECK(grass_lod_level(32.1f, 1.0f, 8.0f, 20.0f) == 0);
	CHECK(grass_lod_level(16.0f, 1.0f, 8.0f, 20.0f) == 4);
}

TEST_CASE("lod: a very far far plane and segment distances switch it off") {
	CHECK(grass_lod_level(grass_lod_blades(5000.0f, 0.1f, 1e30f), 5000.0f, 1e30f, 1e30f) == 0);
}

TEST_CASE("lod: parameters are mended") {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	const LodParams params = LodParams{ nan, -1.0f, nan, -5.0f }.sanitised();
	CHECK(params.near == 0.0f);
	CHECK(params.far == 0.001f);
	CHECK(params.fine == 0.0f);
	CHECK(params.medium == 0.0f);
	CHECK(LodParams{ 0.0f, 1.0f, 9.0f, 3.0f }.sanitised().medium == 9.0f);
}

TEST_CASE("lod: a tile is seen in front of the camera, not behind, beside, beyond it") {
	const Frustum frustum = make_frustum({ 0.0f, 1.0f, 10.0f }, 0.1f, 100.0f);
	CHECK(grass_tile_visible(frustum, { 0.0f, 0.5f, 0.0f }, TILE, 0.0f));
	CHECK_FALSE(grass_tile_visible(frustum, { 0.0f, 0.5f, 11.0f }, TILE, 0.0f));
	CHECK_FALSE(grass_tile_visible(frustum, { 0.0f, 0.5f, -91.0f }, TILE, 0.0f));
	CHECK_FALSE(grass_tile_visible(frustum, { 11.0f, 0.5f, 0.0f }, TILE, 0.0f));
	CHECK_FALSE(grass_tile_visible(frustum, { -11.0f, 0.5f, 0.0f }, TILE, 0.0f));
	CHECK_FALSE(grass_tile_visible(frustum, { 0.0f, 30.0f, 0.0f }, TILE, 0.0f));
}

TEST_CASE("lod: the box's size and the margin count") {
	const Frustum frustum = make_frustum({ 0.0f, 1.0f, 10.0f }, 0.1f, 100.0f);
	const Eigen::Vector3f beside(10.4f, 0.5f, 0.0f); // its inner edge at x = 10.15, the view's at 10.25
	CHECK(grass_tile_visible(frustum, beside, TILE, 0.0f));
	CHECK_FALSE(grass_tile_visible(frustum, beside, Eigen::Vector3f::Zero(), 0.0f));
	const Eigen::Vector3f behind(0.0f, 0.5f, 12.0f);
	CHECK_FALSE(grass_tile_visible(frustum, behind, TILE, 1.5f));
	CHECK(grass_tile_visible(frustum, behind, TILE, 2.0f));
}

TEST_CASE("lod: no box with a corner in the view is ever left out") {
	const Frustum frustum = make_frustum({ 3.0f, 1.7f, 4.0f }, 0.05f, 60.0f);
	std::mt19937 random(3);
	std::uniform_real_distribution<float> place(-50.0f, 50.0f);
	int seen = 0, missed = 0, left_out = 0;
	for (int i = 0; i < 20000; i++) {
		const Eigen::Vector3f centre(place(random), 0.5f, place(random));
		bool has_corner = false;
		for (int corner = 0; corner < 8; corner++) {
			const Eigen::Vector3f sign(corner & 1 ? 1.0f : -1.0f, corner & 2 ? 1.0f : -1.0f, corner & 4 ? 1.0f : -1.0f);
			const Eigen::Vector3f point = centre + sign.cwiseProduct(TILE);
			has_corner = has_corner || std::all_of(frustum.begin(), frustum.end(), [&](const Eigen::Vector4f &p_plane) {
				return p_plane.head<3>().dot(point) <= p_plane.w();
			});
		}
		const bool visible = grass_tile_visible(frustum, centre, TILE, 0.0f);
		seen += has_corner ? 1 : 0;
		missed += has_corner && !visible ? 1 : 0;
		left_out += visible ? 0 : 1;
	}
	CHECK(missed == 0);
	CHECK(seen > 1000);
	CHECK(left_out > 10000);
}

TEST_CASE("lod: the shaders' twin gives the same") {
	std::mt19937 random(4);
	std::uniform_real_distribution<float> place(-60.0f, 60.0f), distance_of(0.0f, 150.0f);
	const Frustum frustum = make_frustum({ 3.0f, 1.7f, 4.0f }, 0.05f, 60.0f);
	twin::vec4 planes[6];
	for (size_t i = 0; i < 6; i++) {
		planes[i] = { { frustum[i].x(), frustum[i].y(), frustum[i].z() }, frustum[i].w() };
	}
	int differing = 0;
	for (int i = 0; i < 20000; i++) {
		const Eigen::Vector3f centre(place(random), 0.5f, place(random));
		const float distance = distance_of(random), margin = distance * 0.02f;
		const float blades = grass_lod_blades(distance, 0.05f, 100.0f);
		differing += std::abs(blades - twin::grass_lod_blades(distance, 0.05f, 100.0f)) < 1e-4f ? 0 : 1;
		differing += grass_lod_level(blades, distance, 8.0f, 20.0f) == twin::grass_lod_level(blades, distance, 8.0f, 20.0f) ? 0 : 1;
		const twin::vec3 twin_centre = { centre.x(), centre.y(), centre.z() }, twin_half = { TILE.x(), TILE.y(), TILE.z() };
		const bool twin_visible = twin::grass_tile_visible(planes, twin_centre, twin_half, margin);
		differing += grass_tile_visible(frustum, centre, TILE, margin) == twin_visible ? 0 : 1;
	}
	CHECK(differing == 0);
}
