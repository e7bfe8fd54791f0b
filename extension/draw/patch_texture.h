// SPDX-License-Identifier: MIT
// What both backends draw from: the patch as a texture, and the box around a field's blades.
#pragma once

#include "core/field/field_setup.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/texture2d_array.hpp>

#include <memory>

namespace grass {

// Returns RGBA16F, Patch::WIDTH x Patch::HEIGHT for each species, without mipmaps.
godot::Ref<godot::Image> make_patch_image(const Patch &p_patch);
// Returns the texture that all fields with this patch share: two megabytes for each species. Main thread only.
godot::Ref<godot::ImageTexture> patch_texture(const std::shared_ptr<const Patch> &p_patch);

// Returns RGBA8, GRASS_LATTICE_CELLS on each side: the numbers that [Eq B1] blends, for the draw shaders. All fields share it; the first
// call makes it, and it is kept until the extension ends.
godot::Ref<godot::ImageTexture> lattice_texture();
// Returns RGBA8 with mipmaps, GRASS_LEAF_PICTURES layers of make_leaf_picture(). Shared and kept in the same way.
godot::Ref<godot::Texture2DArray> leaf_textures();
void free_shared_textures();

// Returns the ShaderFeatures for which the shaders of the field's blades are compiled.
int shader_features(const FieldSetup &p_setup);

// Returns the box around all blades of the field at rest and in wind, field space, metres. p_cover: null on level ground.
godot::AABB field_bounds(const FieldSetup &p_setup, const TileCover *p_cover = nullptr);

} // namespace grass
