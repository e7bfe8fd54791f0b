// SPDX-License-Identifier: MIT
// Reads all pictures that users give, textures and images, with the same limit for all.
#pragma once

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/variant/color.hpp>
#include <godot_cpp/variant/string.hpp>

namespace grass {

// Texels along a side. What reads a picture takes up to 16 bytes a texel for a moment: 1 GB.
inline constexpr int64_t PICTURE_SIDE_MAX = 8192;

// Returns a copy that is not compressed. Returns null without a picture, or if it cannot be read: then r_problem gives the cause and the
// remedy, worded to follow the picture's name in a message. p_picture: as Texture2D.get_image() returns it, which may be the
// texture's own, and null.
godot::Ref<godot::Image> read_picture(const godot::Ref<godot::Image> &p_picture, godot::String &r_problem);

// Returns the mean colour of the texels with an alpha of p_scissor and more, linear; alpha: their share, 0..1. Looks at p_steps texels
// along each side.
godot::Color mean_color(const godot::Ref<godot::Image> &p_image, int p_steps, float p_scissor);

} // namespace grass
