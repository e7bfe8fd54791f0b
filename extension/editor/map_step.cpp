// SPDX-License-Identifier: MIT
#include "editor/map_step.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/undo_redo.hpp>

using namespace godot;

namespace grass {

void add_map_steps(EditorUndoRedoManager *p_history, const String &p_name, Object *p_context, std::span<const MapStep> p_steps) {
	p_history->create_action(p_name, UndoRedo::MERGE_DISABLE, p_context);
	for (const MapStep &step : p_steps) {
		if (step.new_of != nullptr) {
			p_history->add_do_property(step.new_of, "map", step.map);
			p_history->add_undo_property(step.new_of, "map", Variant());
		}
		GrassMap *map = step.map.ptr();
		const Ref<GrassMapSnapshot> after = map->take_snapshot();
		if (step.world != nullptr) {
			p_history->add_do_method(step.world, "restore_plot", step.plot, after, step.before);
			p_history->add_undo_method(step.world, "restore_plot", step.plot, step.before, after);
			continue;
		}
		// Another scene with the same file may have painted it meanwhile.
		p_history->add_do_method(map, "restore_snapshot", after, step.before);
		p_history->add_undo_method(map, "restore_snapshot", step.before, after);
	}
	p_history->commit_action(false);
	for (const MapStep &step : p_steps) {
		if (step.world == nullptr) { // a world saves its plots itself
			EditorInterface::get_singleton()->set_object_edited(const_cast<GrassMap *>(step.map.ptr()), true);
		}
	}
}

} // namespace grass
