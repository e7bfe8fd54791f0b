// SPDX-License-Identifier: MIT
#include "editor/edited_grass.h"

#include "editor/own_map_dialog.h"

#include <godot_cpp/classes/editor_interface.hpp>

#include <utility>

using namespace godot;

namespace grass {

void EditedGrass::select(const Object *p_object) {
	_id = p_object != nullptr ? p_object->get_instance_id() : 0;
	_reported_id = 0;
}

void EditedGrass::update() {
	_duplicates.update(EditorInterface::get_singleton()->get_edited_scene_root());
}

Node3D *EditedGrass::find_node() const {
	Node3D *node = _id != 0 ? Object::cast_to<Node3D>(ObjectDB::get_instance(_id)) : nullptr;
	return node != nullptr && node->is_inside_tree() ? node : nullptr;
}

std::optional<PaintedFields> EditedGrass::find_painted(bool p_with_neighbours) const {
	if (GrassWorld *world = find_world()) {
		return painted_plots(world);
	}
	GrassField *field = find_field();
	if (field == nullptr) {
		return {};
	}
	return p_with_neighbours ? painted_neighbours(field) : painted_field(field);
}

std::vector<GrassField *> EditedGrass::find_fields() const {
	const std::optional<PaintedFields> painted = find_painted(false);
	return painted ? painted->fields : std::vector<GrassField *>();
}

GrassField *EditedGrass::find_first() const {
	const std::vector<GrassField *> fields = find_fields();
	return fields.empty() ? nullptr : fields[0];
}

bool EditedGrass::may_change(const std::function<void()> &p_then) {
	update();
	const GrassField *field = find_field();
	if (field != nullptr && !OwnMapDialog::may_change(*field, p_then)) {
		return false;
	}
	if (field != nullptr && std::exchange(_reported_id, _id) != _id) {
		tell_of_sharing(*field);
	}
	return true;
}

} // namespace grass
