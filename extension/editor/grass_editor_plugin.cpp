// SPDX-License-Identifier: MIT
#include "editor/grass_editor_plugin.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_toaster.hpp>
#include <godot_cpp/classes/editor_undo_redo_manager.hpp>
#include <godot_cpp/classes/time.hpp>
#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace grass {

namespace {

StrokeKeys keys_of(const InputEventWithModifiers *p_event) {
	StrokeKeys keys;
	keys.opposite = p_event->is_command_or_control_pressed();
	keys.smooth = p_event->is_shift_pressed();
	return keys;
}

} // namespace

void GrassEditorPlugin::_enter_tree() {
	_toolbar = memnew(BrushToolbar);
	_toolbar->set_name("GrassBrushToolbar");
	_toolbar->hide();
	_toolbar->connect("tool_changed", callable_mp(this, &GrassEditorPlugin::_tool_changed));
	_toolbar->connect("bake_pressed", callable_mp(this, &GrassEditorPlugin::_bake_pressed));
	_toolbar->connect("menu_pressed", callable_mp(this, &GrassEditorPlugin::_menu_pressed));
	add_control_to_container(CONTAINER_SPATIAL_EDITOR_MENU, _toolbar);
	set_process(true);
}

void GrassEditorPlugin::_exit_tree() {
	put_down();
	_watch.forget();
	_ring.free();
	remove_control_from_container(CONTAINER_SPATIAL_EDITOR_MENU, _toolbar);
	_toolbar->queue_free();
	_toolbar = nullptr;
}

void GrassEditorPlugin::_notification(int p_what) {
	if (p_what == NOTIFICATION_APPLICATION_FOCUS_OUT || p_what == NOTIFICATION_WM_WINDOW_FOCUS_OUT) {
		finish_stroke();
	} else if (p_what == NOTIFICATION_PROCESS && _toolbar != nullptr) {
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
	return Object::cast_to<GrassField>(p_object) != nullptr;
}

void GrassEditorPlugin::_edit(Object *p_object) {
	put_down();
	_field_id = p_object == nullptr ? 0 : p_object->get_instance_id();
}

void GrassEditorPlugin::_make_visible(bool p_visible) {
	if (_toolbar == nullptr) {
		return; // the editor closes, and tells so after taking the plugin down
	}
	_toolbar->set_visible(p_visible);
	if (!p_visible) {
		put_down();
	}
}

Dictionary GrassEditorPlugin::_get_state() const {
	const_cast<GrassEditorPlugin *>(this)->_apply_changes(); // the last that is heard while the scene is the edited one
	return {};
}

// Null once it is deleted, or while it is outside of the tree.
GrassField *GrassEditorPlugin::find_field() const {
	GrassField *field = _field_id == 0 ? nullptr : Object::cast_to<GrassField>(ObjectDB::get_instance(_field_id));
	return field != nullptr && field->is_inside_tree() ? field : nullptr;
}

int32_t GrassEditorPlugin::_forward_3d_gui_input(Camera3D *p_camera, const Ref<InputEvent> &p_event) {
	if (find_field() == nullptr || _toolbar == nullptr || !_toolbar->has_tool() || p_camera == nullptr) {
		put_down();
		return AFTER_GUI_INPUT_PASS;
	}
	if (const Ref<InputEventKey> key = p_event; key.is_valid()) {
		return key_input(key);
	}
	if (const Ref<InputEventMouseButton> button = p_event; button.is_valid()) {
		return button_input(p_camera, button);
	}
	if (const Ref<InputEventMouseMotion> motion = p_event; motion.is_valid()) {
		const uint64_t begin = Time::get_singleton()->get_ticks_usec();
		const int32_t result = motion_input(p_camera, motion);
		_event_us = double(Time::get_singleton()->get_ticks_usec() - begin);
		return result;
	}
	return AFTER_GUI_INPUT_PASS;
}

int32_t GrassEditorPlugin::key_input(const Ref<InputEventKey> &p_key) {
	if (!p_key->is_pressed()) {
		return AFTER_GUI_INPUT_PASS;
	}
	if (p_key->get_keycode() == KEY_ESCAPE) {
		if (_stroke.is_active()) {
			_stroke.cancel();
		} else {
			_toolbar->put_tool_down();
		}
		return AFTER_GUI_INPUT_STOP;
	}
	// Where a bracket needs AltGr, the keys at their place serve as well.
	const auto is_key = [&](Key p_code) { return p_key->get_keycode() == p_code || p_key->get_physical_keycode() == p_code; };
	const int notches = int(is_key(KEY_BRACKETRIGHT)) - int(is_key(KEY_BRACKETLEFT));
	if (notches == 0 || p_key->is_alt_pressed()) {
		if (p_key->is_command_or_control_pressed() && p_key->get_keycode() != KEY_CTRL && p_key->get_keycode() != KEY_META) {
			finish_stroke(); // undo, save and the like act on whole strokes
		}
		return AFTER_GUI_INPUT_PASS;
	}
	using Toolbar = BrushToolbar;
	const bool ctrl = p_key->is_command_or_control_pressed(), shift = p_key->is_shift_pressed();
	_toolbar->nudge(ctrl ? (shift ? Toolbar::NUMBER_TARGET : Toolbar::NUMBER_STRENGTH)
						 : (shift ? Toolbar::NUMBER_HARDNESS : Toolbar::NUMBER_RADIUS),
			notches);
	return AFTER_GUI_INPUT_STOP;
}

int32_t GrassEditorPlugin::button_input(Camera3D *p_camera, const Ref<InputEventMouseButton> &p_button) {
	const MouseButton index = p_button->get_button_index();
	const bool ctrl = p_button->is_command_or_control_pressed(), shift = p_button->is_shift_pressed();
	if (index == MOUSE_BUTTON_LEFT) {
		if (!p_button->is_pressed()) {
			const bool painted = _stroke.is_active();
			finish_stroke();
			return painted ? AFTER_GUI_INPUT_STOP : AFTER_GUI_INPUT_PASS;
		}
		if (p_button->is_alt_pressed()) { // turns the view, where the editor is set up so
			return AFTER_GUI_INPUT_PASS;
		}
		finish_stroke();
		if (const auto point = show_ring(p_camera, p_button->get_position())) {
			finish_ground();
			_stroke.begin(find_field(), _toolbar->get_brush(), *point, keys_of(p_button.ptr()), _toolbar->follows_ground());
		}
		return AFTER_GUI_INPUT_STOP;
	}
	// With Shift, some systems turn the wheel sideways.
	const int notches = int(index == MOUSE_BUTTON_WHEEL_UP || index == MOUSE_BUTTON_WHEEL_RIGHT) -
			int(index == MOUSE_BUTTON_WHEEL_DOWN || index == MOUSE_BUTTON_WHEEL_LEFT);
	if (notches == 0) {
		finish_stroke(); // another button turns or moves the view
		return AFTER_GUI_INPUT_PASS;
	}
	if (p_button->is_alt_pressed() || (!ctrl && !shift)) {
		return AFTER_GUI_INPUT_PASS;
	}
	if (p_button->is_pressed()) {
		using Toolbar = BrushToolbar;
		_toolbar->nudge(!ctrl ? Toolbar::NUMBER_HARDNESS : (shift ? Toolbar::NUMBER_STRENGTH : Toolbar::NUMBER_RADIUS), notches);
		show_ring(p_camera, p_button->get_position());
	}
	return AFTER_GUI_INPUT_STOP;
}

int32_t GrassEditorPlugin::motion_input(Camera3D *p_camera, const Ref<InputEventMouseMotion> &p_motion) {
	const auto point = show_ring(p_camera, p_motion->get_position());
	if (!_stroke.is_active()) {
		return AFTER_GUI_INPUT_PASS;
	}
	if (!p_motion->get_button_mask().has_flag(MOUSE_BUTTON_MASK_LEFT)) { // released where we could not hear it
		finish_stroke();
		return AFTER_GUI_INPUT_PASS;
	}
	if (point) {
		StrokeKeys keys = keys_of(p_motion.ptr());
		keys.pressure = p_motion->get_pressure() > 0.0 ? double(p_motion->get_pressure()) : 1.0; // a mouse has none
		_stroke.move(*point, keys);
	}
	return AFTER_GUI_INPUT_STOP;
}

std::optional<GroundPoint> GrassEditorPlugin::show_ring(Camera3D *p_camera, const Vector2 &p_mouse) {
	const GrassField *field = find_field();
	const Ref<GrassBrush> brush = _toolbar->get_brush();
	const double radius = brush->get_param(BRUSH_RADIUS);
	const auto point = pick_ground(field, p_camera, p_mouse, radius);
	if (point) {
		_ring.show(field, p_camera, *point, radius, brush->get_param(BRUSH_HARDNESS), _toolbar->get_tool_color());
	} else {
		_ring.hide();
	}
	return point;
}

void GrassEditorPlugin::finish_stroke() {
	if (_stroke.is_active()) {
		_stroke.finish(get_undo_redo());
	}
}

void GrassEditorPlugin::put_down() {
	finish_stroke();
	_ring.hide();
}

void GrassEditorPlugin::_tool_changed() {
	if (!_toolbar->has_tool()) {
		put_down();
	}
}

// Something done to the whole field's map, as one step of the history.
template <typename F> void GrassEditorPlugin::change_map(const char *p_name, F &&p_change) {
	finish_stroke();
	finish_ground();
	GrassField *field = find_field();
	if (field == nullptr) {
		return;
	}
	const bool is_new = field->get_map().is_null();
	const Ref<GrassMap> map = is_new ? add_map(field, _toolbar->follows_ground()) : field->get_map();
	const Ref<GrassMapSnapshot> before = map->take_snapshot();
	if (!p_change(*field, **map)) {
		if (is_new) {
			field->set_map(Ref<GrassMap>());
		}
		return;
	}
	EditorUndoRedoManager *history = get_undo_redo();
	history->create_action(p_name, UndoRedo::MERGE_DISABLE, field);
	if (is_new) {
		history->add_do_property(field, "map", map);
		history->add_undo_property(field, "map", Variant());
	}
	history->add_do_method(map.ptr(), "restore_snapshot", map->take_snapshot());
	history->add_undo_method(map.ptr(), "restore_snapshot", before);
	history->commit_action(false); // all is done already
	EditorInterface::get_singleton()->set_object_edited(map.ptr(), true);
}

void GrassEditorPlugin::_bake_pressed() {
	change_map("Bake Grass Ground", [](GrassField &r_field, GrassMap &) {
		const bool found = r_field.bake_ground() > 0;
		if (!found) {
			EditorInterface::get_singleton()->get_editor_toaster()->push_toast(
					"GrassField: no ground found. Give what the grass shall stand on a collision shape.", EditorToaster::SEVERITY_WARNING);
		}
		return found;
	});
}

void GrassEditorPlugin::_menu_pressed(int64_t p_item) {
	static constexpr const char *NAMES[] = { "Bare Grass Field", "Full Grass Field", "Clear Painted Grass" };
	change_map(NAMES[p_item], [&](GrassField &, GrassMap &r_map) {
		const bool is_clear = p_item == BrushToolbar::MENU_CLEAR;
		const Ref<GrassMapSnapshot> after = r_map.take_snapshot();
		for (const MapKey &key : after->map.get_keys()) {
			for (int channel = 0; channel < MAP_CHANNELS; channel++) {
				const bool is_ground = channel == MAP_GROUND || channel == MAP_NORMAL; // lies there, whoever paints
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
	statistics["ring"] = _ring.is_shown();
	statistics["watch_rays"] = _watch.get_rays();
	statistics["watch_waiting"] = _watch.get_waiting();
	statistics["watch_us"] = _watch.get_look_us();
	return statistics;
}

void GrassEditorPlugin::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_statistics"), &GrassEditorPlugin::get_statistics);
}

} // namespace grass
