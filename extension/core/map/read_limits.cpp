// SPDX-License-Identifier: MIT
#include "core/map/read_limits.h"

#include <algorithm>

namespace grass {

bool ReadLimits::allow(const MapKey &p_key) const {
	const MapRegion chunk = MapRegion::of_chunk(p_key);
	return PaintMap::is_in_reach(p_key) && (regions.empty() || std::any_of(regions.begin(), regions.end(), [&](const MapRegion &p_region) {
		return chunk.shared(p_region).has_area();
	}));
}

std::string megabytes(size_t p_bytes) {
	return std::to_string((p_bytes + ReadLimits::MEGABYTE - 1) / ReadLimits::MEGABYTE) + " MB";
}

} // namespace grass
