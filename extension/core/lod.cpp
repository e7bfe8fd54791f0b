// SPDX-License-Identifier: MIT
#include "core/lod.h"

#include <algorithm>

namespace grass {

namespace {

constexpr int LOD_BLADES[] = GRASS_LOD_BLADES;
constexpr int LOD_SEGMENTS[] = GRASS_LOD_SEGMENTS;

// What grass_lod_level() takes for granted of the levels.
static_assert(std::size(LOD_BLADES) == GRASS_LOD_LEVELS && std::size(LOD_SEGMENTS) == GRASS_LOD_LEVELS && GRASS_LOD_LEVELS == 5);
static_assert(LOD_BLADES[0] == GRASS_BLADES_PER_TILE && LOD_BLADES[2] == GRASS_BLADES_PER_TILE);
static_assert(LOD_BLADES[3] == 32 && LOD_BLADES[4] == 16);

// At least p_min; NaN becomes p_min too.
float at_least(float p_value, float p_min) {
	return p_value > p_min ? p_value : p_min;
}

} // namespace

LodParams LodParams::sanitised() const {
	LodParams params;
	params.near = at_least(near, 0.0f);
	params.far = at_least(far, 0.001f);
	params.fine = at_least(fine, 0.0f);
	params.medium = at_least(medium, params.fine);
	return params;
}

LodLevel get_lod_level(int p_level) {
	return { LOD_BLADES[p_level], LOD_SEGMENTS[p_level] };
}

float grass_lod_blades(float p_distance, float p_near, float p_far) {
	const float share = 1.0f - 7.0f * (p_distance - p_near) / (8.0f * p_far);
	return std::clamp(share, 0.125f, 1.0f) * float(GRASS_BLADES_PER_TILE);
}

int grass_lod_level(float p_blades, float p_distance, float p_fine, float p_medium) {
	if (p_blades <= 16.0f) {
		return 4;
	}
	if (p_blades <= 32.0f) {
		return 3;
	}
	return p_distance < p_fine ? 0 : (p_distance < p_medium ? 1 : 2);
}

bool grass_tile_visible(const Frustum &p_planes, const Eigen::Vector3f &p_centre, const Eigen::Vector3f &p_half_extents, float p_margin) {
	for (const Eigen::Vector4f &plane : p_planes) {
		const Eigen::Vector3f normal = plane.head<3>();
		const float nearest = normal.dot(p_centre) - normal.cwiseAbs().dot(p_half_extents);
		if (nearest > plane.w() + p_margin) {
			return false;
		}
	}
	return true;
}

} // namespace grass
