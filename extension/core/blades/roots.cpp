// SPDX-License-Identifier: MIT
#include "core/blades/roots.h"

#include "core/base/hash.h"

#include <algorithm>

namespace grass {

namespace {

// The R2 sequence (Roberts 2018): any run of its points samples the square evenly. But they are a lattice, the same in each tile, and rows
// would be seen across a lawn. So a root lies anywhere in a square around its point: its side is somewhat more than the distance between
// 64 points. By chance alone roots would then be as close as random ones. So each takes the best of some places.
constexpr double R2_X = 0.7548776662466927, R2_Z = 0.5698402909980532;
constexpr double ROOT_JITTER = 0.15;
constexpr uint32_t ROOT_PLACES = 8;
constexpr uint32_t ROOTS_SALT = 0x526f6f74u;

double random_share(uint32_t p_seed) {
	return grass_hash(p_seed) / 4294967296.0;
}

// Returns how far a place is from the roots before it. The root that is n before it counts by what runs of n + 1 roots have room for.
// p_enough: a result below it may be too large.
double room_at(const std::vector<Eigen::Vector2d> &p_roots, const Eigen::Vector2d &p_place, double p_enough) {
	double least = 1.0;
	const size_t before = std::min(p_roots.size(), size_t(GRASS_BLADES_PER_TILE - 1));
	for (size_t n = 1; n <= before && least > p_enough; n++) {
		const Eigen::Vector2d away = p_place - p_roots[p_roots.size() - n];
		least = std::min(least, double(n + 1) * (away - away.array().round().matrix()).squaredNorm());
	}
	return least;
}

} // namespace

std::vector<Eigen::Vector2d> scatter_roots(uint32_t p_seed, int p_count) {
	std::vector<Eigen::Vector2d> roots;
	roots.reserve(size_t(p_count));
	for (int blade = 0; blade < p_count; blade++) {
		const uint32_t base = grass_hash(p_seed ^ ROOTS_SALT ^ grass_hash(uint32_t(blade)));
		Eigen::Vector2d root = Eigen::Vector2d::Zero();
		double most = -1.0;
		for (uint32_t n = 0; n < ROOT_PLACES; n++) {
			const Eigen::Vector2d jitter(random_share(base + 2 * n) - 0.5, random_share(base + 2 * n + 1) - 0.5);
			Eigen::Vector2d place = (Eigen::Vector2d(R2_X, R2_Z) * blade + ROOT_JITTER * jitter).array() + 0.5;
			place -= place.array().floor().matrix();
			if (const double room = room_at(roots, place, most); room > most) {
				most = room;
				root = place;
			}
		}
		roots.push_back(root);
	}
	return roots;
}

} // namespace grass
