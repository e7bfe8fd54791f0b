// SPDX-License-Identifier: MIT
// The brush's tools and numbers, in the 3D editor's menu bar while a GrassField is selected. Edits a GrassBrush, with which the plugin
// paints.
#pragma once

#include "editor/brush_menu.h"
#include "editor/brush_numbers.h"
#include "editor/brush_tools.h"
#include "editor/species_palette.h"

#include <godot_cpp/classes/color_picker_button.hpp>
#include <godot_cpp/classes/h_flow_container.hpp>
#include <godot_cpp/classes/option_button.hpp>

namespace grass {

class BrushToolbar : public godot::HFlowContainer {
	GDCLASS(BrushToolbar, godot::HFlowContainer)

public:
	// The numbers that keys and the wheel change.
	enum Number {
		NUMBER_RADIUS,
		NUMBER_HARDNESS,
		NUMBER_STRENGTH,
		NUMBER_TARGET, // of the tool
	};

	BrushToolbar();

	godot::Ref<GrassBrush> get_brush() const { return _brush; }
	bool has_tool() const { return _tools.get_pressed().has_value(); }
	bool is_asking() const { return _tools.is_asking(); } // whether it explains why there is no grass under the cursor
	// Returns whether to bake the ground under the brush, and where something moved.
	bool follows_ground() const { return _menu->is_checked(BrushMenu::FOLLOW); }
	// Returns whether to paint all fields under the brush, see painted_neighbours().
	bool paints_neighbours() const { return _menu->is_checked(BrushMenu::NEIGHBOURS); }
	BrushMenu *get_menu() { return _menu; }
	void put_tool_down(); // nothing is painted or queried until another tool is chosen
	void show_species(const GrassField *p_field); // shows the current species of the selected field
	void take_species(int64_t p_species); // selects a species to plant
	void nudge(Number p_number, int p_notches);
	void offer_bake(const godot::String &p_reason); // over the 3D view; empty: it is not offered
	void place_over_view(); // keeps what lies over the view in its corner. Must be called in each frame in which the toolbar is visible
	godot::Color get_tool_color(MapTool p_tool) const; // for the ring: colour of the current tool, or of what the held keys make of it

protected:
	static void _bind_methods();
	void _notification(int p_what);

private:
	void add_numbers();
	void add_target();
	void lay_over_view(godot::Control *p_control);
	void add_palette();
	void add_offer();
	void add_bake();
	void load_icons();
	void fit(); // two rows, or more in a small window: nothing moves, whichever tool is chosen
	void show_brush(); // copies the brush's properties to the controls
	void _tool_toggled(bool p_pressed);
	void _number_changed(double p_value);
	void _species_selected(int64_t p_index);
	bool _can_take_dragged(const godot::Vector2 &p_place, const godot::Variant &p_dragged);
	void _take_dragged(const godot::Vector2 &p_place, const godot::Variant &p_dragged);
	bool _can_take_picture(const godot::Vector2 &p_place, const godot::Variant &p_dragged);
	void _take_picture(const godot::Vector2 &p_place, const godot::Variant &p_dragged);
	void _channel_selected(int64_t p_index);
	void _stamp_pressed();
	void _bake_pressed();

	godot::Ref<GrassBrush> _brush;
	BrushTools _tools;
	BrushNumbers _numbers;
	godot::HFlowContainer *_shape = nullptr; // of the brush: hardness or stamp
	SpeciesPalette *_species = nullptr; // over the view, like the offer: above it, they would push it down
	godot::Button *_offer = nullptr;
	godot::Control *_row_end = nullptr, *_no_target = nullptr; // empty: the end of the first row; the place of a number that a tool lacks
	godot::ColorPickerButton *_color = nullptr;
	godot::OptionButton *_channel = nullptr;
	godot::Button *_limits = nullptr, *_bake = nullptr, *_stamp = nullptr;
	BrushMenu *_menu = nullptr;
	bool _showing = false;
};

} // namespace grass
