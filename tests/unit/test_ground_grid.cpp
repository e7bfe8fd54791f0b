// SPDX-License-Identifier: MIT
// A map whose heights lie where a terrain has its vertices: it shows that terrain, from triangles to blades, and through its file.
#include "map_scene.h"

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/map/grid_finder.h"
#include "core/map/height_sheet.h"
#include "core/map/map_changes.h"
#include "core/map/map_layers.h"
#include "core/map/map_merge.h"
#include "core/paint/lay_ground.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

using namespace grass;
using namespace grass::test;

namespace {

constexpr int SIDE = 48; // cells of the terrain
const MapRegion ALL{ { -20.0, -20.0 }, { 20.0, 20.0 } };

// Rough ground: vertices a metre apart, up to 0.4 m high.
struct RoughTerrain {
	Eigen::Vector2d corner; // of its first vertex
	GroundSplit split = GroundSplit::BESIDE;
	double side = 1.0; // of a cell

	Eigen::Vector3d vertex(int p_i, int p_j) const {
		const double height = double(grass_hash(uint32_t(p_i) * 131u + uint32_t(p_j) * 7919u) & 1023u) / 2560.0;
		return { corner.x() + p_i * side, height, corner.y() + p_j * side };
	}
	using Add = std::function<void(const Eigen::Vector3d &, const Eigen::Vector3d &, const Eigen::Vector3d &)>;
	void visit(const Add &p_add) const {
		for (int j = 0; j < SIDE; j++) {
			for (int i = 0; i < SIDE; i++) {
				const Eigen::Vector3d a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i, j + 1), d = vertex(i + 1, j + 1);
				if (split == GroundSplit::BESIDE) {
					p_add(a, c, b);
					p_add(b, c, d);
				} else {
					p_add(a, d, b);
					p_add(a, c, d);
				}
			}
		}
	}
	std::optional<GroundGrid> find_grid() const {
		GridFinder finder;
		visit([&](const auto &p_a, const auto &p_b, const auto &p_c) { finder.add(p_a, p_b, p_c); });
		return finder.find();
	}
	HeightSheet sheet(const GroundGrid &p_grid) const {
		HeightSheet made(ALL.grown(GroundReading::REACH), p_grid);
		visit([&](const auto &p_a, const auto &p_b, const auto &p_c) { made.add(p_a, p_b, p_c); });
		return made;
	}
	PaintMap lay(const GroundGrid &p_grid) const {
		PaintMap map;
		map.set_base_density(1.0);
		map.set_ground_grid(p_grid);
		const HeightSheet heights = sheet(p_grid);
		const auto between = [&](const Eigen::Vector2d &p_place) { return heights.between(p_place); };
		lay_ground(
				map, ALL, [&](const Eigen::Vector2d &p_place) { return heights.at(p_place); }, MissingGround::STAYS, nullptr,
				LedgeSearch{ between });
		return map;
	}
};

// Returns how far the ground of a map is from the terrain, metres, at places where it has all heights around; ascending.
std::vector<double> errors_of(const RoughTerrain &p_terrain, const std::function<double(const Eigen::Vector2d &)> &p_ground) {
	const HeightSheet exact = p_terrain.sheet(GroundGrid());
	std::mt19937 random(7);
	std::uniform_real_distribution<double> place(-18.5, 18.5);
	std::vector<double> errors;
	for (int n = 0; n < 20000; n++) {
		const Eigen::Vector2d at(place(random), place(random));
		errors.push_back(std::abs(p_ground(at) - exact.between(at)));
	}
	std::sort(errors.begin(), errors.end());
	return errors;
}

MapLayers lay_out(const PaintMap &p_map) {
	MapPlace place;
	place.grid = TileGrid::make(40.0, 40.0, 256.0);
	place.follow = 1.0f;
	MapLayers layers(place);
	layers.update(p_map, layers.get_region());
	return layers;
}

bool is_same_grid(const GroundGrid &p_one, int32_t p_x, int32_t p_z, GroundSplit p_split) {
	return p_one == GroundGrid{ p_x, p_z, p_split };
}

} // namespace

TEST_CASE("ground_grid: heights lie at vertices, wherever these are") {
	CHECK(is_same_grid(GroundGrid::at({ 3.5, -7.5 }, GroundSplit::BLENDED), 0, 0, GroundSplit::BLENDED));
	CHECK(is_same_grid(GroundGrid::at({ 3.0, -8.0 }, GroundSplit::BESIDE), 512, 512, GroundSplit::BESIDE));
	CHECK(is_same_grid(GroundGrid::at({ 3.75, -7.25 }, GroundSplit::ACROSS), 256, 256, GroundSplit::ACROSS));
	CHECK(is_same_grid(GroundGrid::at({ -0.0001, 0.99999 }, GroundSplit::BLENDED), 512, 512, GroundSplit::BLENDED)); // not minus a half
	for (const double at : { -17.3, 0.0, 0.49, 0.51, 12.125 }) {
		const GroundGrid grid = GroundGrid::at({ at, 0.5 }, GroundSplit::ACROSS);
		CHECK(GroundGrid::is_step(grid.x));
		const double off = at - 0.5 - grid.offset().x();
		CHECK(std::abs(off - std::round(off)) <= 0.5 / GroundGrid::STEPS + 1e-9);
		GroundGrid back;
		CHECK(unpack_ground_grid(pack_ground_grid(grid), back));
		CHECK(back == grid);
	}
	GroundGrid none;
	CHECK_FALSE(unpack_ground_grid(0u, none)); // minus a half
	CHECK_FALSE(unpack_ground_grid(pack_ground_grid(GroundGrid()) | 3u, none)); // no such split
	CHECK_FALSE(unpack_ground_grid(pack_ground_grid(GroundGrid()) | 1u << 30, none));
	CHECK(GroundGrid::of_cells({ 0.25, 0.0 }, { 0.0, 2.0 }, { -2.0, 0.0 }) == GroundGrid::at({ 0.25, 0.0 }, GroundSplit::BLENDED));
	CHECK_FALSE(GroundGrid::of_cells({ 0.25, 0.0 }, { 1.5, 0.0 }, { 0.0, 1.5 }));
	CHECK_FALSE(GroundGrid::of_cells({ 0.25, 0.0 }, { 0.0, 0.0 }, { 0.0, 1.0 }));
	CHECK_FALSE(GroundGrid::of_cells({ 0.25, 0.0 }, { 1.0, 1.0 }, { -1.0, 1.0 })); // turned by 45 degrees
}

TEST_CASE("ground_grid: it is found in a terrain's triangles") {
	for (const GroundSplit split : { GroundSplit::BESIDE, GroundSplit::ACROSS }) {
		const auto found = RoughTerrain{ { -24.0, -23.75 }, split }.find_grid();
		REQUIRE(found);
		CHECK(is_same_grid(*found, 512, -256, split));
		CHECK(RoughTerrain{ { -48.0, -48.0 }, split, 2.0 }.find_grid() == GroundGrid{ 512, 512, split }); // every second height
		CHECK_FALSE(RoughTerrain{ { -12.0, -12.0 }, split, 0.5 }.find_grid());
		CHECK_FALSE(RoughTerrain{ { -24.0, -24.0 }, split, 1.1 }.find_grid());
	}
	GridFinder plane;
	CHECK_FALSE(plane.find());
	plane.add({ 0.0, 0.0, 0.0 }, { 1.0, 0.5, 0.0 }, { 0.0, 0.0, 1.0 });
	plane.add({ 1.0, 0.5, 0.0 }, { 0.0, 0.0, 1.0 }, { 1.0, 0.5, 1.0 });
	CHECK_FALSE(plane.find()); // needs none
	plane.add({ 1.0, 0.0, 0.0 }, { 1.0, 2.0, 0.0 }, { 1.0, 0.0, 1.0 });
	CHECK_FALSE(plane.find()); // a wall is no ground
}

TEST_CASE("ground_grid: a terrain of a metre's cells is met everywhere within 2 mm, and without its grid is not") {
	for (const GroundSplit split : { GroundSplit::BESIDE, GroundSplit::ACROSS }) {
		for (const Eigen::Vector2d &corner : { Eigen::Vector2d(-24.0, -24.0), Eigen::Vector2d(-23.7, -24.15) }) {
			const RoughTerrain terrain{ corner, split };
			const auto grid = terrain.find_grid();
			REQUIRE(grid);
			const PaintMap map = terrain.lay(*grid);
			const std::vector<double> errors =
					errors_of(terrain, [&](const Eigen::Vector2d &p_at) { return map.sample(MAP_GROUND, 0, p_at); });
			CHECK(errors.back() < 0.002);
			const MapLayers layers = lay_out(map);
			const std::vector<double> shown =
					errors_of(terrain, [&](const Eigen::Vector2d &p_at) { return double(layers.sample(p_at.cast<float>()).ground); });
			CHECK(shown.back() < 0.002);
		}
	}
	const RoughTerrain terrain{ { -24.0, -24.0 } };
	const PaintMap between = terrain.lay(GroundGrid());
	CHECK(errors_of(terrain, [&](const Eigen::Vector2d &p_at) { return between.sample(MAP_GROUND, 0, p_at); })[15000] > 0.03);
}

TEST_CASE("ground_grid: layers show what the map says: slopes, combed grass, holes, ledges") {
	const RoughTerrain terrain{ { -23.7, -24.15 } };
	PaintMap map = terrain.lay(*terrain.find_grid());
	const auto with_wall = [&](const Eigen::Vector2d &p_place) {
		return p_place.x() > 3.3 && p_place.x() < 9.1 ? 2.0 : (p_place.y() > 12.0 ? std::nan("") : 0.1 * p_place.y());
	};
	lay_ground(map, ALL, with_wall, MissingGround::HOLE, nullptr, LedgeSearch{ with_wall });
	REQUIRE(map.uses(MAP_LEDGE));
	Brush comb;
	comb.tool = MapTool::COMB;
	comb.direction = { 1.0, 0.5 };
	comb.strength = 1.0;
	const Eigen::Vector2d middle[] = { { -5.0, -5.0 } };
	apply_brush(map, MapShape(middle, 6.0, 3.0), comb);
	const MapLayers layers = lay_out(map);
	std::mt19937 random(3);
	std::uniform_real_distribution<double> place(-18.0, 18.0);
	int holes = 0, high = 0, combed = 0;
	for (int n = 0; n < 4000; n++) {
		const Eigen::Vector2d at(place(random), place(random));
		const Growth here = layers.sample(at.cast<float>());
		const double ground = map.sample(MAP_GROUND, 0, at);
		CHECK(double(here.ground) == doctest::Approx(ground).epsilon(1e-4).scale(1.0));
		const bool is_near_wall = std::min(std::abs(at.x() - 3.3), std::abs(at.x() - 9.1)) < 0.13;
		if (!is_near_wall && at.y() < 10.5) {
			CHECK(ground == doctest::Approx(with_wall(at)).epsilon(0.01).scale(1.0));
		}
		CHECK(std::abs(double(here.lean.x) - map.sample(MAP_LEAN, 0, at)) < 0.1);
		combed += here.lean.x > 0.3f ? 1 : 0;
		holes += here.density == 0.0f && at.y() > 13.0 ? 1 : 0;
		high += here.ground > 1.9f ? 1 : 0;
	}
	CHECK(holes > 200);
	CHECK(high > 500);
	CHECK(combed > 100);
	const TileGrid &tiles = layers.get_place().grid;
	const TileCover &cover = *layers.get_cover();
	for (int n = 0; n < 2000; n++) {
		const Eigen::Vector2d at(place(random), place(random));
		const Growth here = layers.sample(at.cast<float>());
		const TileRange range = tiles.get_range(at.x(), at.x(), at.y(), at.y(), 0.0);
		if (here.density > 0.0f) {
			const TileCover::Tile &tile = cover.get(range.x_begin, range.z_begin);
			CHECK(here.ground > tile.low - 1e-3f);
			CHECK(here.ground < tile.high + 1e-3f);
		}
	}
}

TEST_CASE("ground_grid: only ground that lies in the region gives way to another grid") {
	PaintMap map;
	CHECK(is_all_ground_in(map, { { 0.0, 0.0 }, { 1.0, 1.0 } }));
	map = RoughTerrain{ { -24.0, -24.0 } }.lay({ 512, 512, GroundSplit::BESIDE });
	CHECK(is_all_ground_in(map, ALL));
	CHECK(is_all_ground_in(map, ALL.grown(100.0)));
	CHECK_FALSE(is_all_ground_in(map, ALL.grown(-1.5)));
	map.clear();
	CHECK(map.get_ground_grid() == GroundGrid());
}

TEST_CASE("ground_grid: files and changes carry it, and a map without one is written as before") {
	PaintMap map = make_map(5), read;
	CHECK(get_u32(write_map(map, RUNS), 8) == MAP_FILE_UNGRIDDED);
	const MapBytes before = write_map(map, RUNS);
	const PaintMap was = map;
	map.set_ground_grid({ -200, 512, GroundSplit::ACROSS });
	const MapBytes bytes = write_map(map, RUNS);
	CHECK(get_u32(bytes, 8) == MAP_FILE_VERSION);
	CHECK(read_map(bytes, RUNS, read).empty());
	CHECK(read.get_ground_grid() == map.get_ground_grid());
	CHECK(read.compare(map).empty());
	for (size_t count = 0; count < bytes.size(); count += 1 + count / 64) {
		CHECK_FALSE(read_map(std::span(bytes).first(count), RUNS, read).empty());
	}
	MapBytes broken = bytes;
	broken[23] = 1;
	CHECK(read_map(broken, RUNS, read).find("makes no sense") != std::string::npos);
	CHECK(read.get_ground_grid() == map.get_ground_grid()); // as it was
	CHECK(read_map(before, RUNS, read).empty());
	CHECK(read.get_ground_grid() == GroundGrid());

	const MapBytes changes = write_changes(was, map, RUNS);
	PaintMap other = was;
	CHECK(apply_changes(changes, RUNS, other).has_base_changed);
	CHECK(other.get_ground_grid() == map.get_ground_grid());
	other.set_ground_grid({ 1, 1, GroundSplit::ACROSS });
	CHECK(apply_changes(changes, RUNS, other).reason.find("heights") != std::string::npos);

	PaintMap mine = was;
	CHECK(merge_maps(was, map, mine).has_base_changed);
	CHECK(mine.get_ground_grid() == map.get_ground_grid());
	CHECK(merge_maps(map, was, mine).has_base_changed); // undone
	CHECK(mine.get_ground_grid() == GroundGrid());
}
