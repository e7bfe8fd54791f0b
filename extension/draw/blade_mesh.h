// SPDX-License-Identifier: MIT
// The mesh of a tile at each level of detail, which has indices only. The shaders derive level, blade, row and side from VERTEX_ID
// (contract in shaders/draw/pose.gdshaderinc), so the mesh needs no vertex data.
#pragma once

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/material.hpp>

namespace grass {

int lod_blades(int p_level); // blades in the level's mesh
int lod_segments(int p_level); // segments of each blade
// Counts quads, one triangle at the tip and, in fields with cards, a card at levels where cards are large enough to see.
int lod_triangles_per_blade(int p_level, bool p_cards);

// Appends the level's mesh to p_mesh as a surface.
void add_lod_surface(const godot::Ref<godot::ArrayMesh> &p_mesh, int p_level, const godot::Ref<godot::Material> &p_material, bool p_cards);

// Returns the bytes of the 32-bit indices in the meshes of all levels.
int64_t mesh_bytes(bool p_cards);

} // namespace grass
