// SPDX-License-Identifier: MIT
// The look of a field's species, as a texture for the blade shader: a row for each species, GRASS_LOOK_TEXELS wide.
#pragma once

#include "core/base/layout.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/texture2d.hpp>
#include <godot_cpp/classes/texture2d_array.hpp>
#include <godot_cpp/variant/color.hpp>

#include <array>
#include <span>
#include <vector>

namespace grass {

struct SpeciesLook {
	std::array<godot::Color, GRASS_LOOK_COLORS> colors; // from root to tip, linear
	godot::Color dry_color; // linear
	float dry = 0.0f; // share of dryness in tips and light clumps
	float hue_variation = 0.0f; // HUE_VARIATION
	std::vector<godot::Ref<godot::Image>> card; // flowers or seed heads at the tip, from read_card(); empty: none
	godot::Color card_color; // multiplies the card's colours, linear
	float card_share = 0.0f; // of the blades
	float card_width = 0.0f, card_height = 0.0f; // metres
	float card_flatness = 0.0f; // 0: it faces the eye; 1: it lies across the tip
	godot::Ref<godot::Image> leaf; // at the tip of blades without a flower, from read_card(); null: none
	float leaf_size = 0.0f; // metres
	float leaf_width = 0.0f; // width_of_leaf() of the mean blade, metres
	float blade_area = 0.0f; // area that a mean blade covers with its leaf, m^2
	float canopy_among_others = 0.0f, canopy_alone = 0.0f; // metres; at this height a blade is as bright as its tip
};

// The cards and leaves of species as the layers of one texture, RGBA8, Cards::SIDE texels on each side, and what looks read of them.
struct Cards {
	static constexpr int SIDE = 256; // texels
	struct Seen {
		int layer = GRASS_NO_CARD; // the first of its pictures
		int pictures = 0;
		godot::Color color; // linear, mean of the opaque texels; alpha: their share, 0..1
	};
	std::vector<godot::Ref<godot::Image>> images; // one for each layer
	godot::Ref<godot::Texture2DArray> textures; // null: none
	std::array<Seen, GRASS_MAX_SPECIES> flowers, leaves;

	int64_t get_memory_usage() const; // bytes, of the textures
};

// Returns the mean colour of the opaque texels, linear; alpha: their share, 0..1. p_image: from read_card().
godot::Color mean_color(const godot::Ref<godot::Image> &p_image);
// Returns the pictures that lie side by side in a texture, in the format of a layer, with mipmaps; none if it has no image. Waits for the
// GPU. p_who: begins a message about the texture.
std::vector<godot::Ref<godot::Image>> read_card(const godot::Ref<godot::Texture2D> &p_texture, int p_pictures, const godot::String &p_who);
bool are_made_of(const Cards &p_cards, std::span<const SpeciesLook> p_looks);
Cards make_cards(std::span<const SpeciesLook> p_looks);

// Returns RGBA16F.
godot::Ref<godot::ImageTexture> make_look_texture(std::span<const SpeciesLook> p_looks, const Cards &p_cards);

} // namespace grass
