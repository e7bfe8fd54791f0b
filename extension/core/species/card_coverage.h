// SPDX-License-Identifier: MIT
// Smaller versions of a card's texture that show as much of it as the texture itself. A card is drawn where its alpha is half or more. The
// mean of thin lines and the gaps between them is below that almost everywhere, so they would vanish with distance.
#pragma once

#include <cstdint>
#include <span>

namespace grass {

// The least alpha at which a card is drawn.
inline constexpr int CARD_THRESHOLD = 128;

// Returns the share of the texels that are drawn. p_rgba: four bytes for each texel.
double card_coverage(std::span<const uint8_t> p_rgba);

// Scales alpha so that p_coverage of the texels are drawn: those with the highest alpha; where many have the same, an even selection of
// them.
void keep_card_coverage(std::span<uint8_t> r_rgba, double p_coverage);

} // namespace grass
