// SPDX-License-Identifier: MIT
// Makes the toolbar's controls: buttons, sliders, the panel of limits, the menu. brush_toolbar.cpp has their behaviour.
#include "editor/brush_toolbar.h"

#include "editor/limit_slider.h"
#include "editor/paint_stroke.h"
#include "editor/tool_info.h"
#include "shared/params.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/editor_settings.hpp>
#include <godot_cpp/classes/grid_container.hpp>
#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/input_event_key.hpp>
#include <godot_cpp/classes/popup_menu.hpp>
#include <godot_cpp/classes/shortcut.hpp>
#include <godot_cpp/classes/v_separator.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// In the editor's unscaled pixels: widths of sliders, and of a button with a picture or a colour.
constexpr double WIDE = 112.0, NARROW = 92.0, TARGET = 150.0, LIMIT_WIDE = 150.0, STAMP = 28.0, COLORED = 40.0;

Vector2 wide(double p_width) {
	return Vector2(real_t(p_width * EditorInterface::get_singleton()->get_editor_scale()), 0);
}

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

BrushToolbar::BrushToolbar() {
	_brush.instantiate();
	add_tools();
	add_child(memnew(VSeparator));
	_why = memnew(Button);
	add_tool(_why, "Why", WHY_KEY, "Why is there no grass here? Point at a place.\nEsc: stop asking.");
	add_bake();
	add_menu();
	_row_end = memnew(Control);
	add_child(_row_end);
	add_numbers();
	add_target();
	add_limits();
	add_palette();
	add_offer();
	_brush->connect("changed", callable_mp(this, &BrushToolbar::show_brush));
	show_brush();
}

void BrushToolbar::add_tools() {
	_group.instantiate();
	_group->set_allow_unpress(true);
	for (const ToolInfo &info : TOOLS) {
		_tools.push_back(memnew(Button));
		add_tool(_tools.back(), name_of(info.tool), info.key, String(info.tooltip) + "\nShift: smooth. Esc: put the brush down.");
	}
}

void BrushToolbar::add_tool(Button *p_button, const char *p_name, Key p_key, const String &p_tooltip) {
	p_button->set_name(p_name);
	p_button->set_toggle_mode(true);
	p_button->set_button_group(_group);
	p_button->set_theme_type_variation("FlatButton");
	p_button->set_focus_mode(FOCUS_NONE); // keys stay with the view
	p_button->set_tooltip_text(p_tooltip); // below the shortcut's name and key
	p_button->set_shortcut(shortcut_of(p_name, p_key));
	p_button->connect("toggled", callable_mp(this, &BrushToolbar::_tool_toggled));
	add_child(p_button);
}

void BrushToolbar::add_slider(
		Node *p_parent, BrushParamId p_param, const char *p_label, const char *p_tooltip, double p_width, EditorSpinSlider *p_slider) {
	const Tunable &tunable = BRUSH_PARAMS[p_param];
	p_slider->set_name(String(tunable.name).to_pascal_case());
	p_slider->set_label(p_label);
	p_slider->set_suffix(unit_of(tunable));
	p_slider->set_min(tunable.minimum);
	p_slider->set_max(tunable.maximum);
	p_slider->set_step(tunable.step);
	p_slider->set_tooltip_text(p_tooltip);
	p_slider->set_custom_minimum_size(wide(p_width));
	p_slider->connect("value_changed", callable_mp(this, &BrushToolbar::_number_changed));
	p_parent->add_child(p_slider);
	_sliders.push_back({ p_param, p_slider });
}

void BrushToolbar::add_numbers() {
	add_slider(this, BRUSH_RADIUS, "Radius", "Radius.\nKeys [ and ], or Ctrl + mouse wheel.", WIDE);
	slider_of(BRUSH_RADIUS)->set_exp_ratio(true);
	add_slider(this, BRUSH_STRENGTH, "Strength",
			"How far one touch moves the grass towards its target.\nCtrl + [ and ], or Ctrl + Shift + mouse wheel.", WIDE);
	_shape = memnew(HFlowContainer); // stays together where the window is small
	_shape->set_name("Shape");
	add_child(_shape);
	add_slider(_shape, BRUSH_HARDNESS, "Hardness",
			"Share of the radius that gets the full strength: the inner ring.\nShift + [ and ], or Shift + mouse wheel.", WIDE);
	_stamp = memnew(Button);
	_stamp->set_name("Stamp");
	_stamp->set_custom_minimum_size(wide(STAMP));
	_stamp->set_expand_icon(true);
	_stamp->set_focus_mode(FOCUS_NONE);
	_stamp->set_tooltip_text(
			"The picture that each touch leaves. Press it to remove the picture.\nDrop another picture on a tool to change it.");
	_stamp->connect("pressed", callable_mp(this, &BrushToolbar::_stamp_pressed));
	_shape->add_child(_stamp);
	add_slider(_shape, BRUSH_STAMP_ROTATION, "Turn", "Rotation of the stamp.", NARROW);
	add_slider(_shape, BRUSH_STAMP_RANDOM, "Random", "Maximum random rotation that is added to each stamp.", NARROW);
	_stamp->set_drag_forwarding(
			Callable(), callable_mp(this, &BrushToolbar::_can_take_picture), callable_mp(this, &BrushToolbar::_take_picture));
}

// What the tool brings the grass to, in one place for all tools.
void BrushToolbar::add_target() {
	constexpr const char *TARGET_TOOLTIP = "The value to which the tool brings the grass.\nCtrl + Shift + [ and ].";
	add_slider(this, BRUSH_TARGET, "", TARGET_TOOLTIP, TARGET);
	add_slider(this, BRUSH_CUT_HEIGHT, "Height", TARGET_TOOLTIP, TARGET);
	_color = memnew(ColorPickerButton);
	_color->set_name("Color");
	_color->set_custom_minimum_size(wide(COLORED));
	_color->set_edit_alpha(false);
	_color->set_tooltip_text("Colour of the blades.");
	_color->connect("color_changed", callable_mp(_brush.ptr(), &GrassBrush::set_color));
	add_child(_color);
	_channel = memnew(OptionButton);
	_channel->set_name("Channel");
	_channel->set_custom_minimum_size(wide(TARGET));
	_channel->set_clip_text(true);
	_channel->set_fit_to_longest_item(false);
	_channel->set_tooltip_text("What the brush evens out.");
	for (const ChannelName &smoothed : SMOOTHED) {
		_channel->add_item(smoothed.name, smoothed.channel);
	}
	_channel->connect("item_selected", callable_mp(this, &BrushToolbar::_channel_selected));
	add_child(_channel);
	_no_target = memnew(Control);
	_no_target->set_custom_minimum_size(wide(TARGET));
	add_child(_no_target);
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
	const auto add = [&](BrushParamId p_param, LimitSlider::Side p_side, const char *p_label, const char *p_tooltip, double p_width) {
		add_slider(grid, p_param, p_label, p_tooltip, p_width, LimitSlider::create(p_side));
	};
	add(BRUSH_SLOPE_MIN, LimitSlider::LOWEST, "Slope from", "The smallest slope that is painted.", LIMIT_WIDE);
	add(BRUSH_SLOPE_MAX, LimitSlider::HIGHEST, "to", "The largest slope that is painted.", NARROW);
	add(BRUSH_HEIGHT_MIN, LimitSlider::LOWEST, "Height from", "The lowest ground that is painted, above the field's own height.",
			LIMIT_WIDE);
	add(BRUSH_HEIGHT_MAX, LimitSlider::HIGHEST, "to", "The highest ground that is painted, above the field's own height.", NARROW);
}

void BrushToolbar::lay_over_view(Control *p_control) {
	p_control->set_as_top_level(true);
	p_control->set_z_index(1);
	p_control->hide();
	add_child(p_control);
}

void BrushToolbar::add_palette() {
	_species = memnew(SpeciesPalette);
	_species->set_name("SpeciesTarget");
	_species->connect("item_selected", callable_mp(this, &BrushToolbar::_species_selected));
	lay_over_view(_species);
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
}

void BrushToolbar::add_offer() {
	_offer = memnew(Button);
	_offer->set_name("BakeOffer");
	_offer->set_focus_mode(FOCUS_NONE);
	_offer->set_tooltip_text("Reads the ground from collision shapes, so that the grass grows on it, as *Bake Ground* does.");
	_offer->connect("pressed", callable_mp(this, &BrushToolbar::_bake_pressed));
	lay_over_view(_offer);
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
	add(MENU_COPY, "Copy Grass", "What is painted in the field. Ctrl+C with a tool in hand copies what is under the brush.");
	add(MENU_PASTE, "Paste Grass", "Paints the field as the one that was copied. Ctrl+V with a tool in hand pastes under the brush.");
	add(MENU_COPY_SPECIES, "Copy Species", "The field's species, for another field.");
	add(MENU_PASTE_SPECIES, "Paste Species", "The field grows the copied species beside its own.");
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
		image->load_svg_from_string(
				String(p_svg).replace("#e0e0e0", text_color), real_t(EditorInterface::get_singleton()->get_editor_scale()));
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
