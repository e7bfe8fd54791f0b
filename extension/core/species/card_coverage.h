// SPDX-License-Identifier: MIT
// Smaller versions of a card's texture that show as much of it as the texture itself. A card is drawn where its alpha is half or more;
// the mean of thin lines and the gaps between them is less almost everywhere, so they would vanish with the distance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace grass {

// Alpha from which on a card is drawn.
inline constexpr int CARD_THRESHOLD = 128;

// Share of the texels that are drawn. p_rgba: four bytes a texel.
double card_coverage(std::span<const uint8_t> p_rgba);

// Scales alpha so that p_coverage of the texels are drawn: those with the most of it; where many have the same, some of them, evenly.
void keep_card_coverage(std::span<uint8_t> r_rgba, double p_coverage);

} // namespace grass
