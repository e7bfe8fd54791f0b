// SPDX-License-Identifier: MIT
// The mesh of a tile at each level of detail, which has indices only. The shaders derive level, blade, row and side from VERTEX_ID
// (contract in shaders/draw/pose.gdshaderinc), so the mesh needs no vertex data.
#pragma once

#include "core/lod/lod.h"

#include <godot_cpp/classes/array_mesh.hpp>

#include <memory>

namespace grass {

int lod_blades(int p_level); // blades in the level's mesh
int lod_segments(int p_level); // segments of each blade
// Counts quads, one triangle at the tip and, in fields with cards, a card at levels where cards are large enough to see.
int lod_triangles_per_blade(int p_level, bool p_cards);

// A mesh that instances share, without materials of its own.
using SharedMesh = std::shared_ptr<const godot::Ref<godot::ArrayMesh>>;

// Returns the mesh with these levels as its surfaces, which must be some. All fields share it.
SharedMesh shared_blade_mesh(LevelSet p_levels, bool p_cards);

// Returns the bytes of the 32-bit indices of these levels.
int64_t mesh_bytes(LevelSet p_levels, bool p_cards);

} // namespace grass
