// SPDX-License-Identifier: MIT
#include "editor/fill_action.h"

#include "editor/map_step.h"
#include "editor/own_map_dialog.h"
#include "editor/toast.h"
#include "shared/editor_hooks.h"

#include <godot_cpp/classes/editor_interface.hpp>

using namespace godot;

namespace grass {

namespace {

void mark_edited(const Ref<Resource> &p_resource) {
	EditorInterface *editor = EditorInterface::get_singleton();
	editor->set_object_edited(p_resource.ptr(), true);
	const Node *root = editor->get_edited_scene_root();
	if (const String file = root != nullptr ? find_foreign_file(p_resource, *root) : String(); !file.is_empty()) {
		toast(vformat("GrassField: what the rule has filled is in a map of %s, which this scene does not save. Choose Make Unique in the "
					  "menu at the toolbar's end, or turn `fill_live` on again.",
				file.get_file()));
	}
}

// Fills a field. One without a map gets a map with grass everywhere.
void fill_own(GrassField &r_field) {
	GrassField *field = &r_field;
	change_maps(EditorInterface::get_singleton()->get_editor_undo_redo(), "Fill Grass", { &field, 1 }, nullptr, false,
			[](GrassField &r_own, GrassMap &) {
				r_own.get_parts().sources.fill_whole(r_own.get_fill_rule());
				return true;
			});
}

void fill(GrassField &r_field) {
	const uint64_t id = r_field.get_instance_id();
	const auto again = [id] {
		if (GrassField *field = Object::cast_to<GrassField>(ObjectDB::get_instance(id))) {
			fill_own(*field);
		}
	};
	if (OwnMapDialog::may_change(r_field, again)) {
		fill_own(r_field);
	}
}

} // namespace

void set_editor_hooks() {
	editor_hooks = { fill, mark_edited };
}

void clear_editor_hooks() {
	editor_hooks = {};
}

} // namespace grass
