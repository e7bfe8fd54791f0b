// SPDX-License-Identifier: MIT
// Which textures a terrain shows, one texel for each square metre that has been read. Fill rules query it.
#pragma once

#include "core/map/paint_map.h"

namespace grass {

struct TerrainTexel {
	static constexpr int FULL = 255;
	uint8_t base = 0, overlay = 0; // numbers of textures
	uint8_t blend = 0; // how much of the overlay is visible: 0 .. FULL

	// Converts shares and numbers as a terrain reports them. Values out of bounds are clamped; those that are not finite become 0.
	static TerrainTexel of(double p_base, double p_overlay, double p_blend);
	bool operator==(const TerrainTexel &) const = default;
};

class TerrainIds {
public:
	static constexpr int SIDE = info_of(MAP_GROUND).side; // texels along a chunk, as for its ground

	// Sets where its texels were read: where the heights of a map with this grid lie.
	void set_grid(const GroundGrid &p_grid) { _offset = p_grid.offset(); }
	// Sets texel i, j in the map's numbering of ground texels. Returns true if it changed.
	bool set(int p_i, int p_j, const TerrainTexel &p_texel);
	// Returns the texel at a place (x, z in metres); null where nothing has been read. Valid until the next set().
	const TerrainTexel *find(const Eigen::Vector2d &p_place) const;
	size_t get_memory_usage() const; // bytes

private:
	struct Chunk {
		std::vector<TerrainTexel> texels = std::vector<TerrainTexel>(size_t(SIDE) * size_t(SIDE));
		std::vector<bool> is_known = std::vector<bool>(size_t(SIDE) * size_t(SIDE));
	};
	std::map<MapKey, Chunk> _chunks;
	Eigen::Vector2d _offset = Eigen::Vector2d::Zero(); // metres from the centre of a texel
};

} // namespace grass
