// SPDX-License-Identifier: MIT
#include "core/tile_bounds.h"

#include "core/half.h"
#include "core/hash.h"

#include <algorithm>
#include <cmath>

namespace grass {

TileBounds::TileBounds(const Patch &p_patch, const TileGrid &p_grid, const ClumpParams &p_clump, uint32_t p_seed) :
		_grid(p_grid), _seed(p_seed) {
	if (p_patch.is_empty()) {
		return;
	}
	// A clump makes blades taller by at most this factor and tilts them by at most this angle (tangent of its half is the
	// lean, on both axes at once): a knot moves by at most the chord.
	const float taller = 1.0f + p_clump.height * (CLUMP_TALLEST - 1.0f);
	const float half_tangent = std::sqrt(2.0f) * p_clump.lean * float(GRASS_CLUMP_LEAN);
	const float chord = 2.0f * half_tangent / std::sqrt(1.0f + half_tangent * half_tangent);

	std::vector<Box> blades(GRASS_PATCH_BLADES);
	for (int b = 0; b < GRASS_PATCH_BLADES; b++) {
		const auto half = [&](int p_knot, int p_component) {
			return half_to_float(p_patch.texels[Patch::texel_index(b, p_knot) + size_t(p_component)]);
		};
		Box box{ 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
		for (int k = 1; k < GRASS_KNOTS; k++) {
			const Eigen::Vector3f knot = taller * Eigen::Vector3f(half(k, 0), half(k, 1), half(k, 2));
			const float lean = chord * knot.norm();
			box = { std::min(box.min_x, knot.x() - lean), std::max(box.max_x, knot.x() + lean), std::min(box.min_z, knot.z() - lean),
				std::max(box.max_z, knot.z() + lean), std::max(box.height, knot.y() + lean) };
		}
		const float x = (half(0, 0) - 0.5f) * float(p_grid.get_tile_size()), z = (half(0, 1) - 0.5f) * float(p_grid.get_tile_size());
		blades[size_t(b)] = { box.min_x + x, box.max_x + x, box.min_z + z, box.max_z + z, box.height };
	}
	const double side = 0.5 * p_grid.get_tile_size();
	for (int start = 0; start < GRASS_START_COUNT; start++) {
		Box all = blades[size_t(start * GRASS_START_STRIDE)];
		for (int b = 1; b < GRASS_BLADES_PER_TILE; b++) {
			const Box &blade = blades[size_t(start * GRASS_START_STRIDE + b)];
			all = { std::min(all.min_x, blade.min_x), std::max(all.max_x, blade.max_x), std::min(all.min_z, blade.min_z),
				std::max(all.max_z, blade.max_z), std::max(all.height, blade.height) };
		}
		_boxes.push_back(all);
		_inner = start == 0 ? all
							: Box{ std::max(all.min_x, _inner.min_x), std::min(all.max_x, _inner.max_x), std::max(all.min_z, _inner.min_z),
								  std::min(all.max_z, _inner.max_z), std::min(all.height, _inner.height) };
		_reach = std::max({ _reach, all.max_x - side, all.max_z - side, -all.min_x - side, -all.min_z - side });
		_height = std::max(_height, double(all.height));
	}
}

bool TileBounds::meets(int p_x, int p_z, const Bounds &p_bounds) const {
	if (_boxes.empty() || p_bounds.max.y() < 0.0) {
		return false;
	}
	// Rounded once, after the difference: a few nanometres, on any field.
	const Eigen::Vector3d centre = _grid.get_centre(p_x, p_z);
	const Box box{ float(p_bounds.min.x() - centre.x()), float(p_bounds.max.x() - centre.x()), float(p_bounds.min.z() - centre.z()),
		float(p_bounds.max.z() - centre.z()), 0.0f };
	const float bottom = float(p_bounds.min.y());
	return _inner.meets(box, bottom) || _boxes[grass_tile_start(uint32_t(p_x), uint32_t(p_z), _seed) / GRASS_START_STRIDE].meets(box, bottom);
}

} // namespace grass
