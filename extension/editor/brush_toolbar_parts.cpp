// SPDX-License-Identifier: MIT
// Makes the toolbar's controls: buttons, sliders, the panel of limits, the menu. brush_toolbar.cpp has their behaviour.
#include "editor/brush_toolbar.h"

#include "editor/paint_stroke.h"
#include "editor/tool_info.h"
#include "shared/text.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/grid_container.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/popup_menu.hpp>
#include <godot_cpp/classes/v_separator.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr double WIDE = 118.0, NARROW = 92.0; // of sliders, in the editor's unscaled pixels

double editor_scale() {
	return EditorInterface::get_singleton()->get_editor_scale();
}

} // namespace

BrushToolbar::BrushToolbar() {
	_brush.instantiate();
	add_tools();
	add_child(memnew(VSeparator));
	add_numbers();
	add_limits();
	add_child(memnew(VSeparator));
	_why = memnew(Button);
	add_tool(_why, "Why", "Why is there no grass here? Point at a place.\nEsc: stop asking.");
	add_bake();
	add_menu();
	_brush->connect("changed", callable_mp(this, &BrushToolbar::show_brush));
	show_brush();
}

void BrushToolbar::add_tools() {
	_group.instantiate();
	_group->set_allow_unpress(true);
	for (const ToolInfo &info : TOOLS) {
		_tools.push_back(memnew(Button));
		const char *name = name_of(info.tool);
		add_tool(_tools.back(), name, String(name) + ": " + info.tooltip + "\nShift: smooth. Esc: put the brush down.");
	}
}

void BrushToolbar::add_tool(Button *p_button, const char *p_name, const String &p_tooltip) {
	p_button->set_name(p_name);
	p_button->set_toggle_mode(true);
	p_button->set_button_group(_group);
	p_button->set_theme_type_variation("FlatButton");
	p_button->set_focus_mode(FOCUS_NONE); // keys stay with the view
	p_button->set_tooltip_text(p_tooltip);
	p_button->connect("toggled", callable_mp(this, &BrushToolbar::_tool_toggled));
	add_child(p_button);
}

EditorSpinSlider *BrushToolbar::add_slider(
		Node *p_parent, const Tunable &p_tunable, const char *p_label, const char *p_tooltip, double p_width) {
	EditorSpinSlider *slider = memnew(EditorSpinSlider);
	slider->set_name(String(p_tunable.name).to_pascal_case());
	slider->set_label(p_label);
	slider->set_suffix(unit_of(p_tunable));
	slider->set_min(p_tunable.minimum);
	slider->set_max(p_tunable.maximum);
	slider->set_step(p_tunable.step);
	slider->set_tooltip_text(p_tooltip);
	slider->set_custom_minimum_size(Vector2(real_t(p_width * editor_scale()), 0));
	slider->connect("value_changed", callable_mp(this, &BrushToolbar::_number_changed));
	p_parent->add_child(slider);
	return slider;
}

void BrushToolbar::add_slider(Node *p_parent, BrushParamId p_param, const char *p_label, const char *p_tooltip, double p_width) {
	_sliders.push_back({ p_param, add_slider(p_parent, BRUSH_PARAMS[p_param], p_label, p_tooltip, p_width) });
}

void BrushToolbar::add_numbers() {
	add_slider(this, BRUSH_RADIUS, "Radius", "Radius.\nKeys [ and ], or Ctrl + mouse wheel.", WIDE);
	slider_of(BRUSH_RADIUS)->set_exp_ratio(true);
	add_slider(this, BRUSH_STRENGTH, "Strength",
			"How far one touch moves the grass towards its target.\nCtrl + [ and ], or Ctrl + Shift + mouse wheel.", WIDE);
	add_slider(this, BRUSH_HARDNESS, "Hardness",
			"Share of the radius that gets the full strength: the inner ring.\nShift + [ and ], or Shift + mouse wheel.", WIDE);
	_stamp = memnew(Button);
	_stamp->set_name("Stamp");
	_stamp->set_custom_minimum_size(Vector2(1, 1) * real_t(28 * editor_scale()));
	_stamp->set_expand_icon(true);
	_stamp->set_focus_mode(FOCUS_NONE);
	_stamp->set_tooltip_text(
			"The picture that each touch leaves. Press it to remove the picture.\nDrop another picture on a tool to change it.");
	_stamp->connect("pressed", callable_mp(this, &BrushToolbar::_stamp_pressed));
	add_child(_stamp);
	add_slider(this, BRUSH_STAMP_ROTATION, "Turn", "Rotation of the stamp.", WIDE);
	add_slider(this, BRUSH_STAMP_RANDOM, "Random", "Maximum random rotation that is added to each stamp.", WIDE);
	constexpr const char *TARGET_TOOLTIP = "The value to which the tool brings the grass.\nCtrl + Shift + [ and ].";
	add_slider(this, BRUSH_TARGET, "", TARGET_TOOLTIP, WIDE);
	add_slider(this, BRUSH_CUT_HEIGHT, "Height", TARGET_TOOLTIP, WIDE);
	_species = memnew(SpeciesPalette);
	_species->set_name("SpeciesTarget");
	_species->connect("minimum_size_changed", callable_mp(this, &BrushToolbar::fit));
	_species->connect("item_selected", callable_mp(this, &BrushToolbar::_species_selected));
	add_child(_species);
	for (size_t i = 0; i < _tools.size(); i++) { // a species dropped on either one is added to the field
		if (TOOLS[i].tool == GrassBrush::TOOL_SPECIES) {
			for (Control *control : { static_cast<Control *>(_tools[i]), static_cast<Control *>(_species) }) {
				control->set_drag_forwarding(
						Callable(), callable_mp(this, &BrushToolbar::_can_take_dragged), callable_mp(this, &BrushToolbar::_take_dragged));
			}
			continue;
		}
		_tools[i]->set_drag_forwarding(
				Callable(), callable_mp(this, &BrushToolbar::_can_take_picture), callable_mp(this, &BrushToolbar::_take_picture));
	}
	_stamp->set_drag_forwarding(
			Callable(), callable_mp(this, &BrushToolbar::_can_take_picture), callable_mp(this, &BrushToolbar::_take_picture));
	_color = memnew(ColorPickerButton);
	_color->set_name("Color");
	_color->set_custom_minimum_size(Vector2(real_t(40 * editor_scale()), 0));
	_color->set_edit_alpha(false);
	_color->set_tooltip_text("Colour of the blades.");
	_color->connect("color_changed", callable_mp(_brush.ptr(), &GrassBrush::set_color));
	add_child(_color);
	_channel = memnew(OptionButton);
	_channel->set_name("Channel");
	_channel->set_tooltip_text("What the brush evens out.");
	for (const ChannelName &smoothed : SMOOTHED) {
		_channel->add_item(smoothed.name, smoothed.channel);
	}
	_channel->connect("item_selected", callable_mp(this, &BrushToolbar::_channel_selected));
	add_child(_channel);
}

void BrushToolbar::add_limits() {
	_limits = memnew(Button);
	_limits->set_name("Limits");
	_limits->set_theme_type_variation("FlatButton");
	_limits->set_tooltip_text("Paint only ground within a range of slope and height.");
	_limits->connect("pressed", callable_mp(this, &BrushToolbar::_limits_pressed));
	add_child(_limits);
	_limits_panel = memnew(PopupPanel);
	_limits->add_child(_limits_panel);
	GridContainer *grid = memnew(GridContainer);
	grid->set_columns(2);
	_limits_panel->add_child(grid);
	add_slider(grid, BRUSH_SLOPE_MIN, "Slope from", "The smallest slope that is painted.", 1.5 * WIDE);
	add_slider(grid, BRUSH_SLOPE_MAX, "to", "The largest slope that is painted.", NARROW);
	add_slider(grid, BRUSH_HEIGHT_MIN, "Height from", "The lowest ground that is painted, above the field's own height.", 1.5 * WIDE);
	add_slider(grid, BRUSH_HEIGHT_MAX, "to", "The highest ground that is painted, above the field's own height.", NARROW);
}

void BrushToolbar::add_bake() {
	_bake = memnew(Button);
	_bake->set_name("Bake");
	_bake->set_text("Bake Ground");
	_bake->set_theme_type_variation("FlatButton");
	_bake->set_focus_mode(FOCUS_NONE);
	_bake->set_tooltip_text("Reads the ground under the whole field from collision shapes, so that the grass grows on it.\nPainting does "
							"this under the brush. It is done again where the ground or the field was moved.");
	_bake->connect("pressed", callable_mp(this, &BrushToolbar::_bake_pressed));
	add_child(_bake);
}

void BrushToolbar::add_menu() {
	_menu = memnew(MenuButton);
	_menu->set_name("Menu");
	_menu->set_flat(true);
	_menu->set_tooltip_text("The whole field.");
	PopupMenu *popup = _menu->get_popup();
	const auto add = [&](MenuItem p_item, const String &p_text, const char *p_tooltip) {
		popup->add_item(p_text, p_item);
		popup->set_item_tooltip(popup->get_item_index(p_item), p_tooltip);
	};
	add(MENU_BARE, "Bare Field", "Only what you paint from now on grows.");
	add(MENU_FULL, "Full Field", "Grass grows everywhere except where you erase it from now on.");
	popup->add_separator();
	popup->add_item("Clear Everything Painted", MENU_CLEAR);
	add(MENU_UNIQUE, "Make Unique",
			"Gives the field copies of its own of the map, and of the rule, species and patches that are not files.");
	popup->add_separator();
	add(MENU_EXPORT, String::utf8("Export Picture\u2026"), "Saves a channel of the map as PNG or EXR.");
	add(MENU_IMPORT, String::utf8("Import Picture\u2026"), "Reads a PNG or an EXR into a channel of the map.");
	popup->add_separator();
	const auto add_check = [&](MenuItem p_item, const char *p_text, const char *p_tooltip) {
		popup->add_check_item(p_text, p_item);
		popup->set_item_checked(popup->get_item_index(p_item), true);
		popup->set_item_tooltip(popup->get_item_index(p_item), p_tooltip);
	};
	add_check(MENU_FOLLOW, "Bake Ground by Itself", "Reads the ground under the brush, and wherever the ground or the field was moved.");
	add_check(MENU_NEIGHBOURS, "Paint Neighbours",
			"The brush paints all fields that it reaches, each on its own map, except locked and hidden ones.");
	popup->connect("id_pressed", callable_mp(this, &BrushToolbar::_menu_pressed));
	add_child(_menu);
}

// The icons are drawn for a dark theme; their light parts take the colour of the theme's text.
void BrushToolbar::load_icons() {
	const String text_color = "#" + get_theme_color("font_color", "Button").to_html(false);
	const auto icon_of = [&](const char *p_svg) {
		Ref<Image> image;
		image.instantiate();
		image->load_svg_from_string(String(p_svg).replace("#e0e0e0", text_color), real_t(editor_scale()));
		return ImageTexture::create_from_image(image);
	};
	for (size_t i = 0; i < _tools.size(); i++) {
		_tools[i]->set_button_icon(icon_of(TOOLS[i].icon));
	}
	_why->set_button_icon(icon_of(icon::WHY));
	_limits->set_button_icon(get_theme_icon("AnimationFilter", "EditorIcons"));
	_bake->set_button_icon(icon_of(icon::BAKE));
	_menu->set_button_icon(get_theme_icon("GuiTabMenuHl", "EditorIcons"));
}

} // namespace grass
