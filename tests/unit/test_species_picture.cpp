// SPDX-License-Identifier: MIT
// The editor's small picture of a species shows its colours, its height and its flowers.
#include <doctest/doctest.h>

#include "core/species/plant_picture.h"
#include "core/species/species_picture.h"

#include <array>

using namespace grass;

namespace {

constexpr int SIDE = 64;

PictureLook make_look(const Eigen::Vector3f &p_color) {
	PictureLook look;
	look.colors = { p_color, p_color };
	return look;
}

// Mean of what is not clear, 0..255; w: the share that is not, 0..1.
Eigen::Vector4d mean_of(const std::vector<uint8_t> &p_picture, int p_from_row = 0, int p_to_row = SIDE) {
	Eigen::Vector4d sum = Eigen::Vector4d::Zero();
	for (int i = p_from_row * SIDE; i < p_to_row * SIDE; i++) {
		const uint8_t *texel = &p_picture[size_t(4 * i)];
		const double alpha = texel[3] / 255.0;
		sum += alpha * Eigen::Vector4d(texel[0], texel[1], texel[2], 1.0);
	}
	return { sum.x() / std::max(sum.w(), 1e-9), sum.y() / std::max(sum.w(), 1e-9), sum.z() / std::max(sum.w(), 1e-9),
		sum.w() / ((p_to_row - p_from_row) * SIDE) };
}

} // namespace

TEST_CASE("a picture of a species has its colour, and room above the blades") {
	const std::vector<uint8_t> picture = draw_species({}, make_look({ 0.05f, 0.4f, 0.02f }), SIDE);
	REQUIRE(picture.size() == size_t(4 * SIDE * SIDE));
	const Eigen::Vector4d mean = mean_of(picture);
	CHECK(mean.y() > 1.5 * mean.x());
	CHECK(mean.y() > 1.5 * mean.z());
	CHECK(mean.w() > 0.2);
	CHECK(mean_of(picture, 0, 2).w() < 0.05);
	CHECK(mean_of(picture, SIDE / 2, SIDE).w() > mean_of(picture, 0, SIDE / 2).w());
}

TEST_CASE("dry blades and flowers show in it") {
	PictureLook look = make_look({ 0.05f, 0.4f, 0.02f });
	const Eigen::Vector4d green = mean_of(draw_species({}, look, SIDE));
	look.dry = 1.0f;
	look.dry_color = { 0.6f, 0.5f, 0.2f };
	CHECK(mean_of(draw_species({}, look, SIDE)).x() > green.x() + 10.0);
	look.dry = 0.0f;
	const std::array<uint8_t, 16> red = { 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255 };
	look.card = red;
	look.card_side = 2;
	look.card_share = 0.5f;
	look.card_width = look.card_height = 0.08f;
	CHECK(mean_of(draw_species({}, look, SIDE)).x() > green.x() + 20.0);
}

TEST_CASE("small flowers are drawn so large that one knows them, before their leaves") {
	PictureLook look = make_look({ 0.05f, 0.4f, 0.02f });
	const std::array<uint8_t, 16> red = { 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255 };
	const std::array<uint8_t, 16> grey = { 90, 90, 90, 255, 90, 90, 90, 255, 90, 90, 90, 255, 90, 90, 90, 255 };
	look.card = red;
	look.leaf = grey;
	look.card_side = 2;
	look.leaf_size = 0.3f;
	look.card_share = 0.04f;
	look.card_width = look.card_height = 0.01f; // of blades of half a metre: one texel
	const std::vector<uint8_t> picture = draw_species({}, look, SIDE);
	int longest = 0;
	for (int y = 0; y < SIDE; y++) {
		int run = 0;
		for (int x = 0; x < SIDE; x++) {
			const uint8_t *texel = &picture[size_t(4 * (y * SIDE + x))];
			run = texel[3] > 0 && texel[0] > 100 && texel[0] > 2 * texel[1] ? run + 1 : 0;
			longest = std::max(longest, run);
		}
	}
	CHECK(longest >= SIDE / 6);
	look.card = {};
	CHECK(mean_of(draw_species({}, look, SIDE)).x() < 100.0);
}

TEST_CASE("a species without blades has a clear picture") {
	PatchParams none;
	none.weights.fill(0.0);
	CHECK(mean_of(draw_species(none, make_look({ 0.1f, 0.2f, 0.1f }), SIDE)).w() == 0.0);
	CHECK(mean_of(draw_species({}, PictureLook(), SIDE)).w() == 0.0);
	CHECK(draw_species({}, make_look({ 0.1f, 0.2f, 0.1f }), 0).empty());
}

TEST_CASE("a picture of a plant shows its faces, the nearer ones, and thin stems") {
	PictureSurface plant;
	const auto add = [&](const Eigen::Vector3f &p_a, const Eigen::Vector3f &p_b, const Eigen::Vector3f &p_c,
							 const Eigen::Vector3f &p_color) {
		for (const Eigen::Vector3f &place : { p_a, p_b, p_c }) {
			plant.indices.push_back(int32_t(plant.places.size()));
			plant.places.push_back(place);
			plant.colors.push_back(p_color);
			plant.uvs.push_back({ 0.5f, 0.5f });
		}
	};
	// A stem of a thousandth of the height, and a flower on it: red in front of blue.
	add({ 0, 0, 0 }, { 0.001f, 0, 0 }, { 0, 0.8f, 0 }, { 0, 0.5f, 0 });
	add({ -0.2f, 0.8f, 0 }, { 0.2f, 0.8f, 0 }, { 0, 1, 0 }, { 0, 0, 1 });
	add({ -0.2f, 0.8f, 0.1f }, { 0.2f, 0.8f, 0.1f }, { 0, 1, 0.1f }, { 1, 0, 0 });
	const std::vector<uint8_t> picture = draw_plant({ &plant, 1 }, SIDE);
	REQUIRE(picture.size() == size_t(4 * SIDE * SIDE));
	int rows_of_stem = 0;
	for (int y = 32; y < 60; y++) {
		const Eigen::Vector4d row = mean_of(picture, y, y + 1);
		rows_of_stem += row.w() > 0.0 && row.y() > row.x() ? 1 : 0;
	}
	CHECK(rows_of_stem == 28);
	const Eigen::Vector4d flower = mean_of(picture, 12, 26);
	CHECK(flower.x() > 100.0);
	CHECK(flower.x() > 2.0 * flower.z());

	CHECK(mean_of(picture, 18, 24).w() > 0.2); // the plant is slim, so its upper half fills the picture

	plant.texture = { 255, 255, 255, 100 };
	plant.texture_width = plant.texture_height = 1;
	plant.scissor = 0.5f;
	CHECK(mean_of(draw_plant({ &plant, 1 }, SIDE)).w() == 0.0);
	plant.scissor = 0.3f;
	CHECK(mean_of(draw_plant({ &plant, 1 }, SIDE)).w() > 0.0);
	CHECK(mean_of(draw_plant({}, SIDE)).w() == 0.0);
}
