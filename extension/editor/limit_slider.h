// SPDX-License-Identifier: MIT
// A slider for one end of a range. At its own end it reads "any", since there it limits nothing.
#pragma once

#include <godot_cpp/classes/editor_spin_slider.hpp>

namespace grass {

class LimitSlider : public godot::EditorSpinSlider {
	GDCLASS(LimitSlider, godot::EditorSpinSlider)

public:
	enum Side { LOWEST, HIGHEST };

	static LimitSlider *create(Side p_side);

	bool is_any() const; // at its end
	void _draw() override; // over what the engine has drawn

protected:
	static void _bind_methods();

private:
	Side _side = LOWEST;
};

} // namespace grass
