// SPDX-License-Identifier: MIT
// The toolbar's buttons of which at most one is pressed: one for each tool, and one that explains why there is no grass.
#pragma once

#include "resources/grass_brush.h"

#include <godot_cpp/classes/button.hpp>
#include <godot_cpp/classes/button_group.hpp>

#include <optional>
#include <vector>

namespace grass {

class BrushTools {
public:
	// Adds the buttons to p_toolbar. p_toggled: called with each change of a button.
	void create(godot::Control *p_toolbar, const godot::Callable &p_toggled);

	std::optional<GrassBrush::Tool> get_pressed() const;
	bool is_asking() const { return _why->is_pressed(); }
	void press(GrassBrush::Tool p_tool);
	void release();
	godot::Button *find_button(GrassBrush::Tool p_tool) const;
	// Lets the buttons' keys work while p_context or a node below it has the focus.
	void set_context(godot::Node *p_context);
	void load_icons(const godot::Color &p_text); // see themed_icon()

private:
	void add(godot::Control *p_toolbar, godot::Button *p_button, const char *p_name, godot::Key p_key, const godot::String &p_tooltip,
			const godot::Callable &p_toggled);

	godot::Ref<godot::ButtonGroup> _group;
	std::vector<godot::Button *> _tools; // in the order of TOOLS
	godot::Button *_why = nullptr;
};

// Returns an icon of the add-on. The icons are drawn for a dark theme; their light parts take the colour of the theme's text.
godot::Ref<godot::Texture2D> themed_icon(const char *p_svg, const godot::Color &p_text);

} // namespace grass
