// SPDX-License-Identifier: MIT
#include "editor/brush_tools.h"

#include "editor/paint_stroke.h"
#include "editor/tool_info.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_settings.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/input_event_key.hpp>
#include <godot_cpp/classes/shortcut.hpp>
#include <godot_cpp/classes/v_separator.hpp>

using namespace godot;

namespace grass {

namespace {

// Returns what the editor's settings list as a shortcut, with the user's key if there is one.
Ref<Shortcut> shortcut_of(const char *p_name, Key p_key) {
	Ref<InputEventKey> key;
	key.instantiate();
	key->set_keycode(p_key);
	Array events;
	events.push_back(key);
	Ref<Shortcut> shortcut;
	shortcut.instantiate();
	shortcut->set_name(p_name);
	shortcut->set_events(events);
	Ref<EditorSettings> settings = EditorInterface::get_singleton()->get_editor_settings();
	settings->add_shortcut(shortcut_path(p_name), shortcut);
	return settings->get_shortcut(shortcut_path(p_name));
}

} // namespace

Ref<Texture2D> themed_icon(const char *p_svg, const Color &p_text) {
	Ref<Image> image;
	image.instantiate();
	image->load_svg_from_string(
			String(p_svg).replace("#e0e0e0", "#" + p_text.to_html(false)), real_t(EditorInterface::get_singleton()->get_editor_scale()));
	return ImageTexture::create_from_image(image);
}

void BrushTools::create(Control *p_toolbar, const Callable &p_toggled) {
	_group.instantiate();
	_group->set_allow_unpress(true);
	for (const ToolInfo &info : TOOLS) {
		_tools.push_back(memnew(Button));
		const String tooltip = String(info.tooltip) + "\nShift: smooth. Esc: put the brush down.";
		add(p_toolbar, _tools.back(), name_of(info.tool), info.key, tooltip, p_toggled);
	}
	p_toolbar->add_child(memnew(VSeparator));
	_why = memnew(Button);
	add(p_toolbar, _why, "Why", WHY_KEY, "Why is there no grass here? Point at a place.\nEsc: stop asking.", p_toggled);
}

void BrushTools::add(
		Control *p_toolbar, Button *p_button, const char *p_name, Key p_key, const String &p_tooltip, const Callable &p_toggled) {
	p_button->set_name(p_name);
	p_button->set_toggle_mode(true);
	p_button->set_button_group(_group);
	p_button->set_theme_type_variation("FlatButton");
	p_button->set_focus_mode(Control::FOCUS_NONE); // keys stay with the view
	p_button->set_tooltip_text(p_tooltip); // below the shortcut's name and key
	p_button->set_shortcut(shortcut_of(p_name, p_key));
	p_button->connect("toggled", p_toggled);
	p_toolbar->add_child(p_button);
}

std::optional<GrassBrush::Tool> BrushTools::get_pressed() const {
	for (size_t i = 0; i < _tools.size(); i++) {
		if (_tools[i]->is_pressed()) {
			return TOOLS[i].tool;
		}
	}
	return {};
}

Button *BrushTools::find_button(GrassBrush::Tool p_tool) const {
	for (size_t i = 0; i < _tools.size(); i++) {
		if (TOOLS[i].tool == p_tool) {
			return _tools[i];
		}
	}
	return nullptr;
}

void BrushTools::press(GrassBrush::Tool p_tool) {
	find_button(p_tool)->set_pressed(true);
}

void BrushTools::release() {
	for (Button *button : _tools) {
		button->set_pressed(false);
	}
	_why->set_pressed(false);
}

void BrushTools::set_context(Node *p_context) {
	for (Button *button : _tools) {
		button->set_shortcut_context(p_context);
	}
	_why->set_shortcut_context(p_context);
}

void BrushTools::load_icons(const Color &p_text) {
	for (size_t i = 0; i < _tools.size(); i++) {
		_tools[i]->set_button_icon(themed_icon(TOOLS[i].icon, p_text));
	}
	_why->set_button_icon(themed_icon(icon::WHY, p_text));
}

} // namespace grass
