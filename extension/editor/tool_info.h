// SPDX-License-Identifier: MIT
// The brush's tools as the toolbar shows them.
#pragma once

#include "editor_icons.gen.h"
#include "resources/grass_brush.h"

#include <array>

namespace grass {

struct ToolInfo {
	GrassBrush::Tool tool;
	const char *icon; // SVG
	const char *tooltip;
	const char *target; // name of the tool's number; null: it has none
	float red, green, blue; // of the ring
};

inline constexpr std::array<ToolInfo, 10> TOOLS = { {
		{ GrassBrush::TOOL_PAINT, icon::PAINT, "plant grass; never reduces the density. Ctrl: erase.", "Density", 0.56f, 0.94f, 0.59f },
		{ GrassBrush::TOOL_ERASE, icon::ERASE, "remove grass. Ctrl: paint.", nullptr, 0.99f, 0.5f, 0.5f },
		{ GrassBrush::TOOL_SMOOTH, icon::SMOOTH, "even out the painted values.", nullptr, 0.9f, 0.9f, 0.9f },
		{ GrassBrush::TOOL_DENSITY, icon::DENSITY, "bring the density to a value. Ctrl: erase.", "Density", 0.56f, 0.94f, 0.59f },
		{ GrassBrush::TOOL_HEIGHT, icon::HEIGHT, "bring the blades' height to a value. Ctrl: full height.", "Height", 0.55f, 0.65f, 0.95f },
		{ GrassBrush::TOOL_SPECIES, icon::SPECIES,
				"plant another species. Ctrl: as the field mixes them.\nDrop a GrassSpecies here, for example a preset, and the field "
				"grows it, too.",
				"Species", 1.0f, 0.8f, 0.37f },
		{ GrassBrush::TOOL_TINT, icon::TINT, "colour the blades. Ctrl: their own colour.", "Amount", 1.0f, 1.0f, 1.0f },
		{ GrassBrush::TOOL_COMB, icon::COMB, "lean the blades along the stroke. Ctrl: upright.", "Lean", 0.55f, 0.65f, 0.95f },
		{ GrassBrush::TOOL_CUT, icon::CUT, "mow down to a height. Ctrl: let it grow again.", "Height", 0.99f, 0.5f, 0.5f },
		{ GrassBrush::TOOL_FLATTEN, icon::FLATTEN, "trample. Ctrl: let it recover.", "Wear", 1.0f, 0.8f, 0.37f },
} };

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
