// SPDX-License-Identifier: MIT
// What both backends draw from: the patch as a texture, and the box around a field's blades.
#pragma once

#include "core/field/field_setup.h"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/image_texture.hpp>

namespace grass {

// RGBA16F, Patch::WIDTH x Patch::HEIGHT for each species, without mipmaps.
godot::Ref<godot::Image> make_patch_image(const Patch &p_patch);
godot::Ref<godot::ImageTexture> make_patch_texture(const Patch &p_patch);
void update_patch_texture(const godot::Ref<godot::ImageTexture> &p_texture, const Patch &p_patch);

// RGBA8, GRASS_LATTICE_CELLS a side: the numbers that [Eq B1] blends, for the shaders that draw. One for all
// fields, made by the first call and kept until the extension ends.
godot::Ref<godot::ImageTexture> lattice_texture();
void free_shared_textures();

// The ShaderFeatures that the shaders of the field's blades are compiled for.
int shader_features(const FieldSetup &p_setup);

// Box around all blades of the field at rest and in wind, field space, metres. p_cover: null on level ground.
godot::AABB field_bounds(const FieldSetup &p_setup, const TileCover *p_cover = nullptr);

} // namespace grass
