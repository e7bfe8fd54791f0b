// SPDX-License-Identifier: MIT
// The field or the world that is selected in the editor, and whether its grass may be changed.
#pragma once

#include "editor/painted_fields.h"
#include "editor/unique_field.h"

#include <functional>

namespace grass {

class EditedGrass {
public:
	void select(const godot::Object *p_object); // null: nothing is selected
	// Must be called in each frame, and before anything is changed.
	void update();

	// Return what is selected while it is in the tree, or null.
	godot::Node3D *find_node() const;
	GrassWorld *find_world() const { return godot::Object::cast_to<GrassWorld>(find_node()); }
	GrassField *find_field() const { return godot::Object::cast_to<GrassField>(find_node()); }
	// Returns what the brush paints; nothing if no field is ready.
	std::optional<PaintedFields> find_painted(bool p_with_neighbours) const;
	// Returns the selected field, or those of a world that are in memory; the first one defines the numbers of species.
	std::vector<GrassField *> find_fields() const;
	GrassField *find_first() const; // of these, or null

	// Returns whether the edited scene saves what is changed in the selected field's map. If not, asks the user, and may run p_then later.
	bool may_change(const std::function<void()> &p_then = {});

private:
	uint64_t _id = 0; // 0: none
	uint64_t _reported_id = 0; // of the selected field, once the editor has printed which other fields share its map
	DuplicatedFields _duplicates;
};

} // namespace grass
