// SPDX-License-Identifier: MIT
#include "resources/map_exchange.h"

#include "core/map/map_changes.h"
#include "core/map/map_merge.h"
#include "resources/grass_map_file.h"
#include "resources/size_limits.h"
#include "shared/convert.h"
#include "shared/text.h"

#include <godot_cpp/variant/array.hpp>

using namespace godot;

namespace grass {

PackedByteArray find_changes(const GrassMap &p_map, const Ref<GrassMapSnapshot> &p_snapshot) {
	ERR_FAIL_COND_V_MSG(p_snapshot.is_null(), PackedByteArray(),
			vformat("%s: get_changes_since() needs a snapshot from take_snapshot().", p_map.label()));
	return to_bytes(std::span<const uint8_t>(write_changes(p_snapshot->map, p_map.copy(), engine_codec())));
}

bool apply_changes_to(GrassMap &r_map, const PackedByteArray &p_changes) {
	if (p_changes.is_empty()) {
		return true; // nothing changed
	}
	const std::span bytes(p_changes.ptr(), size_t(p_changes.size()));
	ReadLimits limits = get_read_limits();
	for (const MapRegion &region : r_map.find_shown()) {
		limits.regions.push_back(region);
	}
	const String label = r_map.label(); // a listener may free the map
	const auto applied = r_map.change_chunks([&](PaintMap &r_changed) { return apply_changes(bytes, engine_codec(), r_changed, limits); });
	if (!applied) {
		return false;
	}
	ERR_FAIL_COND_V_MSG(!applied->reason.empty(), false, vformat("%s: these changes %s.", label, text_of(applied->reason)));
	return true;
}

namespace {

Dictionary to_dictionary(const MapMerge &p_merge) {
	Array conflicts;
	for (const MergeConflict &conflict : p_merge.conflicts) {
		Dictionary entry;
		entry["channel"] = int64_t(conflict.channel);
		entry["texels"] = int64_t(conflict.texels);
		entry["region"] = Rect2(to_godot(conflict.region.min), to_godot(Eigen::Vector2d(conflict.region.max - conflict.region.min)));
		conflicts.push_back(entry);
	}
	Dictionary report;
	report["texels"] = int64_t(p_merge.texels);
	report["conflicts"] = conflicts;
	report["base_density_conflict"] = p_merge.is_base_in_conflict;
	return report;
}

} // namespace

Dictionary merge_into(GrassMap &r_map, const Ref<GrassMap> &p_base, const Ref<GrassMap> &p_theirs, bool p_prefers_theirs) {
	const String label = r_map.label(); // a listener may free the map
	ERR_FAIL_COND_V_MSG(p_base.is_null() || p_theirs.is_null(), Dictionary(),
			vformat("%s: merge() needs two maps: the one that both began with, and theirs.", label));
	const PaintMap base = p_base->copy(), theirs = p_theirs->copy();
	const ReadLimits limits = get_read_limits();
	const auto merge =
			r_map.change_chunks([&](PaintMap &r_changed) { return merge_maps(base, theirs, r_changed, p_prefers_theirs, limits); });
	if (!merge) {
		return Dictionary();
	}
	ERR_FAIL_COND_V_MSG(!merge->reason.empty(), Dictionary(), vformat("%s: the merged map %s.", label, text_of(merge->reason)));
	return to_dictionary(*merge);
}

} // namespace grass
