// SPDX-License-Identifier: MIT
// A mesh whose vertices hold the density of the grass below them, rendered into each chunk.
#pragma once

#include "core/map/paint_map.h"

namespace grass {

class FillMesh {
public:
	struct Corner {
		Eigen::Vector3d at; // metres: x, z from the field's centre, y above the field
		double share; // 0: nothing grows .. 1: everything

		bool operator==(const Corner &) const = default;
	};
	static constexpr double MAX_POSITION = 1e6; // metres; triangles that reach farther are left out

	void add(const Corner &p_a, const Corner &p_b, const Corner &p_c);
	bool operator==(const FillMesh &p_other) const { return _triangles == p_other._triangles; }
	int64_t get_triangle_count() const { return int64_t(_triangles.size()); }

	// Returns for each texel of density of a chunk, row by row, the share of the highest triangle above or below the texel's centre,
	// interpolated between its corners; 0 where there is no triangle.
	std::vector<double> get_shares(const MapKey &p_key) const;

private:
	using Triangle = std::array<Corner, 3>;

	std::vector<Triangle> _triangles;
	std::map<MapKey, std::vector<size_t>> _by_chunk; // triangles that may overlap the chunk
};

} // namespace grass
