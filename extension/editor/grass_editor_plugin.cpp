// SPDX-License-Identifier: MIT
// The plugin's life. Mouse and keys: grass_editor_input.cpp; buttons and drops: grass_editor_actions.cpp.
#include "editor/grass_editor_plugin.h"

#include "editor/bake_offer.h"
#include "editor/fill_action.h"
#include "editor/kept_plots_dialog.h"
#include "editor/own_map_dialog.h"
#include "editor/save_worlds.h"
#include "editor/species_preview.h"
#include "editor/toast.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_resource_preview.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr int FRAMES_AN_OFFER = 20; // More: the offer comes late, and stays after its ground was baked. Less: more rays.

} // namespace

void GrassEditorPlugin::_enter_tree() {
	set_editor_hooks();
	_toolbar = memnew(BrushToolbar);
	_toolbar->set_name("GrassBrushToolbar");
	_toolbar->hide();
	_toolbar->connect("tool_changed", callable_mp(this, &GrassEditorPlugin::_tool_changed));
	_toolbar->connect("bake_pressed", callable_mp(this, &GrassEditorPlugin::_bake_pressed));
	_toolbar->connect("species_dropped", callable_mp(this, &GrassEditorPlugin::_species_dropped));
	_toolbar->get_menu()->connect("item_chosen", callable_mp(this, &GrassEditorPlugin::_menu_pressed));
	add_control_to_container(CONTAINER_SPATIAL_EDITOR_MENU, _toolbar);
	_answer.create();
	_export_plugin.instantiate();
	add_export_plugin(_export_plugin);
	_pictures.create(callable_mp(this, &GrassEditorPlugin::_picture_chosen));
	_export_masks.instantiate();
	add_export_plugin(_export_masks);
	// Never removed: the editor's thread walks its list of generators without a lock, and ends only after this plugin has left the tree.
	// The list lets go of them where the editor's nodes are freed, before it unloads libraries.
	EditorInterface::get_singleton()->get_resource_previewer()->add_preview_generator(Ref<SpeciesPreview>(memnew(SpeciesPreview)));
	_size_handles.instantiate();
	_size_handles->create_materials();
	add_node_3d_gizmo_plugin(_size_handles);
	GrassWorld::scene_saved = &save_world;
	KeptPlotsDialog::create();
	GrassWorld::places_changed = &KeptPlotsDialog::ask;
	OwnMapDialog::create();
	get_tree()->connect("node_added", callable_mp(this, &GrassEditorPlugin::_node_added));
	set_process(true);
}

void GrassEditorPlugin::_exit_tree() {
	get_tree()->disconnect("node_added", callable_mp(this, &GrassEditorPlugin::_node_added));
	clear_editor_hooks();
	GrassWorld::scene_saved = nullptr;
	GrassWorld::places_changed = nullptr;
	KeptPlotsDialog::free();
	OwnMapDialog::free();
	put_down();
	_watch.forget();
	_ring.free();
	_answer.free();
	remove_export_plugin(_export_plugin);
	_export_plugin.unref();
	_pictures.free();
	remove_export_plugin(_export_masks);
	_export_masks.unref();
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
		_drops.begin(get_viewport()->gui_get_drag_data(), callable_mp(this, &GrassEditorPlugin::_species_dropped_on));
	} else if (p_what == NOTIFICATION_DRAG_END) {
		_drops.end();
	} else if (p_what == NOTIFICATION_PROCESS && _toolbar != nullptr) {
		update_toolbar();
		_grass.update();
		if (!_toolbar->follows_ground()) {
			_watch.forget();
		} else if (!_stroke.is_active()) { // a stroke keeps a snapshot, which must contain whole strokes and all ground
			_watch.update(EditorInterface::get_singleton()->get_edited_scene_root());
		}
	}
}

// Offers to bake the ground of a flat field above uneven ground. The brush does so by itself.
void GrassEditorPlugin::update_toolbar() {
	if (!_toolbar->is_visible()) {
		return;
	}
	_toolbar->show_species(_grass.find_first());
	if (--_frames_to_offer <= 0) {
		_frames_to_offer = FRAMES_AN_OFFER;
		const GrassField *field = _grass.find_field();
		const bool is_idle = field != nullptr && !_toolbar->has_tool() && !_toolbar->is_asking();
		_toolbar->offer_bake(is_idle ? find_bake_offer(*field) : String());
	}
	_toolbar->place_over_view();
}

void GrassEditorPlugin::_node_added(Object *p_node) {
	if (const Node *node = Object::cast_to<Node>(p_node); node != nullptr && _new_nodes.see(*node)) {
		callable_mp(this, &GrassEditorPlugin::_node_is_placed).call_deferred(int64_t(node->get_instance_id()));
	}
}

// Runs before the ground goes into a snapshot or a file.
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
	_frames_to_offer = 0;
	_grass.select(p_object);
	if (_toolbar != nullptr) {
		_toolbar->get_menu()->fit_to_world(Object::cast_to<GrassWorld>(p_object) != nullptr);
	}
}

void GrassEditorPlugin::_make_visible(bool p_visible) {
	if (_toolbar == nullptr) {
		return; // the editor is closing, and notifies only after it has removed the plugin
	}
	_toolbar->set_visible(p_visible);
	if (!p_visible) {
		put_down();
	}
}

Dictionary GrassEditorPlugin::_get_state() const {
	const_cast<GrassEditorPlugin *>(this)->_apply_changes(); // the last notification while this scene is the edited one
	return {};
}

void GrassEditorPlugin::finish_stroke() {
	if (!_stroke.is_active()) {
		return;
	}
	_stroke.finish(get_undo_redo());
	if (const PackedStringArray &names = _stroke.get_left_out(); !names.is_empty()) {
		toast(vformat("GrassField: the species was not planted in %s, which does not grow it. Select the field and drop the species on its "
					  "brush's Species tool, or add it to `species`.",
				String(", ").join(names)));
	}
}

void GrassEditorPlugin::put_down() {
	finish_stroke();
	hide_brush();
	_answer.hide();
}

void GrassEditorPlugin::_tool_changed() {
	finish_stroke(); // a key may take another tool while the mouse is down
	_answer.hide();
	_frames_to_offer = 0;
	if (!_toolbar->has_tool()) {
		put_down();
	}
	_toolbar->show_species(_grass.find_first());
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
	statistics["watch_most_rays"] = _watch.get_most_rays();
	statistics["watch_waiting"] = _watch.get_waiting();
	statistics["watch_us"] = _watch.get_look_us();
	return statistics;
}

void GrassEditorPlugin::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_statistics"), &GrassEditorPlugin::get_statistics);
}

} // namespace grass
