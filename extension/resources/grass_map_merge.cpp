// SPDX-License-Identifier: MIT
// Merging the work of two people on one GrassMap.
#include "core/map/map_merge.h"

#include "resources/grass_map.h"
#include "resources/size_limits.h"
#include "shared/convert.h"
#include "shared/text.h"

#include <godot_cpp/variant/array.hpp>

using namespace godot;

namespace grass {

Dictionary GrassMap::merge(const Ref<GrassMap> &p_base, const Ref<GrassMap> &p_theirs, bool p_prefers_theirs) {
	ERR_FAIL_COND_V_MSG(p_base.is_null() || p_theirs.is_null(), Dictionary(),
			vformat("%s: merge() needs two maps: the one that both began with, and theirs.", label()));
	const PaintMap base = p_base->copy(), theirs = p_theirs->copy();
	const ReadLimits limits = get_read_limits();
	MapMerge merge;
	if (!write([&] { merge = merge_maps(base, theirs, _map, p_prefers_theirs, limits); })) {
		return {};
	}
	ERR_FAIL_COND_V_MSG(!merge.reason.empty(), Dictionary(), vformat("%s: the merged map %s.", label(), text_of(merge.reason)));
	Array conflicts;
	for (const MergeConflict &conflict : merge.conflicts) {
		Dictionary entry;
		entry["channel"] = int64_t(conflict.channel);
		entry["texels"] = int64_t(conflict.texels);
		entry["region"] = Rect2(to_godot(conflict.region.min), to_godot(Eigen::Vector2d(conflict.region.max - conflict.region.min)));
		conflicts.push_back(entry);
	}
	Dictionary report;
	report["texels"] = int64_t(merge.texels);
	report["conflicts"] = conflicts;
	report["base_density_conflict"] = merge.is_base_in_conflict;
	tell(merge.changed, merge.has_base_changed);
	return report;
}

} // namespace grass
