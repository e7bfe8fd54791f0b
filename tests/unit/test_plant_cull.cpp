// SPDX-License-Identifier: MIT
// Which plants are drawn by a mesh: the rules of shaders/plants/plants.glsl, on the CPU's twin.
#include "core/detail/plant_cull.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using namespace grass;

namespace {

constexpr int NONE = 0, NEAR = 1, FAR = 2; // species: without a mesh, with one up to 4 m, up to 8 m
const PlantCull::Distances DISTANCES = { 0.0f, 4.0f, 8.0f };

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
				make_field(), view, p_cover, [p_slot](int) { return p_slot; }, plants_of, DISTANCES);
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
				const float limit = DISTANCES[size_t(species)];
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
