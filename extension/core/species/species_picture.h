// SPDX-License-Identifier: MIT
// Draws a small picture of a species for the editor: some of its blades side by side, as an artist would sketch them.
#pragma once

#include "core/blades/patch.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace grass {

struct PictureLook {
	std::vector<Eigen::Vector3f> colors; // from root to tip, linear; at least one
	Eigen::Vector3f dry_color = Eigen::Vector3f::Zero(); // linear
	float dry = 0.0f; // 0..1
	std::span<const uint8_t> card, leaf; // RGBA8, sRGB, card_side squared texels each; empty: none
	int card_side = 0;
	Eigen::Vector3f card_color = Eigen::Vector3f::Ones(); // multiplies the card's colours, linear
	float card_share = 0.0f; // of the blades
	float card_width = 0.0f, card_height = 0.0f, leaf_size = 0.0f; // metres
};

// Returns RGBA8, sRGB, p_side squared texels, transparent where there is no blade. The tallest blades fill the height. A patch without
// blades leaves the picture transparent.
std::vector<uint8_t> draw_species(const PatchParams &p_patch, const PictureLook &p_look, int p_side);

} // namespace grass
