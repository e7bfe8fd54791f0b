// SPDX-License-Identifier: MIT
// Pictures of a mesh from all sides: what each shows, which way it faces, and how much of it is covered.
#include "core/species/plant_views.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace grass;

namespace {

constexpr int SIDES = 8, TEXELS = 32;

// A square between p_low and p_high across p_across and up, at p_out from the axis, facing away from it.
PictureSurface wall(
		const Eigen::Vector3f &p_out, const Eigen::Vector3f &p_across, float p_low, float p_high, const Eigen::Vector3f &p_color) {
	PictureSurface surface;
	for (const float side : { -1.0f, 1.0f }) {
		for (const float y : { p_low, p_high }) {
			surface.places.push_back(0.5f * p_out + 0.25f * side * p_across + Eigen::Vector3f(0, y, 0));
			surface.normals.push_back(p_out);
			surface.colors.push_back(p_color);
			surface.uvs.push_back(Eigen::Vector2f::Zero());
		}
	}
	surface.indices = { 0, 1, 2, 1, 3, 2 };
	return surface;
}

struct Seen {
	Eigen::Vector3f color = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero();
	double share = 0.0;
	double middle = 0.0; // across, 0..1
};

Seen look_at(const PlantView &p_view) {
	Seen seen;
	for (int n = 0; n < TEXELS * TEXELS; n++) {
		const uint8_t *color = &p_view.colors[size_t(4 * n)], *normal = &p_view.normals[size_t(4 * n)];
		const float share = float(color[3]) / 255.0f;
		seen.color += share * Eigen::Vector3f(color[0], color[1], color[2]) / 255.0f;
		seen.normal += share * (Eigen::Vector3f(normal[0], normal[1], normal[2]) / 127.5f - Eigen::Vector3f::Ones());
		seen.share += double(share);
		seen.middle += double(share) * (n % TEXELS + 0.5) / TEXELS;
	}
	seen.color /= float(seen.share);
	seen.normal /= float(seen.share);
	seen.middle /= seen.share;
	seen.share /= TEXELS * TEXELS;
	return seen;
}

} // namespace

TEST_CASE("plant_views: each side shows what faces it, the nearest first, as large as it is") {
	const Eigen::Vector3f x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), red(1, 0, 0), blue(0, 0, 1);
	const std::vector<PictureSurface> surfaces = { wall(x, z, 0.5f, 1.0f, red), wall(-x, z, 0.5f, 1.0f, blue) };
	const std::vector<PlantView> views = draw_views(surfaces, 1.0f, SIDES, TEXELS).views;
	REQUIRE(views.size() == SIDES + 1);
	const auto is_colored = [&](int p_view, const Eigen::Vector3f &p_color, const Eigen::Vector3f &p_normal) {
		const size_t n = size_t(4 * (TEXELS / 4 * TEXELS + TEXELS / 2)); // where both are, one behind the other
		const std::vector<uint8_t> &color = views[size_t(p_view)].colors, &normal = views[size_t(p_view)].normals;
		CHECK((Eigen::Vector3f(color[n], color[n + 1], color[n + 2]) / 255.0f - p_color).norm() < 0.01f);
		CHECK((Eigen::Vector3f(normal[n], normal[n + 1], normal[n + 2]) / 127.5f - Eigen::Vector3f::Ones() - p_normal).norm() < 0.02f);
	};
	is_colored(0, red, x);
	is_colored(SIDES / 2, blue, -x);
	const PlantView alone = draw_views(std::span(&surfaces[0], 1), 1.0f, SIDES, TEXELS).views[0];
	CHECK(look_at(alone).share == doctest::Approx(0.25 * 0.5).epsilon(0.02)); // half a metre of two across, half of its height
	CHECK(look_at(views[SIDES / 4]).share == doctest::Approx(0.0)); // both from their edges
	for (int n = TEXELS * TEXELS * 2 / 3; n < TEXELS * TEXELS; n++) { // what is nearer looks lower, to an eye above
		CHECK(views[0].colors[size_t(4 * n + 3)] == 0);
	}
	CHECK(views[0].colors[size_t(4 * (TEXELS * TEXELS - 1))] == 255); // but with the colour of what is drawn
}

TEST_CASE("plant_views: right is right, from every side and from above") {
	const Eigen::Vector3f x(1, 0, 0), z(0, 0, 1);
	// Beside the axis, towards -z and seen from x: to the right, as z leads to the left there.
	const std::vector<PictureSurface> beside = { wall(-z, x, 0.0f, 1.0f, { 1, 1, 1 }),
		wall(-z, Eigen::Vector3f(0, 0, 1), 0.0f, 1.0f, { 1, 1, 1 }) };
	const std::vector<PlantView> views = draw_views(beside, 1.0f, SIDES, TEXELS).views;
	CHECK(look_at(views[0]).middle == doctest::Approx(0.75).epsilon(0.02));
	CHECK(look_at(views[SIDES / 2]).middle == doctest::Approx(0.25).epsilon(0.02));
	PictureSurface leaf; // lies, towards x
	leaf.places = { { 0.5f, 0.7f, -0.1f }, { 0.9f, 0.7f, -0.1f }, { 0.9f, 0.7f, 0.1f }, { 0.5f, 0.7f, 0.1f } };
	leaf.normals.assign(4, Eigen::Vector3f(0, -1, 0)); // its lower side is turned up
	leaf.colors.assign(4, Eigen::Vector3f(0, 1, 0));
	leaf.uvs.assign(4, Eigen::Vector2f::Zero());
	leaf.indices = { 0, 1, 2, 0, 2, 3 };
	const std::vector<PlantView> lying = draw_views(std::span(&leaf, 1), 1.0f, SIDES, TEXELS).views;
	const Seen above = look_at(lying[SIDES]);
	CHECK(above.middle == doctest::Approx(0.85).epsilon(0.02));
	CHECK(above.normal.y() > 0.95f); // lit from both sides
	CHECK(above.share == doctest::Approx(0.02).epsilon(0.1));
	CHECK(lying[SIDES].depth == doctest::Approx(0.7));
}

TEST_CASE("plant_views: an eye aslant sees of both pictures as much as of the plant") {
	const auto make = [](std::vector<Eigen::Vector3f> p_places, std::vector<int32_t> p_indices) {
		PictureSurface surface;
		surface.normals.assign(p_places.size(), Eigen::Vector3f(0, 1, 0));
		surface.colors.assign(p_places.size(), Eigen::Vector3f(1, 1, 1));
		surface.uvs.assign(p_places.size(), Eigen::Vector2f::Zero());
		surface.places = std::move(p_places);
		surface.indices = std::move(p_indices);
		return surface;
	};
	// No side shows a disc at the top.
	const PictureSurface disc =
			make({ { -0.5f, 1, -0.5f }, { -0.5f, 1, 0.5f }, { 0.5f, 1, 0.5f }, { 0.5f, 1, -0.5f } }, { 0, 1, 2, 0, 2, 3 });
	CHECK(draw_views(std::span(&disc, 1), 1.0f, SIDES, TEXELS).aslant > 0.95f);
	// What faces all ways shows as much to each eye.
	const PictureSurface ball =
			make({ { 0.5f, 0.5f, 0 }, { 0, 0.5f, 0.5f }, { -0.5f, 0.5f, 0 }, { 0, 0.5f, -0.5f }, { 0, 1, 0 }, { 0, 0, 0 } },
					{ 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 1, 5, 1, 2, 5, 2, 3, 5, 3, 0, 5 });
	CHECK(draw_views(std::span(&ball, 1), 1.0f, SIDES, TEXELS).aslant < 0.7f);
}

TEST_CASE("plant_views: what is transparent is not drawn, and a mesh of nothing gives empty pictures") {
	PictureSurface half = wall({ 1, 0, 0 }, { 0, 0, 1 }, 0.0f, 1.0f, { 1, 1, 1 });
	half.uvs = { { 0.1f, 0.0f }, { 0.1f, 0.0f }, { 0.9f, 0.0f }, { 0.9f, 0.0f } };
	half.texture = { 255, 255, 255, 255, 0, 0, 0, 0 };
	half.texture_width = 2;
	half.texture_height = 1;
	half.scissor = 0.5f;
	CHECK(look_at(draw_views(std::span(&half, 1), 1.0f, SIDES, TEXELS).views[0]).share == doctest::Approx(0.125).epsilon(0.03));
	half.indices = { 0, 0, 0 };
	const PlantViews empty = draw_views(std::span(&half, 1), 1.0f, SIDES, TEXELS);
	CHECK(empty.aslant == 0.0f);
	for (const PlantView &view : empty.views) {
		CHECK(view.colors.size() == size_t(4 * (4 * TEXELS * TEXELS - 1) / 3));
		CHECK(view.colors[3] == 0);
	}
}

TEST_CASE("plant_views: beside what is thin, transparent texels have its colour") {
	const std::vector<PictureSurface> surfaces = { wall({ 1, 0, 0 }, { 0, 0, 1 }, 0.0f, 0.5f, { 0, 1, 0 }),
		wall({ 1, 0, 0 }, { 0, 0, 1 }, 0.75f, 0.8125f, { 1, 1, 1 }) };
	const PlantView view = draw_views(surfaces, 1.0f, SIDES, TEXELS).views[0];
	const uint8_t *above = &view.colors[size_t(4 * (9 * TEXELS + TEXELS / 2))];
	CHECK(above[3] == 0);
	CHECK(above[0] == 255);
}

TEST_CASE("plant_views: the sides show what lies from a little above, and the top does not show what is far below it") {
	const auto lying = [](float p_height, float p_half, const Eigen::Vector3f &p_color) {
		PictureSurface leaf;
		leaf.places = { { -p_half, p_height, -p_half }, { p_half, p_height, -p_half }, { p_half, p_height, p_half },
			{ -p_half, p_height, p_half } };
		leaf.normals.assign(4, Eigen::Vector3f(0, 1, 0));
		leaf.colors.assign(4, p_color);
		leaf.uvs.assign(4, Eigen::Vector2f::Zero());
		leaf.indices = { 0, 1, 2, 0, 2, 3 };
		return leaf;
	};
	const Eigen::Vector3f white(1, 1, 1), red(1, 0, 0);
	const std::vector<PictureSurface> surfaces = { lying(0.8f, 0.4f, white), lying(0.2f, 0.5f, red) };
	const std::vector<PlantView> views = draw_views(surfaces, 1.0f, SIDES, TEXELS).views;
	CHECK(look_at(views[0]).share == doctest::Approx((0.8 * 0.8 + 1.0) / 2.0 * std::tan(0.26)).epsilon(0.1));
	CHECK((look_at(views[SIDES]).color - white).norm() < 0.01f);
	CHECK(views[SIDES].depth == doctest::Approx(0.8));
}
