// SPDX-License-Identifier: MIT
// What the plugin does to whole fields: buttons and the menu of the toolbar, species that are dropped.
#include "editor/grass_editor_plugin.h"

#include "editor/map_pictures.h"
#include "editor/map_step.h"
#include "editor/own_map_dialog.h"
#include "editor/species_drop.h"
#include "editor/toast.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_selection.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr int32_t VIEWS = 4; // of the editor, shown or not

// A part of another scene is copied, since it would change with that.
Ref<Resource> own_if_foreign(const Ref<Resource> &p_resource) {
	const Node *root = EditorInterface::get_singleton()->get_edited_scene_root();
	return root == nullptr || find_foreign_file(p_resource, *root).is_empty() ? p_resource : own_copy(p_resource);
}

} // namespace

// Something done to whole fields, or to all plots of a world in memory, as one step of the history.
void GrassEditorPlugin::change_maps(const char *p_name, const MapChange &p_change) {
	finish_stroke();
	finish_ground();
	Node3D *selected = find_selected();
	GrassWorld *world = Object::cast_to<GrassWorld>(selected);
	std::vector<MapStep> steps;
	for (GrassField *field : world != nullptr && find_painted() ? find_painted()->fields : std::vector<GrassField *>{ find_field() }) {
		if (const auto step = field != nullptr ? change_map(field, world, p_change) : std::nullopt) {
			steps.push_back(*step);
		}
	}
	if (!steps.empty()) {
		add_map_steps(get_undo_redo(), p_name, selected, steps);
	}
}

std::optional<MapStep> GrassEditorPlugin::change_map(GrassField *p_field, GrassWorld *p_world, const MapChange &p_change) {
	const bool is_new = p_field->get_map().is_null();
	const Ref<GrassMap> map = is_new ? add_map(p_field, _toolbar->follows_ground()) : p_field->get_map();
	const Ref<GrassMapSnapshot> before = map->take_snapshot();
	if (!p_change(*p_field, **map)) {
		if (is_new) {
			p_field->set_map(Ref<GrassMap>());
		}
		return {};
	}
	const Vector2i plot = p_world != nullptr ? p_world->get_plot_at(p_field->get_global_position()) : Vector2i();
	return MapStep{ map, before, is_new ? p_field : nullptr, p_world, plot };
}

void GrassEditorPlugin::_bake_pressed() {
	if (!may_change([this] { _bake_pressed(); })) {
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
	if (!may_change([this, p_item] { _menu_pressed(p_item); })) {
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
	if (_pictures.is_import() && !may_change([this, p_path] { _picture_chosen(p_path); })) {
		return;
	}
	GrassWorld *world = Object::cast_to<GrassWorld>(find_selected());
	MapPictures pictures(_pictures.get_channel(), p_path, world);
	if (_pictures.is_import()) {
		change_maps("Import Grass Picture", [&](GrassField &r_field, GrassMap &) { return pictures.read(r_field); });
	} else if (find_field() != nullptr) {
		finish_stroke();
		finish_ground();
		for (const GrassField *field : world != nullptr ? find_painted()->fields : std::vector<GrassField *>{ find_field() }) {
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
	GrassField *field = Object::cast_to<GrassField>(find_selected());
	finish_stroke();
	finish_ground();
	if (field != nullptr && OwnMapDialog::may_set(*field)) {
		make_unique(*field);
	}
}

// They grow beside the field's own, and the last one is in the hand.
void GrassEditorPlugin::_species_dropped(const Array &p_species) {
	GrassField *field = Object::cast_to<GrassField>(find_selected());
	if (field == nullptr) {
		if (find_selected() != nullptr) {
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

// The editor's views refuse what they do not know.
void GrassEditorPlugin::begin_drag() {
	end_drag();
	if (find_dragged_species(get_viewport()->gui_get_drag_data()).is_empty()) {
		return;
	}
	for (int32_t view = 0; view < VIEWS; view++) {
		_drops.push_back(ViewDrop::create(view));
		_drops.back()->connect("species_dropped", callable_mp(this, &GrassEditorPlugin::_species_dropped_on));
	}
}

void GrassEditorPlugin::end_drag() {
	for (ViewDrop *drop : _drops) {
		drop->queue_free(); // may be the one that took it
	}
	_drops.clear();
}

// The brush follows to that field.
void GrassEditorPlugin::_species_dropped_on(Object *p_field, const Array &p_species) {
	GrassField *field = Object::cast_to<GrassField>(p_field);
	if (field != find_selected()) {
		EditorInterface *editor = EditorInterface::get_singleton();
		editor->get_selection()->clear();
		editor->get_selection()->add_node(field);
		editor->edit_node(field);
		_edit(field); // at once: the editor may do it later
	}
	_species_dropped(p_species);
}

} // namespace grass
