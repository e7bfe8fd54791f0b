// SPDX-License-Identifier: MIT
// Several species in one field: which blade is which, the patch they share, and how each swings.
#include "core/plants/species.h"

#include "core/base/half.h"
#include "core/paint/brush.h"
#include "core/plants/field_blades.h"
#include "core/solver/simulate.h"
#include "core/solver/solver_params.h"
#include "core/tiles/tile_bounds.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace grass;

namespace {

const TileGrid GRID = TileGrid::make(80.0, 80.0, 256.0); // 160 x 160 tiles of 0.5 m

std::shared_ptr<const Patch> make_patch(double p_length, uint32_t p_seed = 1) {
	PatchParams params;
	params.seed = p_seed;
	params.length_min = params.length_max = p_length;
	return std::make_shared<const Patch>(generate_patch(params));
}

std::shared_ptr<const Patch> two_patches() {
	static const auto joined = [] {
		const std::shared_ptr<const Patch> patches[] = { make_patch(0.4), make_patch(0.8, 7) };
		const double shares[] = { 0.5, 0.5 };
		return std::make_shared<const Patch>(join_patches(patches, shares));
	}();
	return joined;
}

Eigen::Vector2f root_of(int p_blade) {
	const uint16_t *halves = &two_patches()->texels[Patch::texel_index(p_blade, 0)];
	return { half_to_float(halves[0]), half_to_float(halves[1]) };
}

int choose(const SpeciesMix &p_mix, int p_x, int p_z, int p_blade, const MapLayers *p_layers = nullptr, uint32_t p_seed = 0) {
	const int start = int(grass_tile_start(uint32_t(p_x), uint32_t(p_z), p_seed));
	return p_mix.choose(p_x, p_z, p_blade, root_of(start + p_blade), p_layers);
}

// Shares of the species among all blades of the field.
std::vector<double> count(const SpeciesMix &p_mix) {
	std::vector<double> found(GRASS_MAX_SPECIES);
	for (int z = 0; z < GRID.get_tiles_z(); z++) {
		for (int x = 0; x < GRID.get_tiles_x(); x++) {
			for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				found[size_t(choose(p_mix, x, z, b))] += 1.0 / (double(GRID.get_tile_count()) * GRASS_BLADES_PER_TILE);
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
	MapLayers layers;
	layers.reset(GRID);
	layers.update(map, MapRegion::of_grid(GRID));
	return layers;
}

GrassSlot slot_of(int p_x, int p_z, int p_slot = 0) {
	GrassSlot slot;
	slot.tile = { p_x, p_z, GRID.get_index(p_x, p_z), p_slot };
	slot.list = { grass_tile_start(uint32_t(p_x), uint32_t(p_z), 0), 0, 0, GRASS_SLOT_FRESH | GRASS_SLOT_MAPPED };
	return slot;
}

} // namespace

TEST_CASE("species: the same blade is the same species every time, and another one in a field of another seed") {
	const SpeciesParams params[] = { { 0.5, 2.0, 0.5 }, { 0.5, 2.0, 0.5 } };
	const SpeciesMix one(params, GRID, 3), same(params, GRID, 3), other(params, GRID, 4);
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
			const SpeciesMix mix(params, GRID, 0);
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
		const SpeciesMix mix(params, GRID, 0);
		int alike = 0, pairs = 0;
		for (int z = 0; z < GRID.get_tiles_z(); z += 3) {
			for (int x = 0; x < GRID.get_tiles_x(); x += 3) {
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
	const SpeciesMix mix(params, GRID, 5);
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
				found[size_t(mix.choose(x, z, b, root, nullptr))] += 1.0 / (36 * 64);
			}
		}
	}
	for (size_t s = 0; s < 3; s++) {
		CHECK(std::abs(found[s] - expected[s]) < 0.04);
	}
}

TEST_CASE("species: what is painted grows there alone, and mixes with what is around it only along the border [Eq P3]") {
	const SpeciesParams params[] = { { 1.0, 4.0, 0.3 }, { 0.0, 4.0, 0.3 } };
	const SpeciesMix mix(params, GRID, 0);
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
		MapLayers layers;
		layers.reset(grid);
		layers.update(map, MapRegion::of_grid(grid));
		double sum = 0.0;
		int blades = 0;
		for (int z = 0; z < grid.get_tiles_z(); z++) {
			for (int x = 0; x < grid.get_tiles_x(); x++) {
				for (int b = 0; b<GRASS_BLADES_PER_TILE; b += density> 1000.0 ? 8 : 1) {
					const int start = int(grass_tile_start(uint32_t(x), uint32_t(z), 0));
					const Eigen::Vector2f root = root_of(start + b);
					const double place = (x + double(root.x()) - 0.5 * grid.get_tiles_x()) * grid.get_tile_size();
					const int species = mix.choose(x, z, b, root, &layers);
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
	CHECK(choose(SpeciesMix(one, GRID, 0), 3, 4, 5) == 0);
	const SpeciesParams none[] = { { 0.0 }, { 0.0 } };
	CHECK(count(SpeciesMix(none, GRID, 0))[0] == doctest::Approx(1.0));
	CHECK(SpeciesMix(none, GRID, 0).get_share(0) == 1.0);
	const std::vector<SpeciesParams> many(12);
	CHECK(SpeciesMix(many, GRID, 0).get_count() == GRASS_MAX_SPECIES);
	const double nan = std::nan("");
	const SpeciesParams bad[] = { { nan, nan, nan }, { -3.0, -1.0, 1e30 }, { 1e30, 1e30, -1.0 } };
	const SpeciesMix mix(bad, GRID, 0);
	CHECK(mix.get_share(0) + mix.get_share(1) + mix.get_share(2) == doctest::Approx(1.0));
	CHECK(mix.get_share(1) == 0.0);
	const std::vector<double> found = count(mix);
	CHECK(found[1] == 0.0);
	CHECK(found[0] > 0.2);
}

TEST_CASE("patches: joined ones stand one below the other, with the roots of the first") {
	const auto low = make_patch(0.4), high = make_patch(0.8, 7);
	const Patch &joined = *two_patches();
	CHECK(joined.species == 2);
	CHECK(joined.texels.size() == 2 * low->texels.size());
	CHECK(joined.max_length == high->max_length);
	CHECK(joined.max_height == std::max(low->max_height, high->max_height));
	CHECK(joined.mean_height == doctest::Approx(0.5 * (low->mean_height + high->mean_height)));
	int moved = 0;
	for (int b = 0; b < GRASS_PATCH_BLADES; b += 37) {
		const size_t own = Patch::texel_index(b, 0), in = Patch::texel_index(GRASS_PATCH_BLADES + b, 0);
		CHECK(joined.texels[in] == low->texels[own]);
		CHECK(joined.texels[in + 1] == low->texels[own + 1]);
		CHECK(joined.texels[in + 2] == high->texels[own + 2]);
		moved += low->texels[own] != high->texels[own];
		CHECK(joined.texels[in + 3] == high->texels[own + 3]);
		for (int k = 1; k < GRASS_KNOTS; k++) {
			for (size_t c = 0; c < 4; c++) {
				CHECK(joined.texels[Patch::texel_index(GRASS_PATCH_BLADES + b, k) + c] == high->texels[Patch::texel_index(b, k) + c]);
			}
		}
	}
	CHECK(moved > 100);
}

TEST_CASE("patches: a species without blades takes room, but has no width; without any blades there is no patch") {
	const auto bare = make_patch(0.0), grass = make_patch(0.5);
	const std::shared_ptr<const Patch> some[] = { bare, grass }, no[] = { bare, bare };
	const double shares[] = { 0.5, 0.5 };
	const Patch joined = join_patches(some, shares);
	CHECK_FALSE(joined.is_empty());
	CHECK(joined.texels[Patch::texel_index(5, 0) + 3] == 0);
	CHECK(joined.texels[Patch::texel_index(GRASS_PATCH_BLADES + 5, 0) + 3] == grass->texels[Patch::texel_index(5, 0) + 3]);
	CHECK(joined.texels[Patch::texel_index(5, 0)] == grass->texels[Patch::texel_index(5, 0)]);
	CHECK(join_patches(no, shares).is_empty());
	CHECK(join_patches({}, {}).is_empty());
}

TEST_CASE("tile_bounds: a tile's box holds the blades of whichever species they are") {
	const std::shared_ptr<const Patch> patches[] = { make_patch(0.3), make_patch(1.2) };
	const double shares[] = { 0.9, 0.1 };
	const TileBounds small(*patches[0], GRID, ClumpParams(), 0), tall(*patches[1], GRID, ClumpParams(), 0),
			both(join_patches(patches, shares), GRID, ClumpParams(), 0);
	CHECK(both.get_height() == tall.get_height());
	CHECK(both.get_overhang() >= small.get_overhang());
	CHECK(both.get_overhang() == doctest::Approx(tall.get_overhang()).epsilon(0.02));
}

TEST_CASE("field_blades: an awake tile of two species stands at rest as its blades grow") {
	const SpeciesParams params[] = { { 0.5, 4.0, 0.0 }, { 0.5, 4.0, 0.0 } };
	const auto mix = std::make_shared<const SpeciesMix>(params, GRID, 0);
	const FieldBlades blades(GRID, two_patches(), ClumpParams(), 0, mix, nullptr);
	CpuPool pool(two_patches(), 4);
	const GrassSlot slot = slot_of(33, 21);
	const SlotGrowth growth = blades.grow(slot);
	StepInput input;
	input.step.field = { float(GRID.get_tile_size()), float(GRID.get_tiles_x()), float(GRID.get_tiles_z()), float(GRASS_KNOTS) };
	input.slots = { &slot, 1 };
	input.growth = { &growth, 1 };
	pool.step(input);
	int second = 0;
	for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
		const FieldBlades::Pose pose = blades.get_pose(33, 21, b);
		CHECK(pose.species == int(growth.species[size_t(b)]));
		CHECK(pose.blade == int(slot.list.x) + b + GRASS_PATCH_BLADES * pose.species);
		second += pose.species;
		float length = 0.0f;
		for (int k = 0; k < GRASS_KNOTS; k++) {
			CHECK(pool.get_knots(0, b)[size_t(k)] == blades.get_rest_knot(pose, k));
			length += k == 0 ? 0.0f : (blades.get_rest_knot(pose, k) - blades.get_rest_knot(pose, k - 1)).norm();
		}
		CHECK(length / pose.clump.height == doctest::Approx(pose.species == 0 ? 0.4 : 0.8).epsilon(0.01));
	}
	CHECK(second > 16);
	CHECK(second < 48);
}

TEST_CASE("species: the tip of each species swings at its own frequency, whatever its blades are computed with") {
	constexpr double FREQUENCIES[] = { 1.2, 2.5 }; // Hz
	const SpeciesParams mixed[] = { { 0.5, 4.0, 0.0 }, { 0.5, 4.0, 0.0 } };
	const auto mix = std::make_shared<const SpeciesMix>(mixed, GRID, 0);
	PatchParams upright;
	upright.weights = { 1.0, 0.0, 0.0, 0.0 };
	const auto one = std::make_shared<const Patch>(generate_patch(upright));
	const std::shared_ptr<const Patch> patches[] = { one, one };
	const double shares[] = { 0.5, 0.5 };
	const auto patch = std::make_shared<const Patch>(join_patches(patches, shares));
	const FieldBlades blades(GRID, patch, ClumpParams{ 1.6f, 0.0f, 0.0f, 0.0f }, 0, mix, nullptr);
	for (const TileStep tile_step : { step_lanes, step_scalar_double }) {
		CpuPool pool(patch, 1);
		GrassSlot slot = slot_of(12, 12);
		const SlotGrowth growth = blades.grow(slot);
		StepClock clock;
		const auto step = [&](double p_push, double p_damping) {
			std::vector<GrassStep> steps;
			SolverParams params;
			params.damping_ratio = p_damping;
			clock.advance(params, 1.0 / 60.0);
			for (const double frequency : FREQUENCIES) {
				params.natural_frequency = frequency;
				params.load[0] = p_push * frequency * frequency;
				steps.push_back(clock.repeat(params));
			}
			StepInput input;
			input.step = steps[0];
			input.step.field = { float(GRID.get_tile_size()), float(GRID.get_tiles_x()), float(GRID.get_tiles_z()), float(GRASS_KNOTS) };
			input.slots = { &slot, 1 };
			input.species = steps;
			if (slot.list.w & GRASS_SLOT_FRESH) {
				input.growth = { &growth, 1 };
			}
			pool.step(input, serial_for, tile_step);
			slot.list.w &= ~uint32_t(GRASS_SLOT_FRESH);
		};
		const auto tip = [&](int p_blade) {
			const FieldBlades::Pose pose = blades.get_pose(12, 12, p_blade);
			return double((pool.get_knots(0, p_blade)[GRASS_KNOTS - 1] - blades.get_rest_knot(pose, GRASS_KNOTS - 1)).x());
		};
		for (int i = 0; i < 600; i++) {
			step(0.4, 0.7);
		}
		std::vector<double> before(GRASS_BLADES_PER_TILE), first(GRASS_BLADES_PER_TILE), last(GRASS_BLADES_PER_TILE);
		std::vector<int> crossings(GRASS_BLADES_PER_TILE);
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			before[size_t(b)] = tip(b);
			CHECK(before[size_t(b)] > 0.001); // metres
		}
		for (int i = 1; i < 480; i++) {
			step(0.0, 0.0);
			for (size_t b = 0; b < GRASS_BLADES_PER_TILE; b++) {
				const double now = tip(int(b));
				if (now * before[b] < 0.0) {
					last[b] = (i - now / (now - before[b])) / 60.0;
					first[b] = crossings[b]++ == 0 ? last[b] : first[b];
				}
				before[b] = now;
			}
		}
		for (size_t b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			INFO("blade ", b, " of species ", int(growth.species[b]));
			CHECK(0.5 * (crossings[b] - 1) / (last[b] - first[b]) == doctest::Approx(FREQUENCIES[growth.species[b]]).epsilon(0.03));
		}
	}
}

TEST_CASE("step_clock: a step repeated for other parameters is the one that a clock of their own would have given") {
	StepClock one, own;
	SolverParams field, species;
	species.natural_frequency = 3.3;
	species.damping_ratio = 0.2;
	for (const double delta : { 1.0 / 60.0, 1.0 / 30.0, 1.0 / 144.0, 0.0, 1.0 / 60.0 }) {
		one.advance(field, delta);
		const GrassStep repeated = one.repeat(species), wanted = own.advance(species, delta);
		CHECK(repeated.pbd_motion == wanted.pbd_motion);
		CHECK(repeated.free_motion == wanted.free_motion);
		CHECK(repeated.load == wanted.load);
		CHECK(repeated.contact == wanted.contact);
		CHECK(repeated.chain == wanted.chain);
		CHECK(repeated.energy == wanted.energy);
	}
}
