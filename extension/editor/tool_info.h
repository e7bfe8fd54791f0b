// SPDX-License-Identifier: MIT
// The brush's tools as the toolbar shows them.
#pragma once

#include "editor_icons.gen.h"
#include "resources/grass_brush.h"

#include <godot_cpp/classes/global_constants.hpp>

#include <array>

namespace grass {

struct ToolInfo {
	GrassBrush::Tool tool;
	godot::Key key; // unless the user has chosen another in the editor's settings
	const char *icon; // SVG
	const char *tooltip;
	const char *target; // name of the tool's number; null: it has none
	float red, green, blue; // of the ring
};

// Keys: letters that the 3D view has left. Digits turn its camera, as a number pad does.
inline constexpr std::array<ToolInfo, 10> TOOLS = { {
		{ GrassBrush::TOOL_PAINT, godot::KEY_P, icon::PAINT, "Plant grass; never reduces the density. Ctrl: erase.", "Density", 0.56f,
				0.94f, 0.59f },
		{ GrassBrush::TOOL_ERASE, godot::KEY_B, icon::ERASE, "Remove grass. Ctrl: paint.", nullptr, 0.99f, 0.5f, 0.5f },
		{ GrassBrush::TOOL_SMOOTH, godot::KEY_U, icon::SMOOTH, "Even out the painted values.", nullptr, 0.9f, 0.9f, 0.9f },
		{ GrassBrush::TOOL_DENSITY, godot::KEY_N, icon::DENSITY, "Bring the density to a value. Ctrl: erase.", "Density", 0.56f, 0.94f,
				0.59f },
		{ GrassBrush::TOOL_HEIGHT, godot::KEY_H, icon::HEIGHT, "Bring the blades' height to a value. Ctrl: full height.", "Height", 0.55f,
				0.65f, 0.95f },
		{ GrassBrush::TOOL_SPECIES, godot::KEY_I, icon::SPECIES,
				"Plant another species. Ctrl: as the field mixes them.\nDrop a GrassSpecies here, for example a preset, and the field "
				"grows it, too.",
				"Species", 1.0f, 0.8f, 0.37f },
		{ GrassBrush::TOOL_TINT, godot::KEY_C, icon::TINT, "Colour the blades. Ctrl: their own colour.", "Amount", 1.0f, 1.0f, 1.0f },
		{ GrassBrush::TOOL_COMB, godot::KEY_L, icon::COMB, "Lean the blades along the stroke. Ctrl: upright.", "Lean", 0.55f, 0.65f,
				0.95f },
		{ GrassBrush::TOOL_CUT, godot::KEY_G, icon::CUT, "Mow down to a height. Ctrl: let it grow again.", "Height", 0.99f, 0.5f, 0.5f },
		{ GrassBrush::TOOL_FLATTEN, godot::KEY_J, icon::FLATTEN, "Trample. Ctrl: let it recover.", "Wear", 1.0f, 0.8f, 0.37f },
} };

inline constexpr godot::Key WHY_KEY = godot::KEY_SLASH;

// Returns where the editor's settings list the key of a tool.
inline godot::String shortcut_path(const godot::String &p_tool) {
	return "grass_field/" + p_tool.to_snake_case();
}

struct ChannelName {
	MapChannel channel;
	const char *name;
};

inline constexpr std::array<ChannelName, 6> SMOOTHED = { { { MAP_DENSITY, "Density" }, { MAP_HEIGHT, "Height" }, { MAP_TINT, "Tint" },
		{ MAP_LEAN, "Lean" }, { MAP_WEAR, "Wear" }, { MAP_CUT, "Cut" } } };

inline const ToolInfo &info_of(GrassBrush::Tool p_tool) {
	for (const ToolInfo &info : TOOLS) {
		if (info.tool == p_tool) {
			return info;
		}
	}
	return TOOLS[0];
}

} // namespace grass
