// SPDX-License-Identifier: MIT
// The mesh of a tile at each level of detail: indices only. The shaders find level, blade, row and side in VERTEX_ID
// (contract in shaders/draw/pose.gdshaderinc), so the mesh holds no vertex data.
#pragma once

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/material.hpp>

namespace grass {

int lod_blades(int p_level); // blades in the level's mesh
int lod_segments(int p_level); // segments a blade
// Quads, one triangle at the tip and, in fields with cards, where they are not too small to see, a card.
int lod_triangles_per_blade(int p_level, bool p_cards);

// Adds the level's mesh as one more surface of p_mesh.
void add_lod_surface(const godot::Ref<godot::ArrayMesh> &p_mesh, int p_level, const godot::Ref<godot::Material> &p_material, bool p_cards);

// Of the meshes of all levels: their 32-bit indices.
int64_t mesh_bytes(bool p_cards);

} // namespace grass
