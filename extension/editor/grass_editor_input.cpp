// SPDX-License-Identifier: MIT
// The mouse and keyboard input in the 3D view while a GrassField or a GrassWorld is selected.
#include "editor/grass_editor_plugin.h"

#include "shared/convert.h"

#include <godot_cpp/classes/time.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

constexpr double ASKED_AROUND = 1000.0, ASKED_RADIUS = 0.2; // metres: reach of queries around the field; radius of the mark there
constexpr const char *NOT_IN_MEMORY =
		"No plot of the world is in memory here. Come nearer, or raise the world's `camera_radius` and `memory_budget`.";
const Color ASKED_COLOR(1.0f, 0.8f, 0.37f);

StrokeKeys keys_of(const InputEventWithModifiers *p_event) {
	StrokeKeys keys;
	keys.opposite = p_event->is_command_or_control_pressed();
	keys.smooth = p_event->is_shift_pressed();
	return keys;
}

// Returns the field that the cursor points at; the selected one if it is none's ground.
GrassField *find_asked(const PaintedFields &p_asked, const Vector3 &p_place) {
	const auto found = std::ranges::find_if(
			p_asked.fields, [&](const GrassField *p_field) { return p_field->get_parts().queries.has_level_at(p_place); });
	return found != p_asked.fields.end() ? *found : p_asked.fields[0];
}

// Names the field if it is not the selected one.
String answer_of(const PaintedFields &p_asked, GrassField *p_field, const Vector3 &p_place, const Camera3D *p_camera) {
	const String text = p_field->get_report().explain(p_place, p_camera)["text"];
	const bool is_other = p_asked.world == nullptr && p_field != p_asked.chosen;
	return is_other ? vformat("%s: %s", p_field->get_name(), text) : text;
}

} // namespace

int32_t GrassEditorPlugin::_forward_3d_gui_input(Camera3D *p_camera, const Ref<InputEvent> &p_event) {
	const bool is_idle = _toolbar == nullptr || (!_toolbar->has_tool() && !_toolbar->is_asking());
	if (is_idle || !find_painted() || p_camera == nullptr) {
		put_down();
		return AFTER_GUI_INPUT_PASS;
	}
	if (_toolbar->is_asking()) {
		return asking_input(p_camera, p_event);
	}
	if (const Ref<InputEventKey> key = p_event; key.is_valid()) {
		return key_input(p_camera, key);
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

// Handles input while the toolbar explains places. The answer follows the cursor, and the view can be turned as usual; a click selects
// nothing.
int32_t GrassEditorPlugin::asking_input(Camera3D *p_camera, const Ref<InputEvent> &p_event) {
	if (const Ref<InputEventKey> key = p_event; key.is_valid() && key->is_pressed() && key->get_keycode() == KEY_ESCAPE) {
		_toolbar->put_tool_down();
		return AFTER_GUI_INPUT_STOP;
	}
	if (const Ref<InputEventMouseMotion> motion = p_event; motion.is_valid()) {
		GrassWorld *world = _grass.find_world();
		const PaintedFields asked = world != nullptr ? *find_painted() : painted_neighbours(_grass.find_field());
		if (const auto point = pick_ground(asked, p_camera, motion->get_position(), ASKED_AROUND)) {
			_ring.show(asked, p_camera, *point, { ASKED_RADIUS, 1.0, ASKED_COLOR });
			const Vector3 place = to_godot(Eigen::Vector3d(asked.space * point->position));
			GrassField *field = world != nullptr ? world->get_field_at(place) : find_asked(asked, place);
			_answer.show(p_camera, motion->get_position(), field != nullptr ? answer_of(asked, field, place, p_camera) : NOT_IN_MEMORY);
		} else {
			_ring.hide();
			_answer.hide();
		}
	}
	const Ref<InputEventMouseButton> button = p_event;
	const bool is_click = button.is_valid() && button->get_button_index() == MOUSE_BUTTON_LEFT && !button->is_alt_pressed();
	return is_click ? AFTER_GUI_INPUT_STOP : AFTER_GUI_INPUT_PASS;
}

int32_t GrassEditorPlugin::key_input(Camera3D *p_camera, const Ref<InputEventKey> &p_key) {
	if (const Key code = p_key->get_keycode(); code == KEY_CTRL || code == KEY_META || code == KEY_SHIFT) { // they change the brush
		StrokeKeys keys = keys_of(p_key.ptr());
		(code == KEY_SHIFT ? keys.smooth : keys.opposite) = p_key->is_pressed();
		if (_ring.is_shown() && !_stroke.is_active()) {
			show_brush(p_camera, _mouse, keys);
		}
		return AFTER_GUI_INPUT_PASS;
	}
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
	if (clipboard_key(p_camera, **p_key)) {
		return AFTER_GUI_INPUT_STOP;
	}
	// Where a bracket needs AltGr, the keys at the brackets' US positions work as well.
	const auto is_key = [&](Key p_code) { return p_key->get_keycode() == p_code || p_key->get_physical_keycode() == p_code; };
	const int notches = int(is_key(KEY_BRACKETRIGHT)) - int(is_key(KEY_BRACKETLEFT));
	if (notches == 0 || p_key->is_alt_pressed()) {
		if (p_key->is_command_or_control_pressed() && p_key->get_keycode() != KEY_CTRL && p_key->get_keycode() != KEY_META) {
			finish_stroke(); // undo, save and other commands act on whole strokes
		}
		return AFTER_GUI_INPUT_PASS;
	}
	using Toolbar = BrushToolbar;
	const bool ctrl = p_key->is_command_or_control_pressed(), shift = p_key->is_shift_pressed();
	_toolbar->nudge(ctrl ? (shift ? Toolbar::NUMBER_TARGET : Toolbar::NUMBER_STRENGTH)
						 : (shift ? Toolbar::NUMBER_HARDNESS : Toolbar::NUMBER_RADIUS),
			notches);
	if (_ring.is_shown()) {
		show_brush(p_camera, _mouse, {}); // Ctrl and Shift belong to the brackets here
	}
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
		if (p_button->is_alt_pressed()) { // turns the view, if the editor is configured for that
			return AFTER_GUI_INPUT_PASS;
		}
		finish_stroke();
		const auto point = show_brush(p_camera, p_button->get_position(), keys_of(p_button.ptr()), false);
		if (point && _grass.may_change()) {
			finish_ground();
			_stroke.begin(*find_painted(), _toolbar->get_brush(), *point, keys_of(p_button.ptr()), _toolbar->follows_ground());
		}
		return AFTER_GUI_INPUT_STOP;
	}
	// With Shift, some systems report a sideways turn of the wheel.
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
		show_brush(p_camera, p_button->get_position(), {}); // Ctrl and Shift belong to the wheel here
	}
	return AFTER_GUI_INPUT_STOP;
}

int32_t GrassEditorPlugin::motion_input(Camera3D *p_camera, const Ref<InputEventMouseMotion> &p_motion) {
	_mouse = p_motion->get_position();
	const auto point = show_brush(p_camera, _mouse, keys_of(p_motion.ptr()), !_stroke.is_active());
	if (!_stroke.is_active()) {
		return AFTER_GUI_INPUT_PASS;
	}
	if (!p_motion->get_button_mask().has_flag(MOUSE_BUTTON_MASK_LEFT)) { // the button was released outside our window
		finish_stroke();
		return AFTER_GUI_INPUT_PASS;
	}
	if (point) {
		StrokeKeys keys = keys_of(p_motion.ptr());
		keys.pressure = p_motion->get_pressure() > 0.0 ? double(p_motion->get_pressure()) : 1.0; // a mouse reports none
		_stroke.move(*find_painted(), *point, keys);
	}
	return AFTER_GUI_INPUT_STOP;
}

std::optional<GroundPoint> GrassEditorPlugin::show_brush(
		Camera3D *p_camera, const Vector2 &p_mouse, const StrokeKeys &p_keys, bool p_is_hover) {
	const std::optional<PaintedFields> painted = find_painted();
	const Ref<GrassBrush> brush = _toolbar->get_brush();
	const double radius = brush->get_param(BRUSH_RADIUS);
	const auto point = painted ? pick_ground(*painted, p_camera, p_mouse, radius) : std::nullopt;
	if (!point) {
		hide_brush();
		return {};
	}
	const StrokeStep touch{ point->place(), point->place() };
	const Brush does = *brush_for(**brush, touch, p_keys, brush->get_species());
	RingView::Look look{ radius, brush->get_param(BRUSH_HARDNESS), _toolbar->get_tool_color(does.tool) };
	if (p_is_hover) {
		look.strength = does.strength;
		look.shape = brush->get_stroke(touch.from, touch.to);
		_preview.show(*painted, **brush, *point, p_keys);
	} else {
		_preview.hide();
	}
	_ring.show(*painted, p_camera, *point, look);
	return point;
}

void GrassEditorPlugin::hide_brush() {
	_ring.hide();
	_preview.hide();
}

} // namespace grass
