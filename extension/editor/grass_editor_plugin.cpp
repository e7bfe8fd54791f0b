// SPDX-License-Identifier: MIT
// The plugin's life, and what it does to whole fields. Mouse and keys: grass_editor_input.cpp.
#include "editor/grass_editor_plugin.h"

#include "editor/fill_action.h"
#include "editor/kept_plots_dialog.h"
#include "editor/map_step.h"
#include "editor/save_worlds.h"
#include "editor/species_drop.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_resource_preview.hpp>
#include <godot_cpp/classes/editor_selection.hpp>
#include <godot_cpp/classes/editor_toaster.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr int32_t VIEWS = 4; // of the editor, shown or not

} // namespace

void GrassEditorPlugin::_enter_tree() {
	set_editor_hooks();
	_toolbar = memnew(BrushToolbar);
	_toolbar->set_name("GrassBrushToolbar");
	_toolbar->hide();
	_toolbar->connect("tool_changed", callable_mp(this, &GrassEditorPlugin::_tool_changed));
	_toolbar->connect("bake_pressed", callable_mp(this, &GrassEditorPlugin::_bake_pressed));
	_toolbar->connect("species_dropped", callable_mp(this, &GrassEditorPlugin::_species_dropped));
	_toolbar->connect("menu_pressed", callable_mp(this, &GrassEditorPlugin::_menu_pressed));
	add_control_to_container(CONTAINER_SPATIAL_EDITOR_MENU, _toolbar);
	_answer.create();
	_export_check.instantiate();
	add_export_plugin(_export_check);
	_export_masks.instantiate();
	add_export_plugin(_export_masks);
	_species_preview.instantiate();
	EditorInterface::get_singleton()->get_resource_previewer()->add_preview_generator(_species_preview);
	_size_handles.instantiate();
	_size_handles->create_materials();
	add_node_3d_gizmo_plugin(_size_handles);
	GrassWorld::scene_saved = &save_world;
	KeptPlotsDialog::create();
	GrassWorld::places_changed = &KeptPlotsDialog::ask;
	set_process(true);
}

void GrassEditorPlugin::_exit_tree() {
	clear_editor_hooks();
	GrassWorld::scene_saved = nullptr;
	GrassWorld::places_changed = nullptr;
	KeptPlotsDialog::free();
	put_down();
	_watch.forget();
	_ring.free();
	_answer.free();
	remove_export_plugin(_export_check);
	_export_check.unref();
	remove_export_plugin(_export_masks);
	_export_masks.unref();
	EditorInterface::get_singleton()->get_resource_previewer()->remove_preview_generator(_species_preview);
	_species_preview.unref();
	remove_node_3d_gizmo_plugin(_size_handles);
	_size_handles.unref();
	remove_control_from_container(CONTAINER_SPATIAL_EDITOR_MENU, _toolbar);
	_toolbar->queue_free();
	_toolbar = nullptr;
}

void GrassEditorPlugin::_notification(int p_what) {
	if (p_what == NOTIFICATION_APPLICATION_FOCUS_OUT || p_what == NOTIFICATION_WM_WINDOW_FOCUS_OUT) {
		finish_stroke();
	} else if (p_what == NOTIFICATION_DRAG_BEGIN) {
		begin_drag();
	} else if (p_what == NOTIFICATION_DRAG_END) {
		end_drag();
	} else if (p_what == NOTIFICATION_PROCESS && _toolbar != nullptr) {
		if (_toolbar->is_visible()) {
			_toolbar->show_species(find_field());
		}
		if (!_toolbar->follows_ground()) {
			_watch.forget();
		} else if (!_stroke.is_active()) { // it keeps a snapshot, which is whole strokes and whole ground
			_watch.update(EditorInterface::get_singleton()->get_edited_scene_root());
		}
	}
}

// Before the ground goes into a snapshot or a file.
void GrassEditorPlugin::finish_ground() {
	if (_toolbar != nullptr && _toolbar->follows_ground()) {
		_watch.finish(EditorInterface::get_singleton()->get_edited_scene_root());
	}
}

void GrassEditorPlugin::_apply_changes() {
	finish_stroke();
	finish_ground();
}

bool GrassEditorPlugin::_handles(Object *p_object) const {
	return Object::cast_to<GrassField>(p_object) != nullptr || Object::cast_to<GrassWorld>(p_object) != nullptr;
}

void GrassEditorPlugin::_edit(Object *p_object) {
	put_down();
	_selected_id = p_object == nullptr ? 0 : p_object->get_instance_id();
	if (_toolbar != nullptr) {
		_toolbar->fit_to_world(Object::cast_to<GrassWorld>(p_object) != nullptr);
	}
}

void GrassEditorPlugin::_make_visible(bool p_visible) {
	if (_toolbar == nullptr) {
		return; // the editor closes, and notifies only after it removed the plugin
	}
	_toolbar->set_visible(p_visible);
	if (!p_visible) {
		put_down();
	}
}

Dictionary GrassEditorPlugin::_get_state() const {
	const_cast<GrassEditorPlugin *>(this)->_apply_changes(); // the last notification while the scene is the edited one
	return {};
}

// Null once it is deleted, or while it is outside of the tree.
Node3D *GrassEditorPlugin::find_selected() const {
	Node3D *node = _selected_id == 0 ? nullptr : Object::cast_to<Node3D>(ObjectDB::get_instance(_selected_id));
	return node != nullptr && node->is_inside_tree() ? node : nullptr;
}

std::optional<PaintedFields> GrassEditorPlugin::find_painted() const {
	Node3D *selected = find_selected();
	if (GrassWorld *world = Object::cast_to<GrassWorld>(selected)) {
		return painted_plots(world);
	}
	GrassField *field = Object::cast_to<GrassField>(selected);
	if (field == nullptr) {
		return {};
	}
	return _toolbar->paints_neighbours() ? painted_neighbours(field) : painted_field(field);
}

GrassField *GrassEditorPlugin::find_field() const {
	Node3D *selected = find_selected();
	if (GrassWorld *world = Object::cast_to<GrassWorld>(selected)) {
		const std::optional<PaintedFields> painted = painted_plots(world);
		return painted ? painted->fields[0] : nullptr;
	}
	return Object::cast_to<GrassField>(selected);
}

void GrassEditorPlugin::finish_stroke() {
	if (!_stroke.is_active()) {
		return;
	}
	_stroke.finish(get_undo_redo());
	if (const PackedStringArray &names = _stroke.get_left_out(); !names.is_empty()) {
		EditorInterface::get_singleton()->get_editor_toaster()->push_toast(
				vformat("GrassField: the species was not planted in %s, which does not grow it. Select the field and drop the species on "
						"its "
						"brush's Species tool, or add it to `species`.",
						String(", ").join(names)),
				EditorToaster::SEVERITY_WARNING);
	}
}

void GrassEditorPlugin::put_down() {
	finish_stroke();
	hide_brush();
	_answer.hide();
}

void GrassEditorPlugin::_tool_changed() {
	_answer.hide();
	if (!_toolbar->has_tool()) {
		put_down();
	}
	_toolbar->show_species(find_field());
}

// Something done to whole fields, or to all plots of a world in memory, as one step of the history.
template <typename F> void GrassEditorPlugin::change_maps(const char *p_name, F &&p_change) {
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

template <typename F> std::optional<MapStep> GrassEditorPlugin::change_map(GrassField *p_field, GrassWorld *p_world, F &&p_change) {
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
	bool found = false;
	change_maps("Bake Grass Ground", [&found](GrassField &r_field, GrassMap &) {
		const bool is_here = r_field.bake_ground() > 0;
		found = found || is_here;
		return is_here;
	});
	if (!found) {
		EditorInterface::get_singleton()->get_editor_toaster()->push_toast(
				"GrassField: no ground found. Add a collision shape to what the grass should grow on.", EditorToaster::SEVERITY_WARNING);
	}
}

// They grow beside the field's own, and the last one is in the hand.
void GrassEditorPlugin::_species_dropped(const Array &p_species) {
	GrassField *field = Object::cast_to<GrassField>(find_selected());
	if (field == nullptr) {
		if (find_selected() != nullptr) {
			EditorInterface::get_singleton()->get_editor_toaster()->push_toast(
					"GrassWorld: all plots grow the species of one field. Open the scene in `plot_scene` and drop it there.",
					EditorToaster::SEVERITY_WARNING);
		}
		return;
	}
	const TypedArray<GrassSpecies> before = field->get_species();
	TypedArray<GrassSpecies> after = before.duplicate();
	for (int64_t i = 0; i < p_species.size(); i++) {
		if (!after.has(p_species[i])) {
			after.push_back(p_species[i]);
		}
	}
	if (after.size() > GRASS_MAX_SPECIES) {
		EditorInterface::get_singleton()->get_editor_toaster()->push_toast(
				vformat("GrassField: a field grows %d species at most. Remove one from `species` first.", GRASS_MAX_SPECIES),
				EditorToaster::SEVERITY_WARNING);
		return;
	}
	if (after.size() > before.size()) {
		EditorUndoRedoManager *history = get_undo_redo();
		history->create_action("Add Grass Species", UndoRedo::MERGE_DISABLE, field);
		history->add_do_property(field, "species", after);
		history->add_undo_property(field, "species", before);
		history->commit_action();
	}
	_toolbar->show_species(field);
	_toolbar->take_species(after.find(p_species[p_species.size() - 1]) + 1);
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

void GrassEditorPlugin::_menu_pressed(int64_t p_item) {
	static constexpr const char *NAMES[] = { "Bare Grass Field", "Full Grass Field", "Clear Painted Grass" };
	change_maps(NAMES[p_item], [&](GrassField &, GrassMap &r_map) {
		const bool is_clear = p_item == BrushToolbar::MENU_CLEAR;
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
			after->map.set_base_density(p_item == BrushToolbar::MENU_BARE ? 0.0 : 1.0);
		}
		r_map.restore_snapshot(after);
		return true;
	});
}

Dictionary GrassEditorPlugin::get_statistics() const {
	const StrokeCosts &costs = _stroke.get_costs();
	Dictionary statistics;
	statistics["steps"] = costs.steps;
	statistics["chunks"] = costs.chunks;
	statistics["rays"] = costs.rays;
	statistics["total_us"] = costs.total_us;
	statistics["worst_us"] = costs.worst_us;
	statistics["event_us"] = _event_us;
	statistics["active"] = _stroke.is_active();
	statistics["left_out"] = _stroke.get_left_out();
	statistics["ring"] = _ring.is_shown();
	statistics["preview"] = _preview.get_count();
	statistics["watch_rays"] = _watch.get_rays();
	statistics["watch_waiting"] = _watch.get_waiting();
	statistics["watch_us"] = _watch.get_look_us();
	return statistics;
}

void GrassEditorPlugin::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_statistics"), &GrassEditorPlugin::get_statistics);
}

} // namespace grass
