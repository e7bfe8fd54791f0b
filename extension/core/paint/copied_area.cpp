// SPDX-License-Identifier: MIT
#include "core/paint/copied_area.h"

namespace grass {

namespace {

constexpr MapChannel PASTED[] = { MAP_DENSITY, MAP_HEIGHT, MAP_SPECIES, MAP_TINT, MAP_LEAN, MAP_WEAR, MAP_CUT, MAP_PAINT, MAP_WEAR_REST };

void paste_channel(const CopiedArea &p_area, MapChannel p_channel, const Eigen::Array2i &p_metres, const std::function<int(int)> &p_species,
		PaintMap &r_map) {
	const MapChannelInfo &info = info_of(p_channel);
	const Eigen::Array2i shift = p_metres * info.side / int(MAP_CHUNK_SIZE);
	const Eigen::Array2i low = ((p_area.middle - p_area.half).array() / info.texel_size()).floor().cast<int>();
	const Eigen::Array2i high = ((p_area.middle + p_area.half).array() / info.texel_size()).ceil().cast<int>();
	MapReader reader(p_area.map, p_channel);
	for (int j = low.y(); j < high.y(); j++) {
		for (int i = low.x(); i < high.x(); i++) {
			if (!p_area.contains(Eigen::Vector2d(i + 0.5, j + 0.5) * info.texel_size())) {
				continue;
			}
			for (int component = 0; component < info.components; component++) {
				const int32_t code = reader.code(component, i, j), pasted = p_channel == MAP_SPECIES ? p_species(code) : code;
				if (pasted >= 0) {
					(void)r_map.set_code(p_channel, component, i + shift.x(), j + shift.y(), pasted);
				}
			}
		}
	}
}

} // namespace

bool CopiedArea::contains(const Eigen::Vector2d &p_place) const {
	const Eigen::Array2d share = (p_place - middle).array() / half.array();
	return is_round ? share.matrix().squaredNorm() <= 1.0 : (share.abs() <= 1.0).all();
}

void paste_area(const CopiedArea &p_area, const Eigen::Vector2d &p_middle, const std::function<int(int)> &p_species, PaintMap &r_map) {
	static_assert(int(MAP_CHUNK_SIZE) == MAP_CHUNK_SIZE);
	const Eigen::Array2i metres = (p_middle - p_area.middle).array().round().cast<int>();
	for (const MapChannel channel : PASTED) {
		paste_channel(p_area, channel, metres, p_species, r_map);
	}
	r_map.compact();
}

} // namespace grass
