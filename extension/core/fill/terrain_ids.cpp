// SPDX-License-Identifier: MIT
#include "core/fill/terrain_ids.h"

#include <algorithm>
#include <cmath>

namespace grass {

namespace {

constexpr int LAST = TerrainIds::SIDE - 1; // also masks a texel's position within its chunk
static_assert((TerrainIds::SIDE & LAST) == 0);

uint8_t to_number(double p_value) {
	return std::isfinite(p_value) ? uint8_t(std::clamp(std::round(p_value), 0.0, 255.0)) : uint8_t(0);
}

size_t id_index(int p_i, int p_j) {
	return size_t(p_j & LAST) * size_t(TerrainIds::SIDE) + size_t(p_i & LAST);
}

} // namespace

TerrainTexel TerrainTexel::of(double p_base, double p_overlay, double p_blend) {
	return { to_number(p_base), to_number(p_overlay), to_number(p_blend * FULL) };
}

bool TerrainIds::set(int p_i, int p_j, const TerrainTexel &p_texel) {
	Chunk &chunk = _chunks[key_of(MAP_GROUND, p_i, p_j)];
	const size_t index = id_index(p_i, p_j);
	const bool differs = !chunk.is_known[index] || !(chunk.texels[index] == p_texel);
	chunk.texels[index] = p_texel;
	chunk.is_known[index] = true;
	return differs;
}

const TerrainTexel *TerrainIds::find(const Eigen::Vector2d &p_place) const {
	const Eigen::Vector2d place = p_place - _offset;
	const auto found = _chunks.find(key_at(place));
	if (found == _chunks.end()) {
		return nullptr;
	}
	const Eigen::Array2i texel = (place.array() / info_of(MAP_GROUND).texel_size()).floor().cast<int>();
	const size_t index = id_index(texel.x(), texel.y());
	return found->second.is_known[index] ? &found->second.texels[index] : nullptr;
}

size_t TerrainIds::get_memory_usage() const {
	return _chunks.size() * size_t(SIDE) * size_t(SIDE) * (sizeof(TerrainTexel) + 1);
}

} // namespace grass
