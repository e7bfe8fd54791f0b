// SPDX-License-Identifier: MIT
// Paints a GrassMap: strokes, ground, fills. Places are x, z in metres from the field's centre. The functions return the amount of the
// change in the units of BrushResult::amount.
#pragma once

#include "resources/grass_brush.h"
#include "resources/grass_fill_rule.h"
#include "resources/grass_map.h"

#include <godot_cpp/classes/image.hpp>

namespace grass {

double stroke(GrassMap &r_map, const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to);
double stroke_within(GrassMap &r_map, const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to,
		const MapRegion &p_area);
// Returns what is wrong with these arguments, as a sentence; empty: nothing.
godot::String problem_of_stroke(const godot::Ref<GrassBrush> &p_brush, const godot::Vector2 &p_from, const godot::Vector2 &p_to);
// Sets the ground's shape from heights in metres (red channel) over a rectangle. Returns false if nothing could be read.
bool set_ground(GrassMap &r_map, const godot::Ref<godot::Image> &p_heights, const godot::Rect2 &p_region);
// Fills by a rule without nodes; null: returns to the base density. Returns the square metres of full grass gained.
double fill_map(GrassMap &r_map, const godot::Ref<GrassFillRule> &p_rule, const godot::Rect2 &p_region);

// Returns what is wrong with a region, for p_use: it needs a size, and a place where a map can hold it. Empty: nothing.
godot::String problem_of_region(const char *p_use, const godot::Rect2 &p_region);

} // namespace grass
