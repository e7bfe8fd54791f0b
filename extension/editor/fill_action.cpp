// SPDX-License-Identifier: MIT
#include "editor/fill_action.h"

#include "editor/field_stroke.h"
#include "editor/map_step.h"
#include "shared/editor_hooks.h"

#include <godot_cpp/classes/editor_interface.hpp>

using namespace godot;

namespace grass {

namespace {

void mark_edited(const Ref<Resource> &p_resource) {
	EditorInterface::get_singleton()->set_object_edited(p_resource.ptr(), true);
}

// A field without a map gets one with grass everywhere.
void fill(GrassField &r_field) {
	const bool is_new = r_field.get_map().is_null();
	const Ref<GrassMap> map = is_new ? add_map(&r_field, false) : r_field.get_map();
	const Ref<GrassMapSnapshot> before = map->take_snapshot();
	r_field.fill(r_field.get_fill_rule());
	EditorUndoRedoManager *history = EditorInterface::get_singleton()->get_editor_undo_redo();
	const MapStep step{ map, before, is_new ? &r_field : nullptr };
	add_map_steps(history, "Fill Grass", &r_field, { &step, 1 });
}

} // namespace

void set_editor_hooks() {
	editor_hooks = { fill, mark_edited };
}

void clear_editor_hooks() {
	editor_hooks = {};
}

} // namespace grass
