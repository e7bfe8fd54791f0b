// SPDX-License-Identifier: MIT
// Brings changes of a GrassMap to another one: over a network, or between two people who paint it.
#pragma once

#include "resources/grass_map.h"

#include <godot_cpp/variant/dictionary.hpp>

namespace grass {

// Returns the changes since a snapshot, in order: what a server sends its clients.
godot::PackedByteArray find_changes(const GrassMap &p_map, const godot::Ref<GrassMapSnapshot> &p_snapshot);
bool apply_changes_to(GrassMap &r_map, const godot::PackedByteArray &p_changes);
// Brings the changes from a common state to another map into this one. Returns a report; empty: it was refused.
godot::Dictionary merge_into(
		GrassMap &r_map, const godot::Ref<GrassMap> &p_base, const godot::Ref<GrassMap> &p_theirs, bool p_prefers_theirs);

} // namespace grass
