// SPDX-License-Identifier: MIT
// Numbers and colours that go to the blade shader unchanged: the property has the same name as the uniform (shaders/draw/blade.gdshader
// explains each).
#pragma once

#include "core/base/tunable.h"

#include <array>

namespace grass {

// A colour in sRGB.
struct NamedColor {
	const char *name;
	float red, green, blue;
};

// Colours of a species.
inline constexpr NamedColor ROOT_COLOR{ "root_color", 0.24f, 0.35f, 0.12f };
inline constexpr NamedColor TIP_COLOR{ "tip_color", 0.48f, 0.60f, 0.22f };
inline constexpr NamedColor DRY_COLOR{ "dry_color", 0.66f, 0.60f, 0.34f };
// Colours of a field.
inline constexpr std::array FIELD_COLORS = {
	NamedColor{ "soil_color", 0.22f, 0.20f, 0.12f },
};

// Textures of a field's soil, each with a property and a uniform of its own; and the metres that they span.
inline constexpr std::array SOIL_TEXTURES = { "soil_albedo", "soil_normal", "soil_roughness" };
inline constexpr Tunable SOIL_SCALE{ "soil_scale", "m", 0.1, 100.0, 0.1, 2.0 };
// How much soil a field has where its map has no grass. 0: the floor below shows.
inline constexpr Tunable BARE_SOIL{ "bare_soil", "", 0.0, 1.0, 0.01, 0.0 };

// Share of dryness in tips and light clumps.
inline constexpr Tunable DRY{ "dry", "", 0.0, 1.0, 0.01, 0.25 };
// How much the hue of the fresh colour differs from clump to clump, from yellow to blue.
inline constexpr Tunable HUE_VARIATION{ "hue_variation", "", 0.0, 1.0, 0.01, 0.0 };
// Width of the border in which a field gets thinner and lower. 0: it ends abruptly, for adjacent fields.
inline constexpr Tunable BORDER_FADE{ "border_fade", "m", 0.0, 10.0, 0.1, 1.0 };
// How ragged the border is. 0: it follows the field's sides, as in scenes that are older than this number.
inline constexpr Tunable BORDER_WAVER{ "border_waver", "", 0.0, 1.0, 0.01, 0.0 };
// How dark the ground between the densest blades is. Use less for sparse lawns.
inline constexpr Tunable ROOT_SHADE{ "root_shade", "", 0.0, 1.0, 0.01, 0.8 };
// Share of the light on one face that leaves the other.
inline constexpr Tunable BACK_LIGHT{ "back_light", "", 0.0, 1.0, 0.01, 0.75 };
// How much of their colour roots, soil and distant grass take from the field's terrain_texture. 1: far away all of it, so that the grass
// matches the terrain beyond the field.
inline constexpr Tunable TERRAIN_BLEND{ "terrain_blend", "", 0.0, 1.0, 0.01, 0.7 };
// Strength and Phong exponent of the highlight.
inline constexpr Tunable SHEEN{ "sheen", "", 0.0, 1.0, 0.01, 0.12 };
inline constexpr Tunable GLOSS{ "gloss", "", 1.0, 128.0, 1.0, 18.0 };
// Weather, used only by a field's surface_hook: how wet the grass is, and how much snow covers it.
inline constexpr Tunable WETNESS{ "wetness", "", 0.0, 1.0, 0.01, 0.0 };
inline constexpr Tunable SNOW{ "snow", "", 0.0, 1.0, 0.01, 0.0 };
// 0: blades of a thinned tile keep their width; 1: they cover as much as all blades would.
inline constexpr Tunable THIN_WIDENING{ "thin_widening", "", 0.0, 1.0, 0.01, 1.0 };

} // namespace grass
