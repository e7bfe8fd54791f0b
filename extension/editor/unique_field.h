// SPDX-License-Identifier: MIT
// Gives a field its own copies of what it shares with others.
#pragma once

#include "nodes/grass_field.h"

#include <set>

namespace grass {

// Give a field its own copies, in one step of the undo history each. The second also copies rule, species and patches that are not files of
// their own.
void make_map_unique(GrassField &r_field);
void make_unique(GrassField &r_field);

// Prints once that paint on the field shows on other fields as well.
void tell_of_sharing(const GrassField &p_field);

// Gives each duplicated field a map of its own, since the engine's Duplicate and Paste let it share the original's. The new map is a part
// of those steps of the history: undo and redo bring back the field with its map. A map that is a file stays shared, and the editor prints
// that.
class DuplicatedFields {
public:
	// Must be called in each frame, and before anything is painted. p_root: of the edited scene, or null.
	void update(const godot::Node *p_root);

private:
	uint64_t _root_id = 0; // of the scene at the last call
	std::set<uint64_t> _known; // fields that exist, in the tree or in the history of undo
};

} // namespace grass
