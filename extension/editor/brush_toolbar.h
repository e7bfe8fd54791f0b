// SPDX-License-Identifier: MIT
// The brush's tools and numbers, in the 3D editor's menu bar while a GrassField is selected. Edits a GrassBrush, with which the plugin
// paints.
#pragma once

#include "editor/species_palette.h"
#include "resources/grass_brush.h"

#include <godot_cpp/classes/button.hpp>
#include <godot_cpp/classes/button_group.hpp>
#include <godot_cpp/classes/color_picker_button.hpp>
#include <godot_cpp/classes/editor_spin_slider.hpp>
#include <godot_cpp/classes/h_flow_container.hpp>
#include <godot_cpp/classes/menu_button.hpp>
#include <godot_cpp/classes/option_button.hpp>
#include <godot_cpp/classes/popup_panel.hpp>

#include <vector>

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
	enum MenuItem {
		MENU_BARE,
		MENU_FULL,
		MENU_CLEAR,
		MENU_FOLLOW,
		MENU_NEIGHBOURS,
		MENU_EXPORT,
		MENU_IMPORT,
		MENU_UNIQUE,
		MENU_COPY,
		MENU_PASTE,
		MENU_COPY_SPECIES,
		MENU_PASTE_SPECIES,
	};

	BrushToolbar();

	godot::Ref<GrassBrush> get_brush() const { return _brush; }
	bool has_tool() const { return _has_tool; }
	bool is_asking() const { return _why->is_pressed(); } // whether it explains why there is no grass under the cursor
	bool follows_ground() const; // whether to bake the ground under the brush, and where something moved
	bool paints_neighbours() const; // whether to paint all fields under the brush, see find_painted_fields()
	void fit_to_world(bool p_is_world); // hides tools for whole fields for a world, since only part of it is in memory
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
	struct Slider {
		BrushParamId param;
		godot::EditorSpinSlider *slider;
	};

	void add_tools();
	void add_tool(godot::Button *p_button, const char *p_name, godot::Key p_key, const godot::String &p_tooltip);
	void add_numbers();
	void add_target();
	void add_limits();
	void lay_over_view(godot::Control *p_control);
	void add_palette();
	void add_offer();
	void add_bake();
	void add_menu();
	void add_slider(godot::Node *p_parent, BrushParamId p_param, const char *p_label, const char *p_tooltip, double p_width,
			godot::EditorSpinSlider *p_slider = memnew(godot::EditorSpinSlider));
	godot::EditorSpinSlider *slider_of(BrushParamId p_param) const;
	void load_icons();
	bool is_checked(MenuItem p_item) const;
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
	void _limits_pressed();
	void _bake_pressed();
	void _menu_pressed(int64_t p_item);

	godot::Ref<GrassBrush> _brush;
	godot::Ref<godot::ButtonGroup> _group; // at most one of it is pressed
	std::vector<godot::Button *> _tools; // in the order of TOOLS
	std::vector<Slider> _sliders;
	godot::HFlowContainer *_shape = nullptr; // of the brush: hardness or stamp
	SpeciesPalette *_species = nullptr; // over the view, like the offer: above it, they would push it down
	godot::Button *_offer = nullptr;
	godot::Control *_row_end = nullptr, *_no_target = nullptr; // empty: the end of the first row; the place of a number that a tool lacks
	godot::ColorPickerButton *_color = nullptr;
	godot::OptionButton *_channel = nullptr;
	godot::Button *_limits = nullptr, *_bake = nullptr, *_why = nullptr, *_stamp = nullptr;
	godot::PopupPanel *_limits_panel = nullptr;
	godot::MenuButton *_menu = nullptr;
	bool _has_tool = false, _showing = false;
};

} // namespace grass
