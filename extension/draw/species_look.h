// SPDX-License-Identifier: MIT
// How the species of a field look, as a texture for the blade shader: a row for each, GRASS_LOOK_TEXELS wide.
#pragma once

#include "core/base/layout.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/classes/texture2d_array.hpp>
#include <godot_cpp/variant/color.hpp>

#include <array>
#include <span>

namespace grass {

struct SpeciesLook {
	std::array<godot::Color, GRASS_LOOK_COLORS> colors; // from root to tip, linear
	godot::Color dry_color; // linear
	float dry = 0.0f; // share of dryness in tips and light clumps
	godot::Ref<godot::Image> card; // flower or seed head at the tip, of read_card(); null: none
	godot::Color card_color; // times the card's, linear
	float card_share = 0.0f; // of the blades
	float card_width = 0.0f, card_height = 0.0f; // metres
	float blade_area = 0.0f; // that a mean blade covers, m^2
	float canopy_among_others = 0.0f, canopy_alone = 0.0f; // metres; up there a blade is as light as its tips
};

// The cards of species as the layers of one texture, RGBA8, Cards::SIDE texels a side, and what looks read of them.
struct Cards {
	static constexpr int SIDE = 256; // texels
	std::array<godot::Ref<godot::Image>, GRASS_MAX_SPECIES> images; // that they were made of
	godot::Ref<godot::Texture2DArray> textures; // null: there is none
	std::array<int, GRASS_MAX_SPECIES> layers; // or GRASS_NO_CARD
	std::array<godot::Color, GRASS_MAX_SPECIES> colors; // linear, the mean of what is opaque; alpha: how much that is, 0..1

	Cards() { layers.fill(GRASS_NO_CARD); }
	int64_t get_memory_usage() const; // bytes, of the textures
};

// A texture's image in the format of a layer, with mipmaps; null if it has none. Waits for the GPU.
godot::Ref<godot::Image> read_card(const godot::Ref<godot::Texture2D> &p_texture);
bool are_made_of(const Cards &p_cards, std::span<const SpeciesLook> p_looks);
Cards make_cards(std::span<const SpeciesLook> p_looks);

// RGBA16F.
godot::Ref<godot::ImageTexture> make_look_texture(std::span<const SpeciesLook> p_looks, const Cards &p_cards);

} // namespace grass
