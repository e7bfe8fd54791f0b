// SPDX-License-Identifier: MIT
// Histograms of the colours that a blade of grass shows up close (paper 3.2), one for each kind of leaf. They are our own: set by hand and
// judged in pictures, not measured on plants. Each entry gives a colour, as a multiple of the leaf's mean colour in linear light, and the
// share of the leaf that has it; leaf_pictures.cpp makes the mean exact. Sorted as the pictures use them: from the furrows beside the veins
// to the withered parts.
#pragma once

#include <array>

namespace grass {

struct LeafTone {
	float share; // of the leaf, 0..1; the shares of one kind add up to 1
	float red, green, blue;
};

// Fresh: dark furrows, green between the veins, pale ridges, a little yellow.
inline constexpr std::array<LeafTone, 8> FRESH_LEAF = { {
		{ 0.06f, 0.52f, 0.56f, 0.60f },
		{ 0.14f, 0.74f, 0.78f, 0.80f },
		{ 0.24f, 0.90f, 0.93f, 0.92f },
		{ 0.26f, 1.02f, 1.03f, 1.00f },
		{ 0.18f, 1.16f, 1.13f, 1.08f },
		{ 0.08f, 1.34f, 1.24f, 1.24f },
		{ 0.03f, 1.62f, 1.36f, 1.40f },
		{ 0.01f, 1.90f, 1.20f, 1.10f },
} };

// Ageing: the same, with yellow, straw and the brown of spots and tips.
inline constexpr std::array<LeafTone, 10> AGEING_LEAF = { {
		{ 0.06f, 0.50f, 0.58f, 0.60f },
		{ 0.14f, 0.70f, 0.78f, 0.80f },
		{ 0.24f, 0.86f, 0.95f, 0.92f },
		{ 0.24f, 1.00f, 1.06f, 1.00f },
		{ 0.12f, 1.18f, 1.16f, 1.06f },
		{ 0.07f, 1.48f, 1.22f, 1.10f },
		{ 0.05f, 1.86f, 1.28f, 1.30f },
		{ 0.04f, 2.10f, 1.26f, 1.60f },
		{ 0.025f, 1.50f, 0.78f, 1.00f },
		{ 0.015f, 0.80f, 0.40f, 0.60f },
} };

} // namespace grass
