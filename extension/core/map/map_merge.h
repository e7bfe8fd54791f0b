// SPDX-License-Identifier: MIT
// Merges two maps that were made from the same one, texel by texel: each texel comes from the map that changed it.
#pragma once

#include "core/map/read_limits.h"

#include <string>

namespace grass {

// Texels of a chunk that both changed, to different codes.
struct MergeConflict {
	MapKey key;
	MapChannel channel = MAP_DENSITY;
	size_t texels = 0;
	MapRegion region; // the rectangle around them, metres
};

struct MapMerge {
	std::string reason; // why they were not merged, as the end of a sentence; "": they were
	std::vector<MapKey> changed; // chunks, ascending
	size_t texels = 0; // taken from theirs
	bool has_base_changed = false; // the density where nothing was painted, or where the heights of the ground lie
	bool is_base_in_conflict = false; // the density
	std::vector<MergeConflict> conflicts; // rising by chunk and channel
};

// Brings the changes from p_base to p_theirs into r_mine, or leaves it as it was. What both changed differently stays as it is in mine, or
// becomes theirs. Undo works in this way, too: it brings the changes from after a step to before it into the map as others have changed it
// since.
MapMerge merge_maps(
		const PaintMap &p_base, const PaintMap &p_theirs, PaintMap &r_mine, bool p_prefers_theirs = false, const ReadLimits &p_limits = {});

} // namespace grass
