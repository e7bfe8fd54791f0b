// SPDX-License-Identifier: MIT
#include "editor/limit_slider.h"

#include <godot_cpp/classes/font.hpp>
#include <godot_cpp/classes/style_box.hpp>
#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace grass {

LimitSlider *LimitSlider::create(Side p_side) {
	LimitSlider *slider = memnew(LimitSlider);
	slider->_side = p_side;
	return slider;
}

bool LimitSlider::is_any() const {
	return _side == LOWEST ? get_value() <= get_min() : get_value() >= get_max();
}

void LimitSlider::_draw() {
	if (!is_any()) {
		return;
	}
	const Ref<StyleBox> box = get_theme_stylebox("normal", "LineEdit");
	const Ref<Font> font = get_theme_font("font", "LineEdit");
	const int32_t size = get_theme_font_size("font_size", "LineEdit");
	const real_t below = (get_size().y - font->get_height(size)) * real_t(0.5) + font->get_ascent(size);
	const real_t left = box->get_margin(SIDE_LEFT), room = get_size().x - left - box->get_margin(SIDE_RIGHT);
	draw_style_box(box, Rect2(Vector2(), get_size()));
	draw_string(font, Vector2(left, below), get_label(), HORIZONTAL_ALIGNMENT_LEFT, room, size,
			get_theme_color("font_placeholder_color", "LineEdit"));
	draw_string(font, Vector2(left, below), "any", HORIZONTAL_ALIGNMENT_RIGHT, room, size, get_theme_color("font_color", "LineEdit"));
}

void LimitSlider::_bind_methods() {
	ClassDB::bind_method(D_METHOD("is_any"), &LimitSlider::is_any);
}

} // namespace grass
