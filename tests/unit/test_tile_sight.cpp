// SPDX-License-Identifier: MIT
// Which tiles a camera sees, and whose shadows.
#include "core/lod/lod.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace grass;

namespace {

// Returns a camera at p_eye that looks along -z, 90 degrees high and wide.
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
const Eigen::Vector3f NO_FALL = Eigen::Vector3f::Zero();

} // namespace

TEST_CASE("lod: a tile is seen in front of the camera, not behind, beside, beyond it") {
	const Frustum frustum = make_frustum({ 0.0f, 1.0f, 10.0f }, 0.1f, 100.0f);
	CHECK(grass_tile_visible(frustum, { 0.0f, 0.5f, 0.0f }, TILE, 0.0f, NO_FALL));
	CHECK_FALSE(grass_tile_visible(frustum, { 0.0f, 0.5f, 11.0f }, TILE, 0.0f, NO_FALL));
	CHECK_FALSE(grass_tile_visible(frustum, { 0.0f, 0.5f, -91.0f }, TILE, 0.0f, NO_FALL));
	CHECK_FALSE(grass_tile_visible(frustum, { 11.0f, 0.5f, 0.0f }, TILE, 0.0f, NO_FALL));
	CHECK_FALSE(grass_tile_visible(frustum, { -11.0f, 0.5f, 0.0f }, TILE, 0.0f, NO_FALL));
	CHECK_FALSE(grass_tile_visible(frustum, { 0.0f, 30.0f, 0.0f }, TILE, 0.0f, NO_FALL));
}

TEST_CASE("lod: the box's size and the margin count") {
	const Frustum frustum = make_frustum({ 0.0f, 1.0f, 10.0f }, 0.1f, 100.0f);
	const Eigen::Vector3f beside(10.4f, 0.5f, 0.0f); // its inner edge at x = 10.15, the view's at 10.25
	CHECK(grass_tile_visible(frustum, beside, TILE, 0.0f, NO_FALL));
	CHECK_FALSE(grass_tile_visible(frustum, beside, Eigen::Vector3f::Zero(), 0.0f, NO_FALL));
	const Eigen::Vector3f behind(0.0f, 0.5f, 12.0f);
	CHECK_FALSE(grass_tile_visible(frustum, behind, TILE, 1.5f, NO_FALL));
	CHECK(grass_tile_visible(frustum, behind, TILE, 2.0f, NO_FALL));
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
		const bool visible = grass_tile_visible(frustum, centre, TILE, 0.0f, NO_FALL);
		seen += has_corner ? 1 : 0;
		missed += has_corner && !visible ? 1 : 0;
		left_out += visible ? 0 : 1;
	}
	CHECK(missed == 0);
	CHECK(seen > 1000);
	CHECK(left_out > 10000);
}

TEST_CASE("lod: no tile whose shadow falls into the view is left out") {
	const Frustum frustum = make_frustum({ 3.0f, 1.7f, 4.0f }, 0.05f, 60.0f);
	const Eigen::Vector3f fall(4.0f, -1.0f, -6.0f);
	std::mt19937 random(5);
	std::uniform_real_distribution<float> place(-30.0f, 30.0f), share(0.0f, 1.0f), across(-1.0f, 1.0f);
	int falls_in = 0, missed = 0, left_out = 0;
	for (int i = 0; i < 20000; i++) {
		const Eigen::Vector3f centre(place(random), 0.5f, place(random));
		const bool visible = grass_tile_visible(frustum, centre, TILE, 0.0f, fall);
		bool shades = false;
		for (int ray = 0; ray < 20; ray++) {
			const Eigen::Vector3f offset(across(random), across(random), across(random));
			const Eigen::Vector3f point = centre + offset.cwiseProduct(TILE) + share(random) * fall;
			shades = shades || std::all_of(frustum.begin(), frustum.end(), [&](const Eigen::Vector4f &p_plane) {
				return p_plane.head<3>().dot(point) <= p_plane.w();
			});
		}
		falls_in += shades ? 1 : 0;
		missed += shades && !visible ? 1 : 0;
		left_out += visible ? 0 : 1;
	}
	CHECK(missed == 0);
	CHECK(falls_in > 1000);
	CHECK(left_out > 5000);
}
