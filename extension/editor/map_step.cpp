// SPDX-License-Identifier: MIT
#include "editor/map_step.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/undo_redo.hpp>

using namespace godot;

namespace grass {

void add_map_step(EditorUndoRedoManager *p_history, const String &p_name, const MapStep &p_step) {
	p_history->create_action(p_name, UndoRedo::MERGE_DISABLE, p_step.context);
	if (p_step.new_of != nullptr) {
		p_history->add_do_property(p_step.new_of, "map", p_step.map);
		p_history->add_undo_property(p_step.new_of, "map", Variant());
	}
	GrassMap *map = p_step.map.ptr();
	p_history->add_do_method(map, "restore_snapshot", map->take_snapshot());
	p_history->add_undo_method(map, "restore_snapshot", p_step.before);
	p_history->commit_action(false);
	EditorInterface::get_singleton()->set_object_edited(map, true);
}

} // namespace grass
