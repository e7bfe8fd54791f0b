// SPDX-License-Identifier: MIT
// Opens a panel with the sliders that limit where the brush paints.
#pragma once

#include "editor/brush_numbers.h"

#include <godot_cpp/classes/button.hpp>
#include <godot_cpp/classes/popup_panel.hpp>

namespace grass {

class LimitsButton : public godot::Button {
	GDCLASS(LimitsButton, godot::Button)

public:
	static LimitsButton *create(BrushNumbers &r_numbers);

protected:
	static void _bind_methods() {}

private:
	void _open();

	godot::PopupPanel *_panel = nullptr;
};

} // namespace grass
