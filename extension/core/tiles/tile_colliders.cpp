// SPDX-License-Identifier: MIT
#include "core/tiles/tile_colliders.h"

#include "core/bodies/collider.h"

namespace grass {

void TileColliders::clear() {
	_colliders.clear();
	_sharp.clear();
	_planes.clear();
}

uint32_t TileColliders::add(const ColliderShape &p_collider, const TileGrid &p_grid, double p_segment) {
	_colliders.push_back(p_collider.pack(p_grid, int(_planes.size())));
	_sharp.push_back(is_sharp(_colliders.back(), float(p_segment)));
	if (p_collider.type == GRASS_HULL) {
		_planes.insert(_planes.end(), p_collider.planes.begin(), p_collider.planes.end());
	}
	return uint32_t(_colliders.size() - 1);
}

size_t TileColliders::get_memory_usage() const {
	return _colliders.capacity() * sizeof(GrassCollider) + _sharp.capacity() + _planes.capacity() * sizeof(Eigen::Vector4f);
}

} // namespace grass
