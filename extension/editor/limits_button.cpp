// SPDX-License-Identifier: MIT
#include "editor/limits_button.h"

#include "editor/limit_slider.h"

#include <godot_cpp/classes/grid_container.hpp>
#include <godot_cpp/variant/callable_method_pointer.hpp>

using namespace godot;

namespace grass {

namespace {

constexpr double FIRST = 150.0, SECOND = 92.0; // widths of a row's sliders, in the editor's unscaled pixels

} // namespace

LimitsButton *LimitsButton::create(BrushNumbers &r_numbers) {
	LimitsButton *button = memnew(LimitsButton);
	button->set_name("Limits");
	button->set_theme_type_variation("FlatButton");
	button->set_tooltip_text("Paint only ground within a range of slope and height.");
	button->_panel = memnew(PopupPanel);
	button->add_child(button->_panel);
	GridContainer *grid = memnew(GridContainer);
	grid->set_columns(2);
	button->_panel->add_child(grid);
	const auto add = [&](BrushParamId p_param, LimitSlider::Side p_side, const char *p_label, const char *p_tooltip, double p_width) {
		r_numbers.add(grid, p_param, p_label, p_tooltip, p_width, LimitSlider::create(p_side));
	};
	add(BRUSH_SLOPE_MIN, LimitSlider::LOWEST, "Slope from", "The smallest slope that is painted.", FIRST);
	add(BRUSH_SLOPE_MAX, LimitSlider::HIGHEST, "to", "The largest slope that is painted.", SECOND);
	add(BRUSH_HEIGHT_MIN, LimitSlider::LOWEST, "Height from", "The lowest ground that is painted, above the field's own height.", FIRST);
	add(BRUSH_HEIGHT_MAX, LimitSlider::HIGHEST, "to", "The highest ground that is painted, above the field's own height.", SECOND);
	button->connect("pressed", callable_mp(button, &LimitsButton::_open));
	return button;
}

void LimitsButton::_open() {
	const Vector2 below = get_screen_position() + Vector2(0, get_size().y);
	_panel->popup(Rect2i(Vector2i(below), Vector2i()));
}

} // namespace grass
