// SPDX-License-Identifier: MIT
// How the species of a field look, as a texture for the blade shader: a row for each, GRASS_LOOK_TEXELS wide.
#pragma once

#include "core/layout.h"

#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/variant/color.hpp>

#include <array>
#include <span>

namespace grass {

struct SpeciesLook {
	std::array<godot::Color, GRASS_LOOK_COLORS> colors; // from root to tip, linear
	godot::Color dry_color; // linear
	float dry = 0.0f; // share of dryness in tips and light clumps
	float canopy_among_others = 0.0f, canopy_alone = 0.0f; // metres; up there a blade is as light as its tips
};

// RGBA16F.
godot::Ref<godot::ImageTexture> make_look_texture(std::span<const SpeciesLook> p_looks);

} // namespace grass
