// SPDX-License-Identifier: MIT
// What blades look like from near: small pictures across and along a blade, made from histograms of leaf colours (paper 3.2). The blade
// shader multiplies its colours with them where a blade is some pixels wide.
#pragma once

#include "core/base/layout.h"
#include "core/blades/leaf_tones.h"

#include <cstdint>
#include <vector>

namespace grass {

// Texels of a picture: across the blade, and along it from root to tip.
inline constexpr int LEAF_ACROSS = GRASS_LEAF_ACROSS, LEAF_ALONG = 128;
// What a texel of 255 multiplies a colour with.
inline constexpr float LEAF_BRIGHTEST = float(GRASS_LEAF_BRIGHTEST);

// RGBA8, linear, LEAF_ALONG rows of LEAF_ACROSS texels: picture p_picture of GRASS_LEAF_PICTURES, of which the first half are fresh and the
// others ageing.
std::vector<uint8_t> make_leaf_picture(int p_picture);

// Of a picture.
std::span<const LeafTone> leaf_tones_of(int p_picture);

} // namespace grass
