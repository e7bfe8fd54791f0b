// SPDX-License-Identifier: MIT
// Pictures of blades up close: small ones, across and along a blade, made from histograms of leaf colours (paper 3.2). The blade shader
// multiplies its colours by them where a blade is several pixels wide.
#pragma once

#include "core/base/layout.h"
#include "core/blades/leaf_tones.h"

#include <cstdint>
#include <span>
#include <vector>

namespace grass {

// Texels of a picture: across the blade, and along it from root to tip.
inline constexpr int LEAF_ACROSS = GRASS_LEAF_ACROSS, LEAF_ALONG = 128;
// The factor that a texel of 255 means.
inline constexpr float LEAF_BRIGHTEST = float(GRASS_LEAF_BRIGHTEST);

// Returns picture p_picture of GRASS_LEAF_PICTURES: RGBA8, linear, LEAF_ALONG rows of LEAF_ACROSS texels. The first half of the pictures
// are fresh leaves, the others ageing ones.
std::vector<uint8_t> make_leaf_picture(int p_picture);

// Returns the histogram of a picture.
std::span<const LeafTone> leaf_tones_of(int p_picture);

} // namespace grass
