// SPDX-License-Identifier: MIT
// The sliders of the brush's numbers, wherever the toolbar shows them.
#pragma once

#include "resources/grass_brush.h"

#include <godot_cpp/classes/editor_spin_slider.hpp>

#include <vector>

namespace grass {

class BrushNumbers {
public:
	// Sets p_changed, which is called with each change of a slider.
	void set_handler(const godot::Callable &p_changed) { _changed = p_changed; }
	// Adds a slider to p_parent. p_width: the editor's unscaled pixels.
	void add(godot::Node *p_parent, BrushParamId p_param, const char *p_label, const char *p_tooltip, double p_width,
			godot::EditorSpinSlider *p_slider = memnew(godot::EditorSpinSlider));
	godot::EditorSpinSlider *of(BrushParamId p_param) const;
	void show(const GrassBrush &p_brush);
	void take(GrassBrush &r_brush) const; // the values, from the sliders

private:
	struct Slider {
		BrushParamId param;
		godot::EditorSpinSlider *slider;
	};
	godot::Callable _changed;
	std::vector<Slider> _sliders;
};

// Returns a width in the editor's scaled pixels.
godot::Vector2 scaled_width(double p_width);

} // namespace grass
