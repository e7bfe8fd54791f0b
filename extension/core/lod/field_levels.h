// SPDX-License-Identifier: MIT
// Which levels of detail the tiles of a field can have, by its box and its cameras alone. A field is drawn with meshes that have only
// these, since the renderer pays for each surface in each pass, drawn or not (docs/history/0099-only-levels-that-can-be-seen.md).
#pragma once

#include "core/lod/cull.h"

namespace grass {

// Returns a set of levels such that each tile that p_view's cameras may see has one of them, or is drawn the same with one of more blades.
// Where the cameras look does not matter for the picture: they may turn at any time. p_ground: see TileCover::get_extremes().
LevelSet find_levels(const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground = TileCover::FULL);

// Returns the levels, out of p_all, for which a mesh should have surfaces. p_now: the levels for which it has surfaces. They stay if they
// are not many more than p_needed: a camera at the border between two sets must not change meshes in every frame.
LevelSet find_surfaces(LevelSet p_now, LevelSet p_needed, LevelSet p_all);

// Returns whether a camera is within p_distance metres of a root.
bool is_within(const CullField &p_field, const FieldView &p_view, const TileCover::Tile &p_ground, float p_distance);

} // namespace grass
