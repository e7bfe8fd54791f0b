// SPDX-License-Identifier: MIT
// Limits for a map that is read from external bytes. Texels can be packed into a thousandth: a file or a message of a megabyte could unpack
// to gigabytes.
#pragma once

#include "core/map/map_region.h"

#include <string>
#include <vector>

namespace grass {

struct ReadLimits {
	static constexpr size_t MEGABYTE = size_t(1) << 20;
	static constexpr size_t MAP_MEGABYTES = 1024; // all chunks that one field can show, with every channel in use, are 864 MB
	static constexpr size_t CHANGES_MEGABYTES = 64; // 3,900 chunks in which grass is cut

	size_t map_bytes = MAP_MEGABYTES * MEGABYTE; // texels of the whole map
	size_t changes_bytes = CHANGES_MEGABYTES * MEGABYTE; // texels that one message changes
	std::vector<MapRegion> regions; // chunks must overlap one of them; none: the map's whole reach
	std::string map_hint, changes_hint; // names the setting that raises a limit; ends a sentence

	bool allow(const MapKey &p_key) const;
};

// Returns "3 MB", rounded up.
std::string megabytes(size_t p_bytes);

} // namespace grass
