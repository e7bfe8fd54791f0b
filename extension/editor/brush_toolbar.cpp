// SPDX-License-Identifier: MIT
// The toolbar's behaviour. Its controls are made in brush_toolbar_parts.cpp.
#include "editor/brush_toolbar.h"

#include "core/paint/brush_keys.h"
#include "editor/species_drop.h"
#include "editor/tool_info.h"

#include <godot_cpp/classes/editor_interface.hpp>
#include <godot_cpp/classes/sub_viewport.hpp>
#include <godot_cpp/classes/window.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <algorithm>

using namespace godot;

namespace grass {

namespace {

// In the editor's unscaled pixels: the part of the window that docks occupy, the least width that is left to the toolbar, and the margin
// of what lies over the view.
constexpr real_t DOCKS = 540, NARROWEST = 480, MARGIN = 8;

} // namespace

void BrushToolbar::_notification(int p_what) {
	if (p_what == NOTIFICATION_THEME_CHANGED) {
		load_icons();
		fit();
	} else if (p_what == NOTIFICATION_ENTER_TREE) {
		Node *editor = this; // as for its own tools: their keys work while the 3D editor has the focus
		while (editor != nullptr && editor->get_class() != "Node3DEditor") {
			editor = editor->get_parent();
		}
		_tools.set_context(editor);
		get_window()->connect("size_changed", callable_mp(this, &BrushToolbar::fit));
	} else if (p_what == NOTIFICATION_EXIT_TREE) {
		get_window()->disconnect("size_changed", callable_mp(this, &BrushToolbar::fit));
	}
}

void BrushToolbar::fit() {
	if (!is_inside_tree()) {
		return;
	}
	const real_t gap = real_t(get_theme_constant("h_separation", "FlowContainer"));
	const Control *stamps[] = { _stamp, _numbers.of(BRUSH_STAMP_ROTATION), _numbers.of(BRUSH_STAMP_RANDOM) };
	real_t width = -gap;
	for (const Control *control : stamps) {
		width += control->get_combined_minimum_size().x + gap;
	}
	_numbers.of(BRUSH_HARDNESS)->set_custom_minimum_size(Vector2(width, 0)); // which takes their place
	_shape->set_custom_minimum_size(Vector2(width, 0));
	const real_t color = _color->is_visible() ? _color->get_combined_minimum_size().x + gap : real_t(0);
	_numbers.of(BRUSH_TARGET)->set_custom_minimum_size(Vector2(_no_target->get_combined_minimum_size().x - color, 0));
	real_t rows[2] = { -gap, -gap }, tallest = 0;
	for (int32_t i = 0; i < get_child_count(); i++) {
		const Control *control = Object::cast_to<Control>(get_child(i));
		const bool is_in_row = control->is_visible() && !control->is_set_as_top_level() && control != _row_end;
		rows[i > _row_end->get_index() ? 1 : 0] += is_in_row ? control->get_combined_minimum_size().x + gap : real_t(0);
		tallest = std::max(tallest, control->is_set_as_top_level() ? real_t(0) : control->get_combined_minimum_size().y);
	}
	const real_t widest = std::max(rows[0] + gap, rows[1]);
	_row_end->set_custom_minimum_size(Vector2(std::max(real_t(0), widest - rows[0] - gap), tallest)); // nothing else has room beside it
	for (const BrushParamId param : { BRUSH_RADIUS, BRUSH_HARDNESS, BRUSH_STAMP_ROTATION, BRUSH_STAMP_RANDOM }) {
		_numbers.of(param)->set_custom_minimum_size(Vector2(_numbers.of(param)->get_custom_minimum_size().x, tallest));
	}
	const real_t scale = real_t(EditorInterface::get_singleton()->get_editor_scale());
	const real_t room = std::max(real_t(get_window()->get_size().x) - DOCKS * scale, NARROWEST * scale);
	set_custom_minimum_size(Vector2(std::min(widest, room), 0));
}

void BrushToolbar::show_brush() {
	if (_showing) {
		return;
	}
	_showing = true; // sliders notify of each change
	const GrassBrush::Tool tool = _brush->get_tool();
	const ToolInfo &info = info_of(tool);
	_numbers.show(**_brush);
	_species->show_species(_brush->get_species());
	_color->set_pick_color(_brush->get_color());
	_channel->select(_channel->get_item_index(int32_t(_brush->get_channel())));
	_numbers.of(BRUSH_TARGET)->set_label(info.target == nullptr ? "" : info.target);
	const bool own_target = tool == GrassBrush::TOOL_CUT || tool == GrassBrush::TOOL_SPECIES;
	_numbers.of(BRUSH_TARGET)->set_visible(info.target != nullptr && !own_target);
	_numbers.of(BRUSH_CUT_HEIGHT)->set_visible(tool == GrassBrush::TOOL_CUT);
	const bool has_stamp = _brush->get_stamp().is_valid();
	_stamp->set_button_icon(_brush->get_stamp());
	_stamp->set_visible(has_stamp);
	_numbers.of(BRUSH_HARDNESS)->set_visible(!has_stamp);
	_numbers.of(BRUSH_STAMP_ROTATION)->set_visible(has_stamp);
	_numbers.of(BRUSH_STAMP_RANDOM)->set_visible(has_stamp);
	_species->set_visible(has_tool() && tool == GrassBrush::TOOL_SPECIES);
	_color->set_visible(tool == GrassBrush::TOOL_TINT);
	_channel->set_visible(tool == GrassBrush::TOOL_SMOOTH);
	_no_target->set_visible(tool == GrassBrush::TOOL_ERASE || tool == GrassBrush::TOOL_SPECIES);
	_showing = false;
	fit();
}

Color BrushToolbar::get_tool_color(MapTool p_tool) const {
	if (p_tool == MapTool::TINT) {
		return _brush->get_color();
	}
	const bool grows = p_tool == MapTool::REGROW || p_tool == MapTool::RECOVER; // reachable by keys only
	const ToolInfo &info = info_of(grows ? GrassBrush::TOOL_PAINT : GrassBrush::Tool(p_tool));
	return Color(info.red, info.green, info.blue);
}

void BrushToolbar::put_tool_down() {
	_tools.release();
}

void BrushToolbar::nudge(Number p_number, int p_notches) {
	const GrassBrush::Tool tool = _brush->get_tool();
	if (p_number == NUMBER_TARGET && tool == GrassBrush::TOOL_SPECIES) {
		const int64_t last = _species->get_count();
		_species->set_chosen();
		_brush->set_species(std::clamp<int64_t>(_brush->get_species() + p_notches, 0, last));
		return;
	}
	constexpr BrushParamId PARAMS[] = { BRUSH_RADIUS, BRUSH_HARDNESS, BRUSH_STRENGTH, BRUSH_TARGET };
	const bool cuts = p_number == NUMBER_TARGET && tool == GrassBrush::TOOL_CUT;
	const BrushParamId param = cuts ? BRUSH_CUT_HEIGHT : PARAMS[p_number];
	_brush->set_param(param, nudged(BRUSH_PARAMS[param], _brush->get_param(param), p_notches));
}

void BrushToolbar::_tool_toggled(bool) {
	if (const auto tool = _tools.get_pressed()) {
		_brush->set_tool(*tool);
	}
	show_brush();
	emit_signal("tool_changed");
}

void BrushToolbar::offer_bake(const String &p_reason) {
	_offer->set_visible(!p_reason.is_empty());
	_offer->set_text(p_reason);
}

void BrushToolbar::place_over_view() {
	const Control *view = Object::cast_to<Control>(EditorInterface::get_singleton()->get_editor_viewport_3d(0)->get_parent());
	const real_t margin = MARGIN * real_t(EditorInterface::get_singleton()->get_editor_scale());
	for (Control *control : { static_cast<Control *>(_species), static_cast<Control *>(_offer) }) {
		control->reset_size();
		control->set_global_position(view->get_global_position() + Vector2(margin, view->get_size().y - control->get_size().y - margin));
	}
}

void BrushToolbar::_number_changed(double) {
	if (_showing) {
		return;
	}
	_showing = true; // the brush notifies of each change, while other sliders are not read yet
	_numbers.take(**_brush);
	_showing = false;
	show_brush();
}

void BrushToolbar::_species_selected(int64_t p_index) {
	_species->set_chosen();
	_brush->set_species(p_index);
}

void BrushToolbar::take_species(int64_t p_species) {
	_tools.press(GrassBrush::TOOL_SPECIES);
	_species->set_chosen();
	_brush->set_species(p_species);
}

bool BrushToolbar::_can_take_dragged(const Vector2 &, const Variant &p_dragged) {
	return !find_dragged_species(p_dragged).is_empty();
}

void BrushToolbar::_take_dragged(const Vector2 &, const Variant &p_dragged) {
	emit_signal("species_dropped", find_dragged_species(p_dragged));
}

bool BrushToolbar::_can_take_picture(const Vector2 &, const Variant &p_dragged) {
	return find_dragged_picture(p_dragged).is_valid();
}

void BrushToolbar::_take_picture(const Vector2 &, const Variant &p_dragged) {
	_brush->set_stamp(find_dragged_picture(p_dragged));
}

void BrushToolbar::_stamp_pressed() {
	_brush->set_stamp(Ref<Texture2D>());
}

void BrushToolbar::show_species(const GrassField *p_field) {
	if (_brush->get_tool() != GrassBrush::TOOL_SPECIES) {
		return;
	}
	_species->show_field(p_field);
	const int64_t species = _species->fitting(_brush->get_species());
	if (species != _brush->get_species()) {
		_brush->set_species(species);
	}
	_species->show_species(species);
}

void BrushToolbar::_channel_selected(int64_t p_index) {
	_brush->set_channel(_channel->get_item_id(int32_t(p_index)));
}

void BrushToolbar::_bake_pressed() {
	emit_signal("bake_pressed");
}

void BrushToolbar::_bind_methods() {
	ADD_SIGNAL(MethodInfo("tool_changed"));
	ADD_SIGNAL(MethodInfo("bake_pressed"));
	ADD_SIGNAL(MethodInfo("species_dropped", PropertyInfo(Variant::ARRAY, "species")));
}

} // namespace grass
