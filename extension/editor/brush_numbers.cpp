// SPDX-License-Identifier: MIT
#include "editor/brush_numbers.h"

#include "shared/params.h"

#include <godot_cpp/classes/editor_interface.hpp>

using namespace godot;

namespace grass {

Vector2 scaled_width(double p_width) {
	return Vector2(real_t(p_width * EditorInterface::get_singleton()->get_editor_scale()), 0);
}

void BrushNumbers::add(
		Node *p_parent, BrushParamId p_param, const char *p_label, const char *p_tooltip, double p_width, EditorSpinSlider *p_slider) {
	const Tunable &tunable = BRUSH_PARAMS[p_param];
	p_slider->set_name(String(tunable.name).to_pascal_case());
	p_slider->set_label(p_label);
	p_slider->set_suffix(unit_of(tunable));
	p_slider->set_min(tunable.minimum);
	p_slider->set_max(tunable.maximum);
	p_slider->set_step(tunable.step);
	p_slider->set_tooltip_text(p_tooltip);
	p_slider->set_custom_minimum_size(scaled_width(p_width));
	p_slider->connect("value_changed", _changed);
	p_parent->add_child(p_slider);
	_sliders.push_back({ p_param, p_slider });
}

EditorSpinSlider *BrushNumbers::of(BrushParamId p_param) const {
	for (const Slider &entry : _sliders) {
		if (entry.param == p_param) {
			return entry.slider;
		}
	}
	return nullptr;
}

void BrushNumbers::show(const GrassBrush &p_brush) {
	for (const Slider &entry : _sliders) {
		entry.slider->set_value(p_brush.get_param(entry.param));
	}
}

void BrushNumbers::take(GrassBrush &r_brush) const {
	for (const Slider &entry : _sliders) {
		r_brush.set_param(entry.param, entry.slider->get_value());
	}
}

} // namespace grass
