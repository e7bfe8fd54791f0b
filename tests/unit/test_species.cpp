// SPDX-License-Identifier: MIT
// Several species in one field: which blade is which.
#include "species_scene.h"

#include "core/base/half.h"
#include "core/map/map_layers.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace grass;
using namespace grass::test;

namespace {

Eigen::Vector2f root_of(int p_blade) {
	const uint16_t *halves = &two_patches()->texels[Patch::texel_index(p_blade, 0)];
	return { half_to_float(halves[0]), half_to_float(halves[1]) };
}

int choose(const SpeciesMix &p_mix, int p_x, int p_z, int p_blade, const MapLayers *p_layers = nullptr, uint32_t p_seed = 0) {
	const int start = int(grass_tile_start(uint32_t(p_x), uint32_t(p_z), p_seed));
	return p_mix.choose_species(p_x, p_z, p_blade, root_of(start + p_blade), p_layers);
}

// Shares of the species among all blades of the field.
std::vector<double> count(const SpeciesMix &p_mix) {
	std::vector<double> found(GRASS_MAX_SPECIES);
	for (int z = 0; z < SPECIES_GRID.get_tiles_z(); z++) {
		for (int x = 0; x < SPECIES_GRID.get_tiles_x(); x++) {
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				found[size_t(choose(p_mix, x, z, b))] += 1.0 / (double(SPECIES_GRID.get_tile_count()) * GRASS_BLADES_PER_TILE);
			}
		}
	}
	return found;
}

// Layers on which p_number was painted into a disc about the field's middle.
MapLayers painted(double p_radius, int p_number) {
	PaintMap map;
	map.set_base_density(1.0);
	Brush brush;
	brush.tool = MapTool::SPECIES;
	brush.target = p_number;
	apply_brush(map, MapShape::stroke({ 0.0, 0.0 }, { 0.0, 0.0 }, p_radius, 1.0, Falloff::LINEAR), brush);
	MapLayers layers({ SPECIES_GRID });
	layers.update(map, layers.get_region());
	return layers;
}

} // namespace

TEST_CASE("species: the same blade is the same species every time, and another one in a field of another seed") {
	const SpeciesParams params[] = { { 0.5, 2.0, 0.5 }, { 0.5, 2.0, 0.5 } };
	const SpeciesMix one(params, SPECIES_GRID, 3), same(params, SPECIES_GRID, 3), other(params, SPECIES_GRID, 4);
	int differ = 0;
	for (int n = 0; n < 6400; n++) {
		const int x = n % 10, z = n / 640, b = (n / 10) % 64;
		CHECK(choose(one, x, z, b) == choose(same, x, z, b));
		differ += choose(one, x, z, b) != choose(other, x, z, b);
	}
	CHECK(differ > 2000);
	CHECK(differ < 4400);
}

TEST_CASE("species: shares come out, however strong the stands are, wherever a species stands in the list [Eq P2]") {
	const double shares[3][4] = { { 0.5, 0.3, 0.15, 0.05 }, { 0.1, 0.1, 0.7, 0.1 }, { 0.25, 0.25, 0.25, 0.25 } };
	for (const double strength : { 0.0, 0.4, 0.8, 1.0 }) {
		for (const auto &row : shares) {
			std::vector<SpeciesParams> params;
			for (const double share : row) {
				params.push_back({ share, 1.5, strength });
			}
			const SpeciesMix mix(params, SPECIES_GRID, 0);
			const std::vector<double> found = count(mix);
			for (size_t s = 0; s < 4; s++) {
				INFO("strength ", strength, ", species ", s, " of share ", row[s]);
				CHECK(std::abs(found[s] - row[s]) < (strength == 0.0 ? 0.003 : 0.03));
				CHECK(mix.get_share(int(s)) == doctest::Approx(row[s]));
			}
		}
	}
}

TEST_CASE("species: stands make neighbours alike, and their borders are as sharp as they are strong") {
	double before = 0.0;
	for (const double strength : { 0.0, 0.5, 1.0 }) {
		const SpeciesParams params[] = { { 0.5, 4.0, strength }, { 0.5, 4.0, strength } };
		const SpeciesMix mix(params, SPECIES_GRID, 0);
		int alike = 0, pairs = 0;
		for (int z = 0; z < SPECIES_GRID.get_tiles_z(); z += 3) {
			for (int x = 0; x < SPECIES_GRID.get_tiles_x(); x += 3) {
				for (int b = 1; b < GRASS_BLADES_PER_TILE; b += 7) {
					alike += choose(mix, x, z, b) == choose(mix, x, z, b - 1);
					pairs++;
				}
			}
		}
		const double share = double(alike) / pairs;
		INFO("strength ", strength);
		CHECK(share > before + 0.03);
		before = share;
		if (strength == 0.0) {
			CHECK(share == doctest::Approx(0.5).epsilon(0.03));
		} else if (strength == 1.0) {
			CHECK(share > 0.9);
		}
	}
}

TEST_CASE("species: the shares around a place say how often its blades are which [Eq P4]") {
	const SpeciesParams params[] = { { 0.6, 4.0, 0.0 }, { 0.25, 3.0, 0.7 }, { 0.15, 6.0, 0.9 } };
	const SpeciesMix mix(params, SPECIES_GRID, 5);
	std::array<double, 3> expected{}, found{};
	for (int z = 40; z < 46; z++) {
		for (int x = 70; x < 76; x++) {
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				const int start = int(grass_tile_start(uint32_t(x), uint32_t(z), 5));
				const Eigen::Vector2f root = root_of(start + b);
				const Eigen::Vector2f place((float(x) + root.x() - 80.0f) * 0.5f, (float(z) + root.y() - 80.0f) * 0.5f);
				const auto shares = mix.get_shares_at(place, nullptr);
				CHECK(shares[0] + shares[1] + shares[2] == doctest::Approx(1.0));
				for (size_t s = 0; s < 3; s++) {
					expected[s] += double(shares[s]) / (36 * 64);
				}
				found[size_t(mix.choose_species(x, z, b, root, nullptr))] += 1.0 / (36 * 64);
			}
		}
	}
	for (size_t s = 0; s < 3; s++) {
		CHECK(std::abs(found[s] - expected[s]) < 0.04);
	}
}

TEST_CASE("species: stands that end softly keep their shares, fray a little, and slope down to their borders [Eq P6]") {
	const auto make = [](double p_edge, bool p_falls) {
		const SpeciesParams params[] = { { 0.5, 1.5, 0.9, 1, p_edge, p_falls }, { 0.5, 1.5, 0.9, 1, p_edge, p_falls } };
		return SpeciesMix(params, SPECIES_GRID, 0);
	};
	const SpeciesMix sharp = make(0.0, true), soft = make(0.6, true), mesh = make(0.6, false);
	CHECK(!sharp.chooses_as(soft));
	CHECK(std::abs(count(soft)[1] - 0.5) < 0.03);
	int all = 0, moved = 0, inner = 0, outer = 0;
	double inside = 0.0, outside = 0.0; // sums of heights: within a stand, and where another one begins
	float lowest = 1.0f;
	for (int z = 30; z < 130; z += 2) {
		for (int x = 30; x < 130; x += 2) {
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b += 9) {
				const int start = int(grass_tile_start(uint32_t(x), uint32_t(z), 0));
				const Eigen::Vector2f root = root_of(start + b);
				const SpeciesMix::RootOf place = [&](int) { return root; };
				float height = 0.0f, flat = 0.0f, upright = 0.0f;
				const int species = soft.choose_species(x, z, b, place, nullptr, &height);
				moved += species != sharp.choose_species(x, z, b, place, nullptr, &flat);
				all++;
				CHECK(flat == 1.0f);
				CHECK(mesh.choose_species(x, z, b, place, nullptr, &upright) == species);
				CHECK(upright == 1.0f);
				CHECK(height <= 1.0f);
				lowest = std::min(lowest, height);
				const Eigen::Vector2f at((float(x) + root.x() - 80.0f) * 0.5f, (float(z) + root.y() - 80.0f) * 0.5f);
				const float other = sharp.get_shares_at(at, nullptr)[size_t(1 - species)];
				(other > 0.3f ? outside : inside) += other > 0.3f || other == 0.0f ? double(height) : 0.0;
				outer += other > 0.3f;
				inner += other == 0.0f;
			}
		}
	}
	CHECK(lowest >= 0.4f);
	CHECK(lowest < 0.5f);
	CHECK(moved > all / 100);
	CHECK(moved < all / 5);
	CHECK(inside / inner > 0.8);
	CHECK(outside / outer < 0.75);
}

TEST_CASE("species: what is painted grows there alone, and mixes with what is around it only along the border [Eq P3]") {
	const SpeciesParams params[] = { { 1.0, 4.0, 0.3 }, { 0.0, 4.0, 0.3 } };
	const SpeciesMix mix(params, SPECIES_GRID, 0);
	const MapLayers layers = painted(10.0, 2);
	int inside = 0, outside = 0, mixed = 0;
	for (int z = 50; z < 110; z++) {
		for (int x = 50; x < 110; x++) {
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b += 5) {
				const double distance = 0.5 * std::hypot(x + 0.5 - 80.0, z + 0.5 - 80.0);
				const int species = choose(mix, x, z, b, &layers);
				if (distance < 8.0) {
					CHECK(species == 1);
					inside++;
				} else if (distance > 12.0) {
					CHECK(species == 0);
					outside++;
				} else {
					mixed += species;
				}
			}
		}
	}
	CHECK(inside > 5000);
	CHECK(outside > 5000);
	CHECK(mixed > 500);
	CHECK(mix.get_shares_at({ 1.0f, -3.0f }, &layers)[1] == 1.0f);
	CHECK(mix.get_shares_at({ 20.0f, -3.0f }, &layers)[1] == 0.0f);
	const MapLayers unknown = painted(10.0, 9); // no such species: as they are mixed
	CHECK(choose(mix, 80, 80, 0, &unknown) == 0);
}

TEST_CASE("species: a painted border lies where it was painted, on tiles of any size") {
	for (const double density : { 64.0, 180.0, 4096.0 }) {
		const TileGrid grid = TileGrid::make(20.0, 20.0, density);
		const SpeciesParams params[] = { { 1.0, 4.0, 0.0 }, { 0.0, 4.0, 0.0 } };
		const SpeciesMix mix(params, grid, 0);
		PaintMap map;
		for (int j = -16; j < 16; j++) {
			for (int i = -16; i < 3; i++) { // up to x = 3 m
				map.set_code(MAP_SPECIES, 0, i, j, 2);
			}
		}
		MapLayers layers({ grid });
		layers.update(map, layers.get_region());
		double sum = 0.0;
		int blades = 0;
		for (int z = 0; z < grid.get_tiles_z(); z++) {
			for (int x = 0; x < grid.get_tiles_x(); x++) {
				for (int b = 0; b<GRASS_BLADES_PER_TILE; b += density> 1000.0 ? 8 : 1) {
					const int start = int(grass_tile_start(uint32_t(x), uint32_t(z), 0));
					const Eigen::Vector2f root = root_of(start + b);
					const double place = (x + double(root.x()) - 0.5 * grid.get_tiles_x()) * grid.get_tile_size();
					const int species = mix.choose_species(x, z, b, root, &layers);
					if (std::abs(place - 3.0) > 0.51) {
						CHECK(species == (place < 3.0 ? 1 : 0));
					} else {
						sum += species;
						blades++;
					}
				}
			}
		}
		INFO("density ", density);
		CHECK(sum / blades == doctest::Approx(0.5).epsilon(0.08));
	}
}

TEST_CASE("species: one, none with a share, too many and numbers that are none") {
	const SpeciesParams one[] = { {} };
	CHECK(choose(SpeciesMix(one, SPECIES_GRID, 0), 3, 4, 5) == 0);
	const SpeciesParams none[] = { { 0.0 }, { 0.0 } };
	CHECK(count(SpeciesMix(none, SPECIES_GRID, 0))[0] == doctest::Approx(1.0));
	CHECK(SpeciesMix(none, SPECIES_GRID, 0).get_share(0) == 1.0);
	const std::vector<SpeciesParams> many(12);
	CHECK(SpeciesMix(many, SPECIES_GRID, 0).get_count() == GRASS_MAX_SPECIES);
	const double nan = std::nan("");
	const SpeciesParams bad[] = { { nan, nan, nan }, { -3.0, -1.0, 1e30 }, { 1e30, 1e30, -1.0 } };
	const SpeciesMix mix(bad, SPECIES_GRID, 0);
	CHECK(mix.get_share(0) + mix.get_share(1) + mix.get_share(2) == doctest::Approx(1.0));
	CHECK(mix.get_share(1) == 0.0);
	const std::vector<double> found = count(mix);
	CHECK(found[1] == 0.0);
	CHECK(found[0] > 0.2);
}

TEST_CASE("species: the stems of a plant are one species, in the share that was asked for, and painted whole") {
	const SpeciesParams params[] = { { 0.7, 4.0, 0.3, 1 }, { 0.3, 4.0, 0.3, 8 } };
	const SpeciesMix mix(params, SPECIES_GRID, 0);
	const MapLayers layers = painted(10.0, 2), grass = painted(10.0, 1);
	int plants = 0, blades = 0, inside = 0, in_grass = 0, border = 0;
	for (int z = 40; z < 120; z++) {
		for (int x = 40; x < 120; x++) {
			for (int first = 0; first < GRASS_BLADES_PER_TILE; first += 8) {
				const double distance = 0.5 * std::hypot(x + 0.5 - 80.0, z + 0.5 - 80.0);
				std::array<int, 3> stems{}; // without paint, with their own, with the other's
				for (int b = first; b < first + 8; b++) {
					stems[0] += mix.choose_species(x, z, b, root_of, nullptr);
					stems[1] += mix.choose_species(x, z, b, root_of, &layers);
					stems[2] += mix.choose_species(x, z, b, root_of, &grass);
				}
				for (const int count : { stems[0], stems[1] }) {
					CHECK((count == 0 || count == 8));
				}
				plants += stems[0] / 8;
				blades += 8;
				if (distance < 8.0) {
					inside += stems[1] == 8;
					in_grass += stems[2] != 0;
				} else if (distance < 12.0) {
					border += stems[1] == 8;
				}
			}
		}
	}
	CHECK(double(8 * plants) / blades == doctest::Approx(0.3).epsilon(0.15));
	CHECK(inside > 5000); // all of them: 804 tiles of 8 plants
	CHECK(in_grass == 0);
	CHECK(border > 1000);
}

TEST_CASE("plants with a mesh are drawn up to their distance, or as far as so many vertices stand") {
	CHECK(near_plants(30.0, 0.1, 1000) == 30.0);
	CHECK(near_plants(30.0, 100.0, 0) == 30.0); // no mesh
	CHECK(near_plants(30.0, 0.0, 1000) == 30.0); // none grows
	const double near = near_plants(30.0, 20.0, 1000);
	CHECK(near < 30.0);
	CHECK(20.0 * 1000.0 * 3.14159265 * near * near == doctest::Approx(NEAR_PLANT_VERTICES));
	CHECK(near_plants(1000.0, 20.0, 1000) == near);
}

// [Eq P1] [Eq P2] Where one field ends, the next begins with the same numbers, exactly.
TEST_CASE("species: stands continue from one field to the next, wherever they are") {
	const SpeciesParams params[] = { { 0.5, 4.0, 0.8, 1 }, { 0.3, 7.3, 0.6, 1 }, { 0.4, 2.0, 1.0, 1 } };
	const double side = SPECIES_GRID.get_size_x();
	for (const double metres : { 0.0, 8000.0, -8192.0 }) {
		const double origin = std::round(metres / side) * side;
		const SpeciesMix left(params, SPECIES_GRID, 3, { origin, -origin }), right(params, SPECIES_GRID, 3, { origin + side, -origin });
		double most = 0.0, spread = 0.0;
		const std::array<float, GRASS_MAX_SPECIES> first = left.get_shares_at({ float(0.5 * side), 0.0f }, nullptr);
		for (float z = float(-0.45 * side); z < float(0.45 * side); z += 0.13f) {
			const auto here = left.get_shares_at({ float(0.5 * side), z }, nullptr);
			const auto there = right.get_shares_at({ float(-0.5 * side), z }, nullptr);
			for (size_t s = 0; s < 3; s++) {
				most = std::max(most, std::abs(double(here[s]) - double(there[s])));
				spread = std::max(spread, std::abs(double(here[s]) - double(first[s])));
			}
		}
		CHECK(most < 1e-6);
		CHECK(spread > 0.3); // there are stands
	}
}
