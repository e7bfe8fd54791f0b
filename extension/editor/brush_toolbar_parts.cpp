// SPDX-License-Identifier: MIT
// Makes the toolbar's controls. brush_toolbar.cpp has their behaviour.
#include "editor/brush_toolbar.h"

#include "editor/limits_button.h"
#include "editor/tool_info.h"

#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

// In the editor's unscaled pixels: widths of sliders, and of a button with a picture or a colour.
constexpr double WIDE = 112.0, NARROW = 92.0, TARGET = 150.0, STAMP = 28.0, COLORED = 40.0;

} // namespace

BrushToolbar::BrushToolbar() {
	_brush.instantiate();
	_tools.create(this, callable_mp(this, &BrushToolbar::_tool_toggled));
	_numbers.set_handler(callable_mp(this, &BrushToolbar::_number_changed));
	add_bake();
	_menu = memnew(BrushMenu);
	add_child(_menu);
	_row_end = memnew(Control);
	add_child(_row_end);
	add_numbers();
	add_target();
	_limits = LimitsButton::create(_numbers);
	add_child(_limits);
	add_palette();
	add_offer();
	_brush->connect("changed", callable_mp(this, &BrushToolbar::show_brush));
	show_brush();
}

void BrushToolbar::add_numbers() {
	_numbers.add(this, BRUSH_RADIUS, "Radius", "Radius.\nKeys [ and ], or Ctrl + mouse wheel.", WIDE);
	_numbers.of(BRUSH_RADIUS)->set_exp_ratio(true);
	_numbers.add(this, BRUSH_STRENGTH, "Strength",
			"How far one touch moves the grass towards its target.\nCtrl + [ and ], or Ctrl + Shift + mouse wheel.", WIDE);
	_shape = memnew(HFlowContainer); // stays together where the window is small
	_shape->set_name("Shape");
	add_child(_shape);
	_numbers.add(_shape, BRUSH_HARDNESS, "Hardness",
			"Share of the radius that gets the full strength: the inner ring.\nShift + [ and ], or Shift + mouse wheel.", WIDE);
	_stamp = memnew(Button);
	_stamp->set_name("Stamp");
	_stamp->set_custom_minimum_size(scaled_width(STAMP));
	_stamp->set_expand_icon(true);
	_stamp->set_focus_mode(FOCUS_NONE);
	_stamp->set_tooltip_text(
			"The picture that each touch leaves. Press it to remove the picture.\nDrop another picture on a tool to change it.");
	_stamp->connect("pressed", callable_mp(this, &BrushToolbar::_stamp_pressed));
	_shape->add_child(_stamp);
	_numbers.add(_shape, BRUSH_STAMP_ROTATION, "Turn", "Rotation of the stamp.", NARROW);
	_numbers.add(_shape, BRUSH_STAMP_RANDOM, "Random", "Maximum random rotation that is added to each stamp.", NARROW);
	_stamp->set_drag_forwarding(
			Callable(), callable_mp(this, &BrushToolbar::_can_take_picture), callable_mp(this, &BrushToolbar::_take_picture));
}

// Adds the number that the tool brings the grass to, in one place for all tools.
void BrushToolbar::add_target() {
	constexpr const char *TARGET_TOOLTIP = "The value to which the tool brings the grass.\nCtrl + Shift + [ and ].";
	_numbers.add(this, BRUSH_TARGET, "", TARGET_TOOLTIP, TARGET);
	_numbers.add(this, BRUSH_CUT_HEIGHT, "Height", TARGET_TOOLTIP, TARGET);
	_color = memnew(ColorPickerButton);
	_color->set_name("Color");
	_color->set_custom_minimum_size(scaled_width(COLORED));
	_color->set_edit_alpha(false);
	_color->set_tooltip_text("Colour of the blades.");
	_color->connect("color_changed", callable_mp(_brush.ptr(), &GrassBrush::set_color));
	add_child(_color);
	_channel = memnew(OptionButton);
	_channel->set_name("Channel");
	_channel->set_custom_minimum_size(scaled_width(TARGET));
	_channel->set_clip_text(true);
	_channel->set_fit_to_longest_item(false);
	_channel->set_tooltip_text("What the brush evens out.");
	for (const ChannelName &smoothed : SMOOTHED) {
		_channel->add_item(smoothed.name, smoothed.channel);
	}
	_channel->connect("item_selected", callable_mp(this, &BrushToolbar::_channel_selected));
	add_child(_channel);
	_no_target = memnew(Control);
	_no_target->set_custom_minimum_size(scaled_width(TARGET));
	add_child(_no_target);
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
	for (const ToolInfo &info : TOOLS) { // a species dropped on either one is added to the field
		Button *button = _tools.find_button(info.tool);
		if (info.tool == GrassBrush::TOOL_SPECIES) {
			for (Control *control : { static_cast<Control *>(button), static_cast<Control *>(_species) }) {
				control->set_drag_forwarding(
						Callable(), callable_mp(this, &BrushToolbar::_can_take_dragged), callable_mp(this, &BrushToolbar::_take_dragged));
			}
			continue;
		}
		button->set_drag_forwarding(
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

void BrushToolbar::load_icons() {
	const Color text = get_theme_color("font_color", "Button");
	_tools.load_icons(text);
	_limits->set_button_icon(get_theme_icon("AnimationFilter", "EditorIcons"));
	_bake->set_button_icon(themed_icon(icon::BAKE, text));
	_menu->set_button_icon(get_theme_icon("GuiTabMenuHl", "EditorIcons"));
}

} // namespace grass
