// SPDX-License-Identifier: MIT
#include "core/blades/tussock.h"

#include "core/base/half.h"
#include "core/base/hash.h"

#include <algorithm>
#include <limits>

namespace grass {

namespace {

constexpr uint32_t SALT = 0x7455u;
// How much nearer to the middle of a tussock its blades are than they would be without it. Less: a tussock is thicker than grass can be.
constexpr float GATHERED = 0.35f;

Eigen::Vector2f root_in(const Patch &p_patch, int p_blade) {
	const uint16_t *texel = &p_patch.texels[Patch::texel_index(p_blade, 0)];
	return { half_to_float(texel[0]), half_to_float(texel[1]) };
}

// Returns the way from the blade's root to its tip, seen from above.
Eigen::Vector2f lean_of(const Patch &p_patch, int p_blade) {
	const uint16_t *texel = &p_patch.texels[Patch::texel_index(p_blade, GRASS_KNOTS - 1)];
	return { half_to_float(texel[0]), half_to_float(texel[2]) };
}

// Returns the nearest middle of a tussock. Any run of roots samples the tile evenly, so those of other blades are the middles: as many for
// each run of a tile's blades as there are tussocks in it.
Eigen::Vector2f middle_near(const Patch &p_even, int p_blade, const Eigen::Vector2f &p_root, int p_in_tile) {
	const int first = p_blade / GRASS_BLADES_PER_TILE * p_in_tile;
	Eigen::Vector2f nearest = p_root;
	float least = std::numeric_limits<float>::max();
	for (int n = first; n < first + p_in_tile; n++) {
		const Eigen::Vector2f middle = root_in(p_even, n);
		if (const float apart = (p_root - middle).squaredNorm(); apart < least) {
			least = apart;
			nearest = middle;
		}
	}
	return nearest;
}

bool is_inside(const Eigen::Vector2f &p_root) {
	return p_root.minCoeff() >= 0.0f && p_root.maxCoeff() < 1.0f;
}

} // namespace

void gather_roots(Patch &r_patch, int p_first, const Patch &p_even, const Tussocks &p_tussocks) {
	const int in_tile = std::max(GRASS_BLADES_PER_TILE / std::max(p_tussocks.blades, 1), 1);
	for (int blade = 0; blade < GRASS_PATCH_BLADES; blade++) {
		if (grass_hash(uint32_t(blade) ^ SALT) / 4294967296.0 >= p_tussocks.share) {
			continue;
		}
		const Eigen::Vector2f root = root_in(p_even, blade), middle = middle_near(p_even, blade, root, in_tile);
		const Eigen::Vector2f offset = GATHERED * (root - middle), lean = lean_of(r_patch, p_first + blade);
		// Blades hang out of the tussock: the root of each is on the side to which it leans. Roots stay in their tile.
		const Eigen::Vector2f outwards = middle + offset.norm() / std::max(lean.norm(), 1e-6f) * lean;
		const Eigen::Vector2f place = is_inside(outwards) ? outwards : middle + offset;
		uint16_t *texel = &r_patch.texels[Patch::texel_index(p_first + blade, 0)];
		texel[0] = float_to_half(place.x());
		texel[1] = float_to_half(place.y());
	}
}

} // namespace grass
