// SPDX-License-Identifier: MIT
// What the plugin does to whole fields: buttons and the menu of the toolbar, species that are dropped.
#include "editor/grass_editor_plugin.h"

#include "editor/map_pictures.h"
#include "editor/own_map_dialog.h"
#include "editor/species_drop.h"
#include "editor/toast.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_selection.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// Returns a copy of a part of another scene, which would change with that scene; anything else as it is.
Ref<Resource> own_if_foreign(const Ref<Resource> &p_resource) {
	const Node *root = EditorInterface::get_singleton()->get_edited_scene_root();
	return root == nullptr || find_foreign_file(p_resource, *root).is_empty() ? p_resource : own_copy(p_resource);
}

} // namespace

// Changes whole fields, or all plots of a world in memory, as one step of the history.
void GrassEditorPlugin::change_maps(const char *p_name, const MapChange &p_change) {
	finish_stroke();
	finish_ground();
	grass::change_maps(get_undo_redo(), p_name, _grass.find_fields(), _grass.find_world(), _toolbar->follows_ground(), p_change);
}

void GrassEditorPlugin::_bake_pressed() {
	if (!_grass.may_change([this] { _bake_pressed(); })) {
		return;
	}
	_frames_to_offer = 0;
	bool found = false;
	change_maps("Bake Grass Ground", [&found](GrassField &r_field, GrassMap &) {
		const bool is_here = r_field.get_parts().work.bake_whole_ground() > 0;
		found = found || is_here;
		return is_here;
	});
	if (!found) {
		toast("GrassField: no ground found. Add a collision shape to what the grass should grow on, and see that `ground_mask` and "
			  "`ground_group` mean it.");
	}
}

void GrassEditorPlugin::_menu_pressed(int64_t p_item) {
	if (clipboard_pressed(p_item)) {
		return;
	}
	if (p_item == BrushMenu::EXPORT || p_item == BrushMenu::IMPORT) {
		_pictures.ask(p_item == BrushMenu::IMPORT);
		return;
	}
	if (p_item == BrushMenu::UNIQUE) {
		make_selected_unique();
		return;
	}
	if (!_grass.may_change([this, p_item] { _menu_pressed(p_item); })) {
		return;
	}
	static constexpr const char *NAMES[] = { "Bare Grass Field", "Full Grass Field", "Clear Painted Grass" };
	change_maps(NAMES[p_item], [&](GrassField &, GrassMap &r_map) {
		const bool is_clear = p_item == BrushMenu::CLEAR;
		const Ref<GrassMapSnapshot> after = r_map.take_snapshot();
		for (const MapKey &key : after->map.get_keys()) {
			for (int channel = 0; channel < MAP_CHANNELS; channel++) {
				// Lies there, whoever paints.
				const bool is_ground = channel == MAP_GROUND || channel == MAP_NORMAL || channel == MAP_HOLE || channel == MAP_LEDGE;
				if (is_clear ? !is_ground : channel == MAP_DENSITY) {
					after->map.set_texels(key, MapChannel(channel), nullptr);
				}
			}
		}
		after->map.compact();
		if (!is_clear) {
			after->map.set_base_density(p_item == BrushMenu::BARE ? 0.0 : 1.0);
		}
		r_map.restore_snapshot(after);
		return true;
	});
}

void GrassEditorPlugin::_picture_chosen(const String &p_path) {
	if (_pictures.is_import() && !_grass.may_change([this, p_path] { _picture_chosen(p_path); })) {
		return;
	}
	MapPictures pictures(_pictures.get_channel(), p_path, _grass.find_world());
	if (_pictures.is_import()) {
		change_maps("Import Grass Picture", [&](GrassField &r_field, GrassMap &) { return pictures.read(r_field); });
	} else {
		finish_stroke();
		finish_ground();
		for (const GrassField *field : _grass.find_fields()) {
			pictures.write(*field);
		}
	}
	const String problem = pictures.get_problem();
	const bool is_done = problem.is_empty() && pictures.get_count() > 0;
	toast(is_done ? vformat(_pictures.is_import() ? "Imported pictures: %d." : "Exported pictures: %d.", pictures.get_count())
				  : "GrassField: " + (problem.is_empty() ? vformat("'%s': there is no picture for a plot in memory.", p_path) : problem),
			is_done ? EditorToaster::SEVERITY_INFO : EditorToaster::SEVERITY_ERROR);
}

void GrassEditorPlugin::make_selected_unique() {
	GrassField *field = _grass.find_field();
	finish_stroke();
	finish_ground();
	if (field != nullptr && OwnMapDialog::may_set(*field)) {
		make_unique(*field);
	}
}

// Adds the dropped species to the field's own, and selects the last one.
void GrassEditorPlugin::_species_dropped(const Array &p_species) {
	GrassField *field = _grass.find_field();
	if (field == nullptr) {
		if (_grass.find_node() != nullptr) {
			toast("GrassWorld: all plots grow the species of one field. Open the scene in `plot_scene` and drop it there.");
		}
		return;
	}
	if (!OwnMapDialog::may_set(*field)) {
		return;
	}
	const TypedArray<GrassSpecies> before = field->get_species();
	TypedArray<GrassSpecies> after = find_grown_species(*field);
	const int64_t grown = after.size();
	int64_t last = -1; // that is dropped, in `after`
	for (int64_t i = 0; i < p_species.size(); i++) {
		last = after.find(p_species[i]);
		if (last < 0) {
			last = after.size();
			after.push_back(own_if_foreign(p_species[i]));
		}
	}
	if (after.size() > GRASS_MAX_SPECIES) {
		toast(vformat("GrassField: a field grows %d species at most. Remove one from `species` first.", GRASS_MAX_SPECIES));
		return;
	}
	if (after.size() > grown) {
		EditorUndoRedoManager *history = get_undo_redo();
		history->create_action("Add Grass Species", UndoRedo::MERGE_DISABLE, field);
		history->add_do_property(field, "species", after);
		history->add_undo_property(field, "species", before);
		history->commit_action();
	}
	_toolbar->show_species(field);
	_toolbar->take_species(last + 1);
}

// Adds dropped species to a field, which the brush then paints.
void GrassEditorPlugin::_species_dropped_on(Object *p_field, const Array &p_species) {
	GrassField *field = Object::cast_to<GrassField>(p_field);
	if (field != _grass.find_node()) {
		EditorInterface *editor = EditorInterface::get_singleton();
		editor->get_selection()->clear();
		editor->get_selection()->add_node(field);
		editor->edit_node(field);
		_edit(field); // at once: the editor may do it later
	}
	_species_dropped(p_species);
}

} // namespace grass
