// SPDX-License-Identifier: MIT
#include "core/tiles/tile_bounds.h"

#include "core/base/half.h"
#include "core/base/hash.h"

#include <cmath>
#include <limits>

namespace grass {

struct TileBounds::Blade {
	Box box;
	float x, z;
};

// Extends a box by a blade. p_taller: factor on the blade's length; p_chord: how far it is tilted, as a share of a knot's distance from the
// root.
void TileBounds::extend(Box &r_box, const Patch &p_patch, int p_blade, float p_taller, float p_chord) {
	for (int k = 1; k < GRASS_KNOTS; k++) {
		const uint16_t *halves = &p_patch.texels[Patch::texel_index(p_blade, k)];
		const Eigen::Vector3f knot =
				p_taller * Eigen::Vector3f(half_to_float(halves[0]), half_to_float(halves[1]), half_to_float(halves[2]));
		const float lean = p_chord * knot.norm();
		r_box = { std::min(r_box.min_x, knot.x() - lean), std::max(r_box.max_x, knot.x() + lean), std::min(r_box.min_z, knot.z() - lean),
			std::max(r_box.max_z, knot.z() + lean), std::max(r_box.height, knot.y() + lean) };
	}
}

TileBounds::TileBounds(const Patch &p_patch, const TileGrid &p_grid, const ClumpParams &p_clump, uint32_t p_seed) :
		_grid(p_grid), _seed(p_seed) {
	if (p_patch.is_empty()) {
		return;
	}
	// A clump makes blades taller by at most this factor and tilts them by at most this angle (the tangent of half the angle is the lean,
	// on both axes at once): a knot moves by at most the chord.
	const float taller = 1.0f + p_clump.height * (CLUMP_TALLEST - 1.0f);
	const float half_tangent = std::sqrt(2.0f) * p_clump.lean * float(GRASS_CLUMP_LEAN);
	const float chord = 2.0f * half_tangent / std::sqrt(1.0f + half_tangent * half_tangent);

	auto blades = std::make_shared<std::vector<Blade>>(GRASS_PATCH_BLADES);
	for (int b = 0; b < GRASS_PATCH_BLADES; b++) {
		Box box{ 0.0f, 0.0f, 0.0f, 0.0f, 0.0f };
		for (int species = 0; species < p_patch.species; species++) { // of any species, since it is not known which one grows
			extend(box, p_patch, species * GRASS_PATCH_BLADES + b, taller, chord);
		}
		const uint16_t *root = &p_patch.texels[Patch::texel_index(b, 0)];
		(*blades)[size_t(b)] = { box, half_to_float(root[0]), half_to_float(root[1]) };
	}
	_blades = blades;
	find_boxes();
}

TileBounds::TileBounds(const TileBounds &p_other, const TileGrid &p_grid) : TileBounds(p_other) {
	const bool is_same_size = p_grid.get_tile_size() == _grid.get_tile_size();
	_grid = p_grid;
	if (_blades && !is_same_size) {
		find_boxes();
	}
}

void TileBounds::find_boxes() {
	const float size = float(_grid.get_tile_size());
	const double side = 0.5 * _grid.get_tile_size();
	_boxes.clear();
	_overhang = _height = 0.0;
	for (int start = 0; start < GRASS_START_COUNT; start++) {
		const float huge = std::numeric_limits<float>::max();
		Box all{ huge, -huge, huge, -huge, 0.0f };
		for (int b = 0; b < GRASS_BLADES_PER_TILE; b++) {
			const Blade &blade = (*_blades)[size_t(start * GRASS_START_STRIDE + b)];
			const float x = (blade.x - 0.5f) * size, z = (blade.z - 0.5f) * size;
			all = { std::min(all.min_x, blade.box.min_x + x), std::max(all.max_x, blade.box.max_x + x),
				std::min(all.min_z, blade.box.min_z + z), std::max(all.max_z, blade.box.max_z + z),
				std::max(all.height, blade.box.height) };
		}
		_boxes.push_back(all);
		_overhang = std::max({ _overhang, all.max_x - side, all.max_z - side, -all.min_x - side, -all.min_z - side });
		_height = std::max(_height, double(all.height));
	}
}

size_t TileBounds::get_memory_usage() const {
	return (_blades ? _blades->capacity() * sizeof(Blade) : 0) + _boxes.capacity() * sizeof(Box);
}

bool TileBounds::meets(int p_x, int p_z, const Bounds &p_bounds) const {
	Tile tile{ uint16_t(p_x), uint16_t(p_z) };
	return keep_met(&tile, 1, p_bounds) > 0;
}

void TileBounds::prefetch() const {
#ifdef __GNUC__
	const char *const bytes = reinterpret_cast<const char *>(_boxes.data());
	for (size_t i = 0; i < _boxes.size() * sizeof(Box); i += 64) { // a cache line
		__builtin_prefetch(bytes + i);
	}
#endif
}

} // namespace grass
