// SPDX-License-Identifier: MIT
// A field of two species, for their tests.
#pragma once

#include "grown_tile.h"

#include "core/species/species.h"

namespace grass::test {

inline const TileGrid SPECIES_GRID = TileGrid::make(80.0, 80.0, 256.0); // 160 x 160 tiles of 0.5 m

inline std::shared_ptr<const Patch> make_patch(double p_length, uint32_t p_seed = 1) {
	PatchParams params;
	params.seed = p_seed;
	params.length_min = params.length_max = p_length;
	return std::make_shared<const Patch>(generate_patch(params));
}

inline std::shared_ptr<const Patch> two_patches() {
	static const auto joined = [] {
		const std::shared_ptr<const Patch> patches[] = { make_patch(0.4), make_patch(0.8, 7) };
		const double shares[] = { 0.5, 0.5 };
		return std::make_shared<const Patch>(join_patches(patches, shares));
	}();
	return joined;
}

} // namespace grass::test
