// SPDX-License-Identifier: MIT
// Numbers and colours that go to the blade shader as they are: the property's name is the uniform's
// (shaders/draw/blade.gdshader says what each does).
#pragma once

#include "core/base/tunable.h"

#include <array>

namespace grass {

// A colour in sRGB.
struct NamedColor {
	const char *name;
	float red, green, blue;
};

// Of a species.
inline constexpr NamedColor ROOT_COLOR{ "root_color", 0.24f, 0.35f, 0.12f };
inline constexpr NamedColor TIP_COLOR{ "tip_color", 0.48f, 0.60f, 0.22f };
inline constexpr NamedColor DRY_COLOR{ "dry_color", 0.66f, 0.60f, 0.34f };
// Of a field.
inline constexpr std::array FIELD_COLORS = {
	NamedColor{ "soil_color", 0.22f, 0.20f, 0.12f },
};

// Share of dryness in tips and light clumps.
inline constexpr Tunable DRY{ "dry", "", 0.0, 1.0, 0.01, 0.25 };
// Width of the border in which a field gets thinner and lower. 0: it ends at once, for fields that lie side by side.
inline constexpr Tunable BORDER_FADE{ "border_fade", "m", 0.0, 10.0, 0.1, 1.0 };
// How dark the ground between the densest blades is. Use less on sparse lawns.
inline constexpr Tunable ROOT_SHADE{ "root_shade", "", 0.0, 1.0, 0.01, 0.8 };
// Share of the light on one face that comes out of the other.
inline constexpr Tunable BACK_LIGHT{ "back_light", "", 0.0, 1.0, 0.01, 0.75 };
// How much of their colour roots, soil and far grass take from the field's terrain_texture. 1: far away all of it, as the terrain beyond
// the field has it.
inline constexpr Tunable TERRAIN_BLEND{ "terrain_blend", "", 0.0, 1.0, 0.01, 0.7 };
// Strength and Phong exponent of the highlight.
inline constexpr Tunable SHEEN{ "sheen", "", 0.0, 1.0, 0.01, 0.12 };
inline constexpr Tunable GLOSS{ "gloss", "", 1.0, 128.0, 1.0, 18.0 };
// Weather, for a field's surface_hook only: how wet the grass is, and how much snow lies on it.
inline constexpr Tunable WETNESS{ "wetness", "", 0.0, 1.0, 0.01, 0.0 };
inline constexpr Tunable SNOW{ "snow", "", 0.0, 1.0, 0.01, 0.0 };
// 0: a thinned tile's blades keep their width; 1: they cover as much as all would.
inline constexpr Tunable THIN_WIDENING{ "thin_widening", "", 0.0, 1.0, 0.01, 1.0 };

} // namespace grass
