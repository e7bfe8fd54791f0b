// SPDX-License-Identifier: MIT
#include "core/lod/lod.h"

namespace grass {

namespace {

using glsl::GRASS_BLADES_OF, glsl::GRASS_SEGMENTS_OF;

// Checks what grass_lod_level() requires of the levels from p_first to p_end: the first level of each segment count has all blades, segment
// counts descend, and within one segment count so do blades.
consteval bool are_ordered(int p_first, int p_end) {
	for (int i = p_first; i < p_end; i++) {
		const bool begins = i == p_first || GRASS_SEGMENTS_OF[i] < GRASS_SEGMENTS_OF[i - 1];
		const bool thinner = !begins && GRASS_SEGMENTS_OF[i] == GRASS_SEGMENTS_OF[i - 1] && GRASS_BLADES_OF[i] < GRASS_BLADES_OF[i - 1];
		if (!(begins && GRASS_BLADES_OF[i] == GRASS_BLADES_PER_TILE) && !thinner) {
			return false;
		}
	}
	return true;
}
// An array of a given length is padded with zeros if its list is too short.
static_assert(GRASS_SEGMENTS_OF[GRASS_ALL_LEVELS - 1] > 0 && GRASS_BLADES_OF[GRASS_ALL_LEVELS - 1] > 0);
static_assert(are_ordered(0, GRASS_LOD_LEVELS) && are_ordered(GRASS_LOD_LEVELS, GRASS_ALL_LEVELS));
static_assert(GRASS_ALL_LEVELS <= GRASS_CULL_GROUP, "a thread of a workgroup counts each level");
static_assert(GRASS_TURNS == GRASS_CULL_GROUP, "a thread of a workgroup counts each turn");

// Returns p_value, at least p_min; NaN becomes p_min.
float at_least(float p_value, float p_min) {
	return p_value > p_min ? p_value : p_min;
}

} // namespace

LodParams LodParams::sanitised() const {
	return { at_least(far, 0.001f), at_least(error, 0.0f), at_least(pixels_min, 0.0f), at_least(shadow_coarseness, 1.0f), is_carried };
}

LodParams LodParams::of_shadows(float p_distance, float p_reach) const {
	LodParams params = *this;
	params.error *= shadow_coarseness * GRASS_SHADOW_ANGULAR;
	params.pixels_min *= grass_lod_shadow(shadow_coarseness, p_distance, p_reach);
	return params;
}

void LodNeed::add(const LodParams &p_params, const BladeSize &p_size, float p_distance, float p_near, float p_pixel, float p_in_sight) {
	const float by_distance = grass_lod_blades(p_distance, p_near, p_params.far);
	const float by_width = grass_lod_blades_of_width(p_size.width, p_params.pixels_min * p_pixel);
	const float all = std::min(by_distance, by_width);
	blades = std::max(blades, all * p_in_sight);
	covering = std::max(covering, all);
	segments = std::max(segments, grass_lod_needed(p_size.length, p_params.error * p_pixel));
}

LodLevel get_lod_level(int p_level) {
	return { GRASS_BLADES_OF[p_level], GRASS_SEGMENTS_OF[p_level] };
}

uint32_t grass_lod_ranks(const std::array<uint32_t, GRASS_RANKS> &p_tiles, uint32_t p_room) {
	uint32_t ranks = 0, tiles = 0;
	while (ranks < uint32_t(GRASS_RANKS) && tiles + p_tiles[ranks] <= p_room) {
		tiles += p_tiles[ranks++];
	}
	return ranks;
}

bool grass_tile_visible(const Frustum &p_planes, const Eigen::Vector3f &p_centre, const Eigen::Vector3f &p_half_extents, float p_margin,
		const Eigen::Vector3f &p_fall) {
	glsl::vec4 planes[6];
	std::transform(p_planes.begin(), p_planes.end(), planes, [](const Eigen::Vector4f &p_plane) { return to_glsl(p_plane); });
	return glsl::grass_tile_visible(planes, to_glsl(p_centre), to_glsl(p_half_extents), p_margin, to_glsl(p_fall));
}

} // namespace grass
