// SPDX-License-Identifier: MIT
#include "core/blades/patch.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <set>

#include "core/base/half.h"

using namespace grass;

namespace {

constexpr double PI = 3.14159265358979323846;

// Texel of the patch as floats.
Eigen::Vector4f texel(const Patch &p_patch, int p_blade, int p_knot) {
	const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_blade, p_knot)];
	return { half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]), half_to_float(halves[3]) };
}

Eigen::Vector3f knot(const Patch &p_patch, int p_blade, int p_knot) {
	return p_knot == 0 ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : Eigen::Vector3f(texel(p_patch, p_blade, p_knot).head<3>());
}

// FNV-1a of the patch's bytes, blade by blade, low byte first.
uint64_t digest(const Patch &p_patch) {
	uint64_t hash = 14695981039346656037ull;
	for (int i = 0; i < GRASS_PATCH_BLADES * GRASS_KNOTS * 4; i++) {
		const uint16_t half = p_patch.texels[Patch::texel_index(i / (4 * GRASS_KNOTS), i / 4 % GRASS_KNOTS) + size_t(i % 4)];
		hash = (hash ^ (half & 255u)) * 1099511628211ull;
		hash = (hash ^ uint64_t(half >> 8)) * 1099511628211ull;
	}
	return hash;
}

// Largest difference between the share of p_count roots in a box at the tile's corner and the box's area.
double discrepancy(const Patch &p_patch, int p_first, int p_count) {
	double worst = 0.0;
	for (double x = 0.1; x < 1.0; x += 0.1) {
		for (double z = 0.1; z < 1.0; z += 0.1) {
			int inside = 0;
			for (int i = 0; i < p_count; i++) {
				const Eigen::Vector4f root = texel(p_patch, p_first + i, 0);
				inside += root.x() < x && root.y() < z;
			}
			worst = std::max(worst, std::abs(inside / double(p_count) - x * z));
		}
	}
	return worst;
}

// Mean distance to the nearest root (tiles border on tiles: the square is a torus), relative to what a random
// sample of as many points has. 1 = random, 2 = a square grid.
double spacing(const Patch &p_patch, int p_first, int p_count) {
	double sum = 0.0;
	for (int i = 0; i < p_count; i++) {
		double nearest = 1.0;
		for (int j = 0; j < p_count; j++) {
			const Eigen::Vector4f away = texel(p_patch, p_first + i, 0) - texel(p_patch, p_first + j, 0);
			const double x = away.x() - std::round(away.x());
			const double z = away.y() - std::round(away.y());
			nearest = i == j ? nearest : std::min(nearest, std::hypot(x, z));
		}
		sum += nearest;
	}
	return sum / p_count * 2.0 * std::sqrt(double(p_count));
}

} // namespace

TEST_CASE("patch: fills the texture with blades within the lengths, widths and the tile") {
	const PatchParams params;
	const Patch patch = generate_patch(params);
	CHECK_FALSE(patch.is_empty());
	REQUIRE(patch.texels.size() == 1024u * 256u * 4u);
	double longest = 0.0;
	for (int blade = 0; blade < GRASS_PATCH_BLADES; blade++) {
		const Eigen::Vector4f root = texel(patch, blade, 0);
		const bool in_tile = root.x() >= 0.0f && root.x() <= 1.0f && root.y() >= 0.0f && root.y() <= 1.0f;
		const bool in_turn = std::abs(root.z()) <= 3.1416f + 0.002f;
		const bool in_width = root.w() >= 0.999 * params.width_min && root.w() <= 1.001 * params.width_max;
		double length = 0.0;
		for (int k = 1; k < GRASS_KNOTS; k++) {
			length += (knot(patch, blade, k) - knot(patch, blade, k - 1)).norm();
		}
		longest = std::max(longest, length);
		const bool in_length = length >= 0.99 * params.length_min && length <= 1.01 * params.length_max;
		REQUIRE((in_tile && in_turn && in_width && in_length));
	}
	CHECK(patch.max_length == doctest::Approx(longest));
	CHECK(patch.max_height < patch.max_length);
	CHECK(patch.max_spread < patch.max_length);
	CHECK(patch.mean_height < 0.8 * patch.max_height);
	CHECK(patch.mean_height > 0.5 * patch.max_height);
	CHECK(patch.max_height > 0.8 * patch.max_length);
	CHECK(patch.max_spread > 0.5 * patch.max_length);
}

TEST_CASE("patch: the clamp of a blade is as short as it should be, and its other segments are equal, knot 1 is above the root, no knot is "
		  "near the ground") {
	const Patch patch = generate_patch({});
	double lowest = 90.0;
	for (int blade = 0; blade < GRASS_PATCH_BLADES; blade++) {
		double shortest = 1.0, longest = 0.0;
		for (int k = 1; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3f here = knot(patch, blade, k);
			const double segment = (here - knot(patch, blade, k - 1)).norm() * (k == 1 ? 1.0 / GRASS_CLAMP_SEGMENTS : 1.0);
			shortest = std::min(shortest, segment);
			longest = std::max(longest, segment);
			lowest = std::min(lowest, std::atan2(double(here.y()), std::hypot(here.x(), here.z())) * 180.0 / PI);
		}
		// A half between 0.5 and 1 m is a multiple of 0.49 mm; both ends of a segment are rounded.
		REQUIRE(longest - shortest < 1e-3);
		REQUIRE(knot(patch, blade, 1).y() > 0.9 * GRASS_CLAMP_SEGMENTS * longest);
	}
	// The most that a clump tilts a blade, along both axes at once.
	const double tilt = 2.0 * std::atan(std::sqrt(2.0) * GRASS_CLUMP_LEAN) * 180.0 / PI;
	CHECK(lowest > tilt + 2.0);
}

TEST_CASE("patch: the same seed gives the same bits on every machine, another seed another patch") {
	PatchParams params;
	const uint64_t first = digest(generate_patch(params));
	CHECK(first == 12344608540799901271ull);
	CHECK(digest(generate_patch(params)) == first);
	params.seed = 2;
	CHECK(digest(generate_patch(params)) != first);
}

TEST_CASE("patch: any run of blades is an even sample of the tile") {
	const Patch patch = generate_patch({});
	// Random points reach 1.7 times the bounds in some of the 156 runs, and a spacing of 0.8.
	const int counts[] = { 8, 16, 32, 64 };
	const double bounds[] = { 0.37, 0.27, 0.21, 0.12 };
	for (int i = 0; i < 4; i++) {
		double worst = 0.0, closest = 2.0;
		for (int start = 0; start + 64 <= GRASS_PATCH_BLADES; start += 8 * 13) {
			worst = std::max(worst, discrepancy(patch, start, counts[i]));
			closest = std::min(closest, spacing(patch, start, counts[i]));
		}
		CAPTURE(counts[i]);
		CAPTURE(worst);
		CAPTURE(closest);
		CHECK(worst < bounds[i]);
		CHECK(closest > 1.2);
	}
}

TEST_CASE("patch: the blades that a thinned tile keeps are an even sample, however few") {
	const Patch patch = generate_patch({});
	int runs = 0;
	double deviations = 0.0; // of the share of roots in a half of the tile, over what chance gives
	double worst_spacing = 2.0;
	for (int count = 2; count <= GRASS_BLADES_PER_TILE; count++) {
		double spacings = 0.0;
		int starts = 0;
		for (int start = 0; start < GRASS_START_COUNT * GRASS_START_STRIDE; start += 25 * GRASS_START_STRIDE) {
			int left = 0, near = 0;
			for (int i = 0; i < count; i++) {
				const Eigen::Vector4f root = texel(patch, start + i, 0);
				left += root.x() < 0.5f;
				near += root.y() < 0.5f;
			}
			deviations += (std::pow(left - 0.5 * count, 2) + std::pow(near - 0.5 * count, 2)) / (0.25 * count);
			runs += 2;
			spacings += spacing(patch, start, count);
			starts++;
		}
		worst_spacing = std::min(worst_spacing, spacings / starts);
	}
	CAPTURE(worst_spacing);
	CHECK(deviations / runs < 0.25); // 1: random
	CHECK(worst_spacing > 1.35);
}

TEST_CASE("patch: roots have no rows in any direction") {
	const Patch patch = generate_patch({});
	// The power of waves across the tile, the mean of some tiles: 1 where roots are random, 64 where they stand in rows.
	double most = 0.0;
	for (int across = 0; across <= 16; across++) {
		for (int along = across > 0 ? -16 : 1; along <= 16; along++) {
			double power = 0.0;
			int tiles = 0;
			for (int first = 0; first + GRASS_BLADES_PER_TILE <= GRASS_PATCH_BLADES; first += 25 * GRASS_START_STRIDE) {
				std::complex<double> sum = 0.0;
				for (int i = 0; i < GRASS_BLADES_PER_TILE; i++) {
					const Eigen::Vector4f root = texel(patch, first + i, 0);
					sum += std::polar(1.0, 2.0 * PI * (across * double(root.x()) + along * double(root.y())));
				}
				power += std::norm(sum) / GRASS_BLADES_PER_TILE;
				tiles++;
			}
			most = std::max(most, power / tiles);
		}
	}
	CHECK(most < 4.0);
}

TEST_CASE("patch: the blades that thinned tiles keep are as long and as wide as all") {
	const Patch patch = generate_patch({});
	for (const int count : { 1, 2, 4, 8, 16, 32 }) {
		double width = 0.0, length = 0.0;
		for (int tile = 0; tile < GRASS_START_COUNT; tile++) {
			for (int i = 0; i < count; i++) {
				const int blade = tile * GRASS_START_STRIDE + i;
				width += texel(patch, blade, 0).w();
				for (int k = 1; k < GRASS_KNOTS; k++) {
					length += (knot(patch, blade, k) - knot(patch, blade, k - 1)).norm();
				}
			}
		}
		CAPTURE(count);
		CHECK(width / (count * GRASS_START_COUNT) == doctest::Approx(patch.mean_width).epsilon(0.02));
		CHECK(length / (count * GRASS_START_COUNT) == doctest::Approx(patch.mean_length).epsilon(0.02));
	}
}

TEST_CASE("patch: blades lean every way, and every type is there by its weight") {
	const Patch patch = generate_patch({});
	int quadrants[4] = {};
	for (int blade = 0; blade < GRASS_PATCH_BLADES; blade++) {
		const Eigen::Vector3f tip = knot(patch, blade, GRASS_SEGMENTS);
		quadrants[(tip.x() > 0.0f) + 2 * (tip.z() > 0.0f)]++;
	}
	for (const int count : quadrants) {
		CHECK(count == doctest::Approx(GRASS_PATCH_BLADES / 4).epsilon(0.03));
	}

	// The types differ in how much of their length is height.
	std::set<int> heights;
	for (size_t type = 0; type < BLADE_TYPES.size(); type++) {
		PatchParams only;
		only.weights.fill(0.0);
		only.weights[type] = 1.0;
		const Patch made = generate_patch(only);
		double height = 0.0;
		for (int blade = 0; blade < GRASS_PATCH_BLADES; blade++) {
			height += knot(made, blade, GRASS_SEGMENTS).y();
		}
		heights.insert(int(height / GRASS_PATCH_BLADES * 100.0));
	}
	CHECK(heights.size() == BLADE_TYPES.size());
}

TEST_CASE("patch: nothing to grow gives an empty patch that says why") {
	PatchParams params;
	params.weights.fill(0.0);
	Patch patch = generate_patch(params);
	CHECK(patch.is_empty());
	CHECK(patch.max_length == 0.0f);
	CHECK(patch.texels == std::vector<uint16_t>(1024u * 256u * 4u, 0));

	params = {};
	params.length_min = params.length_max = 0.0;
	patch = generate_patch(params);
	CHECK(patch.is_empty());
	CHECK(patch.max_height == 0.0f);
}

TEST_CASE("patch: bad parameters are brought within their ranges") {
	const double infinity = std::numeric_limits<double>::infinity();
	const double nan = std::numeric_limits<double>::quiet_NaN();
	PatchParams params;
	params.length_min = nan;
	params.length_max = infinity;
	params.width_min = -infinity;
	params.width_max = nan;
	params.weights = { nan, -1.0, infinity, 0.0 };
	Patch patch = generate_patch(params);
	CHECK_FALSE(patch.is_empty());
	CHECK(patch.max_length <= 1.01 * LENGTH_MAX.maximum);
	CHECK(std::none_of(patch.texels.begin(), patch.texels.end(), [](uint16_t p_half) { return (p_half & 0x7c00u) == 0x7c00u; }));

	params = {};
	params.length_min = 0.5;
	params.length_max = 0.1;
	patch = generate_patch(params);
	CHECK(patch.max_length == doctest::Approx(0.5).epsilon(0.01));

	params.length_min = params.length_max = 1e-6;
	CHECK(generate_patch(params).max_length == doctest::Approx(0.01).epsilon(0.01));
}

TEST_CASE("blade types: curves have length 1, start at the origin, and bend by the given factor") {
	for (const BladeType &type : BLADE_TYPES) {
		const BladeCurve curve = blade_curve(type, 1.0, 1.0);
		const BladeCurve stiff = blade_curve(type, 0.0, -1.0);
		CHECK(curve.knots[0].norm() == 0.0);
		for (int k = 1; k < GRASS_KNOTS; k++) {
			CHECK((curve.knots[k] - curve.knots[k - 1]).norm() == doctest::Approx(segment_share(k - 1)).epsilon(1e-9));
		}
		CHECK(curve.knots[GRASS_SEGMENTS].y() < 0.98);
		CHECK((stiff.knots[GRASS_SEGMENTS] - Eigen::Vector3d::UnitY()).norm() < 1e-9);
		CHECK(stiff.twist[GRASS_SEGMENTS] == -curve.twist[GRASS_SEGMENTS]);
	}
}
