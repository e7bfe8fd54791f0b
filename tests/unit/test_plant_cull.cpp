// SPDX-License-Identifier: MIT
// Which plants are drawn by a mesh: the rules of shaders/species/plants.glsl, on the CPU's twin.
#include "core/lod/plant_cull.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

using namespace grass;

namespace {

constexpr int NONE = 0, NEAR = 1, FAR = 2; // species: without a mesh, with one up to 4 m, up to 8 m
const PlantCull::Kinds KINDS = { PlantKind{}, PlantKind{ 4.0f, 0.5f, 0.0f, 1 }, PlantKind{ 8.0f, 0.5f, 0.0f, 1 } }; // they hide nothing

// 40 m a side, tiles of 1 m.
CullField make_field() {
	return { TileGrid::make(40.0, 40.0, 64.0), 0.25f, 0.5f, { 0.01f, 0.5f }, 7, { 4096, 4096 } };
}

// Sees all that is around its eye.
ViewCamera make_camera(const Eigen::Vector3f &p_eye) {
	ViewCamera camera;
	for (size_t i = 0; i < 6; i++) {
		camera.planes[i] = Eigen::Vector4f::Zero();
		camera.planes[i][int(i / 2)] = i % 2 == 0 ? 1.0f : -1.0f;
		camera.planes[i].w() = camera.planes[i].head<3>().dot(p_eye) + 100.0f;
	}
	camera.eye = p_eye;
	camera.pixel_slope = 0.002f;
	return camera;
}

// Three plants in each tile, one of each species, in its middle.
struct Garden {
	int asked = 0; // tiles
	PlantCull::PlantsOf plants_of = [this](int, int, std::vector<StandingPlant> &r_plants) {
		asked++;
		for (const int species : { NONE, NEAR, FAR }) {
			r_plants.push_back({ uint8_t(10 * species), uint8_t(species), { 0.5f, 0.5f } });
		}
	};
	PlantCull cull;

	void choose(const std::vector<ViewCamera> &p_cameras, const TileCover *p_cover = nullptr, int p_slot = GRASS_NO_SLOT) {
		FieldView view;
		view.cameras = p_cameras;
		cull.choose(
				make_field(), view, p_cover, [p_slot](int) { return p_slot; }, plants_of, KINDS);
	}
};

} // namespace

TEST_CASE("plant_cull: plants within their species' distance of a camera, each once") {
	Garden garden;
	const Eigen::Vector3f eye(0.2f, 1.0f, 0.3f), other(1.5f, 1.0f, 0.3f);
	garden.choose({ make_camera(eye), make_camera(other) });
	CHECK(garden.cull.get_count(NONE) == 0);
	for (const int species : { NEAR, FAR }) {
		int expected = 0;
		std::set<std::pair<int, int>> found;
		for (int z = 0; z < 40; z++) {
			for (int x = 0; x < 40; x++) {
				const Eigen::Vector3f centre = make_field().grid.get_centre(x, z).cast<float>();
				const float limit = KINDS[size_t(species)].distance;
				expected += (centre - eye).norm() < limit || (centre - other).norm() < limit;
			}
		}
		const std::span<const float> all = garden.cull.get_instances(species);
		for (size_t at = 0; at < all.size(); at += GRASS_INSTANCE_FLOATS) {
			found.insert({ int(all[at + INSTANCE_TILE]), int(all[at + INSTANCE_TILE + 1]) });
			CHECK(all[at + INSTANCE_BLADES] == 10.0f * float(species)); // the blade
			CHECK(all[at + 17] == float(GRASS_NO_SLOT));
		}
		CHECK(expected > 20);
		CHECK(garden.cull.get_count(species) == expected);
		CHECK(int(found.size()) == expected);
	}
}

TEST_CASE("plant_cull: farther plants are chosen for their species' impostor, and where one becomes the other for both") {
	Garden garden;
	PlantCull::Kinds kinds = KINDS;
	kinds[size_t(NEAR + GRASS_MAX_SPECIES)] = { 9.0f, 0.5f, 0.0f, 1, 3.0f };
	FieldView view;
	view.cameras = { make_camera({ 0.2f, 1.0f, 0.3f }) };
	garden.cull.choose(
			make_field(), view, nullptr, [](int) { return GRASS_NO_SLOT; }, garden.plants_of, kinds);
	int expected = 0, both = 0;
	for (int z = 0; z < 40; z++) {
		for (int x = 0; x < 40; x++) {
			const float away = (make_field().grid.get_centre(x, z).cast<float>() - view.cameras[0].eye).norm();
			expected += away >= 3.0f && away < 9.0f;
			both += away >= 3.0f && away < 4.0f;
		}
	}
	CHECK(both > 5);
	CHECK(garden.cull.get_count(NEAR + GRASS_MAX_SPECIES) == expected);
	CHECK(garden.cull.get_count(FAR + GRASS_MAX_SPECIES) == 0); // it has none
	CHECK(garden.cull.get_count(NEAR) < expected);
}

TEST_CASE("plant_cull: tiles are asked once, until they are forgotten") {
	Garden garden;
	const std::vector<ViewCamera> cameras = { make_camera({ 0.0f, 1.0f, 0.0f }) };
	garden.choose(cameras);
	const int asked = garden.asked;
	CHECK(asked > 100);
	CHECK(asked < 700); // of 1,600
	garden.choose(cameras);
	CHECK(garden.asked == asked);
	CHECK(garden.cull.get_memory_usage() > size_t(asked) * 3 * sizeof(StandingPlant));
	garden.cull.forget();
	garden.choose(cameras);
	CHECK(garden.asked == 2 * asked);
}

TEST_CASE("plant_cull: none far from all cameras, none without a camera, and awake ones with their slot") {
	Garden garden;
	garden.choose({ make_camera({ 0.0f, 30.0f, 0.0f }) });
	CHECK(garden.cull.get_count(FAR) == 0);
	garden.choose({});
	CHECK(garden.cull.get_count(FAR) == 0);
	garden.choose({ make_camera({ 0.0f, 1.0f, 0.0f }) }, nullptr, GRASS_SLOT_HALF + 5);
	CHECK(garden.cull.get_instances(NEAR)[17] == 5.0f);
	CHECK(garden.cull.get_instances(NEAR)[19] == 1.0f);
}

namespace {

// Of a stand of 64 plants of four stems in each tile, which cover p_cover of the ground, seen p_above the tips: plants by tile.
std::map<std::pair<int, int>, std::vector<int>> draw_stand(float p_cover, float p_above, bool p_has_shadows, float p_distance = 18.0f) {
	const PlantCull::Kinds kinds = { PlantKind{ p_distance, 0.5f, p_cover / GRASS_BLADES_PER_TILE, 4 } };
	const auto plants_of = [](int, int, std::vector<StandingPlant> &r_plants) {
		for (int blade = 0; blade < GRASS_BLADES_PER_TILE; blade++) {
			r_plants.push_back({ uint8_t(blade), 0, { 0.5f, 0.5f } });
		}
	};
	FieldView view;
	view.cameras = { make_camera({ 0.0f, 0.5f + p_above, 0.0f }) };
	view.shadow_distance = p_has_shadows ? 100.0f : 0.0f;
	PlantCull cull;
	cull.choose(
			make_field(), view, nullptr, [](int) { return GRASS_NO_SLOT; }, plants_of, kinds);
	std::map<std::pair<int, int>, std::vector<int>> found;
	const std::span<const float> all = cull.get_instances(0);
	for (size_t at = 0; at < all.size(); at += GRASS_INSTANCE_FLOATS) {
		found[{ int(all[at + INSTANCE_TILE]), int(all[at + INSTANCE_TILE + 1]) }].push_back(int(all[at + INSTANCE_BLADES]));
	}
	return found;
}

// Plants in a tile, in the mean of those between two distances.
double mean_of(const std::map<std::pair<int, int>, std::vector<int>> &p_drawn, double p_from, double p_to) {
	double sum = 0.0;
	int tiles = 0;
	for (int z = 0; z < 40; z++) {
		for (int x = 0; x < 40; x++) {
			const double away = make_field().grid.get_centre(x, z).norm();
			if (away >= p_from && away < p_to) {
				const auto found = p_drawn.find({ x, z });
				sum += found == p_drawn.end() ? 0.0 : double(found->second.size());
				tiles++;
			}
		}
	}
	return sum / tiles;
}

} // namespace

TEST_CASE("[Eq L13] plants that others hide are not drawn, stems stay together, and shadows keep enough of them") {
	constexpr float COVER = 16.0f, ABOVE = 1.2f;
	constexpr double ALL = GRASS_BLADES_PER_TILE + GRASS_LOD_PLANT_FADE;
	const auto drawn = draw_stand(COVER, ABOVE, false), shaded = draw_stand(COVER, ABOVE, true), sparse = draw_stand(0.1f, ABOVE, false);
	CHECK(mean_of(drawn, 0.0, 0.8) == GRASS_BLADES_PER_TILE); // at the eye's feet
	CHECK(mean_of(sparse, 0.0, 16.0) == GRASS_BLADES_PER_TILE); // nothing hides any
	for (const double away : { 4.0, 8.0, 14.0 }) {
		CAPTURE(away);
		const double meets = COVER * away / (ABOVE + 0.25); // over the middle of the tile
		CHECK(mean_of(drawn, away - 0.7, away + 0.7) == doctest::Approx(2.0 * GRASS_LOD_DEPTH / meets * ALL).epsilon(0.1));
	}
	CHECK(mean_of(shaded, 14.0, 16.0) == doctest::Approx(GRASS_LOD_SHADE / COVER * ALL).epsilon(0.05));
	CHECK(mean_of(shaded, 0.0, 3.0) == doctest::Approx(mean_of(drawn, 0.0, 3.0)));
	for (const auto &[tile, blades] : drawn) {
		CHECK(blades.size() % 4 == 0);
		CHECK(blades.back() == int(blades.size()) - 1); // the first ones, which are an even sample
	}
}

TEST_CASE("[Eq L13] from above all plants are drawn") {
	CHECK(mean_of(draw_stand(8.0f, 10.0f, false), 0.0, 2.0) == GRASS_BLADES_PER_TILE);
}
