// SPDX-License-Identifier: MIT
// What both backends draw from: the patch as a texture, and the box around a field's blades.
#pragma once

#include "core/field/field_setup.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>
#include <godot_cpp/classes/texture2d_array.hpp>

#include <memory>

namespace grass {

// RGBA16F, Patch::WIDTH x Patch::HEIGHT for each species, without mipmaps.
godot::Ref<godot::Image> make_patch_image(const Patch &p_patch);
// One for all fields that have the patch: two megabytes a species. Main thread only.
godot::Ref<godot::ImageTexture> patch_texture(const std::shared_ptr<const Patch> &p_patch);

// RGBA8, GRASS_LATTICE_CELLS a side: the numbers that [Eq B1] blends, for the shaders that draw. One for all
// fields, made by the first call and kept until the extension ends.
godot::Ref<godot::ImageTexture> lattice_texture();
// RGBA8 with mipmaps, GRASS_LEAF_PICTURES layers of make_leaf_picture(). Likewise.
godot::Ref<godot::Texture2DArray> leaf_textures();
void free_shared_textures();

// The ShaderFeatures that the shaders of the field's blades are compiled for.
int shader_features(const FieldSetup &p_setup);

// Box around all blades of the field at rest and in wind, field space, metres. p_cover: null on level ground.
godot::AABB field_bounds(const FieldSetup &p_setup, const TileCover *p_cover = nullptr);

} // namespace grass
