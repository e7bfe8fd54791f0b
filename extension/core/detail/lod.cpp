// SPDX-License-Identifier: MIT
#include "core/detail/lod.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

constexpr int SEGMENTS_OF[] = GRASS_LEVEL_SEGMENTS;
constexpr int BLADES_OF[] = GRASS_LEVEL_BLADES;
constexpr float ALL_BLADES = float(GRASS_BLADES_PER_TILE);

// What grass_lod_level() takes for granted of the levels from p_first to p_end: the first holds all blades, each order of
// segments begins with a mesh that does, and segments fall, then blades.
consteval bool are_ordered(int p_first, int p_end) {
	for (int i = p_first; i < p_end; i++) {
		const bool begins = i == p_first || SEGMENTS_OF[i] < SEGMENTS_OF[i - 1];
		const bool thinner = !begins && SEGMENTS_OF[i] == SEGMENTS_OF[i - 1] && BLADES_OF[i] < BLADES_OF[i - 1];
		if (!(begins && BLADES_OF[i] == GRASS_BLADES_PER_TILE) && !thinner) {
			return false;
		}
	}
	return true;
}
static_assert(std::size(SEGMENTS_OF) == GRASS_ALL_LEVELS && std::size(BLADES_OF) == GRASS_ALL_LEVELS);
static_assert(are_ordered(0, GRASS_LOD_LEVELS) && are_ordered(GRASS_LOD_LEVELS, GRASS_ALL_LEVELS));
static_assert(GRASS_ALL_LEVELS <= GRASS_CULL_GROUP, "a thread of a workgroup counts each level");
static_assert(GRASS_TURNS == GRASS_CULL_GROUP, "a thread of a workgroup counts each turn");

// At least p_min; NaN becomes p_min too.
float at_least(float p_value, float p_min) {
	return p_value > p_min ? p_value : p_min;
}

} // namespace

LodParams LodParams::sanitised() const {
	return { at_least(far, 0.001f), at_least(error, 0.0f), at_least(pixels_min, 0.0f), at_least(shadow_coarseness, 1.0f) };
}

void LodNeed::add(const LodParams &p_params, const BladeSize &p_size, float p_distance, float p_near, float p_pixel) {
	const float by_distance = grass_lod_blades(p_distance, p_near, p_params.far);
	const float by_width = grass_lod_blades_of_width(p_size.width, p_params.pixels_min * p_pixel);
	blades = std::max(blades, std::min(by_distance, by_width));
	segments = std::max(segments, grass_lod_needed(p_size.length, p_params.error * p_pixel));
}

LodLevel get_lod_level(int p_level) {
	return { BLADES_OF[p_level], SEGMENTS_OF[p_level] };
}

float grass_lod_blades(float p_distance, float p_near, float p_far) {
	const float share = 1.0f - 7.0f * (p_distance - p_near) / (8.0f * p_far);
	return std::clamp(share, 0.125f, 1.0f) * ALL_BLADES;
}

float grass_lod_blades_of_width(float p_width, float p_least) {
	const float share = float(GRASS_LOD_FACING) * p_width / std::max(p_least, 1e-9f);
	return std::clamp(share * ALL_BLADES, 1.0f, ALL_BLADES);
}

float grass_lod_shown(float p_blades, float p_hash) {
	const float room = std::min(ALL_BLADES - p_blades, p_blades - 1.0f);
	return p_blades + (p_hash - 0.5f) * std::clamp(room, 0.0f, 1.0f);
}

float grass_lod_needed(float p_length, float p_error) {
	return std::sqrt(float(GRASS_LOD_BEND) * p_length / std::max(p_error, 1e-9f));
}

int grass_lod_segments(float p_needed) {
	return p_needed > 7.0f ? 15 : (p_needed > 5.0f ? 7 : (p_needed > 3.0f ? 5 : (p_needed > 2.0f ? 3 : (p_needed > 1.0f ? 2 : 1))));
}

int grass_lod_coarser(int p_segments) {
	return p_segments > 7 ? 7 : (p_segments > 5 ? 5 : (p_segments > 3 ? 3 : (p_segments > 2 ? 2 : 1)));
}

float grass_lod_morph(float p_needed, int p_segments) {
	const float coarser = float(grass_lod_coarser(p_segments)), begin = std::min(1.5f * coarser, float(p_segments));
	return p_segments == 1 ? 0.0f : std::clamp((begin - p_needed) / (begin - coarser), 0.0f, 1.0f);
}

int grass_lod_level(float p_blades, int p_segments, int p_first, int p_end) {
	int level = p_first;
	for (int i = p_first; i < p_end; i++) {
		level = SEGMENTS_OF[i] >= p_segments && float(BLADES_OF[i]) >= p_blades ? i : level;
	}
	return level;
}

uint32_t grass_lod_rank(int p_level, uint32_t p_turn) {
	return p_turn + (SEGMENTS_OF[p_level] == 1 ? uint32_t(GRASS_TURNS) : 0u);
}

float grass_lod_left_out(uint32_t p_ranks) {
	return std::clamp(2.0f - float(p_ranks) / float(GRASS_TURNS), 0.0f, float(GRASS_LEFT_OUT_WIDENED));
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
	for (const Eigen::Vector4f &plane : p_planes) {
		const Eigen::Vector3f normal = plane.head<3>();
		const float nearest = normal.dot(p_centre) - normal.cwiseAbs().dot(p_half_extents) + std::min(normal.dot(p_fall), 0.0f);
		if (nearest > plane.w() + p_margin) {
			return false;
		}
	}
	return true;
}

} // namespace grass
